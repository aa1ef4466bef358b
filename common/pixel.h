// From a tracer to pixels, without threads: render.h does the same on many, and gets the same bits.
#pragma once

#include <atomic>

#include "common/image.h"
#include "common/scene.h"
#include "common/todo.h"

namespace rt
{

/// Where sample `index` of a pixel lies in it, in [0, 1)². The R2 sequence (Roberts 2018), whose first point is the centre.
template <std::floating_point Real>
std::array<Real, 2> samplePosition(int index)
{
    if (index == 0) return {Real(0.5), Real(0.5)};
    const auto fraction = [index](Real step) {
        const Real x = Real(0.5) + Real(index) * step;
        return x - std::floor(x);
    };
    return {fraction(Real(0.75487766624669276005L)), fraction(Real(0.56984029099805326591L))};
}

/// The colour of pixel (px, py): the mean of its samples.
template <class Tracer, std::floating_point Real>
Vec3<Real> renderPixel(const Scene<Real>& scene, Tracer& tracer, int px, int py, int spp)
{
    Vec3<Real> sum(0);
    for (int i = 0; i < spp; ++i)
    {
        const auto [x, y] = samplePosition<Real>(i);
        sum += tracer.trace(scene.camera.ray(Real(px) + x, Real(py) + y));
    }
    return spp == 1 ? sum : sum / Real(spp);
}

/// Pictures are rendered in squares, row by row from the top left; each one has a tracer of its own.
inline constexpr int tileSide = 32;

/// How many there are.
inline int tilesOf(const Image& image)
{
    return ((image.width + tileSide - 1) / tileSide) * ((image.height + tileSide - 1) / tileSide);
}

/// Some of a picture's pixels: those whose x and y are multiples of `every`, but not of `traced`, which an earlier pass had.
struct Pass
{
    int every = 1;
    int traced = 0; ///< a multiple of `every`; 0: there was no earlier pass

    bool had(int x, int y) const { return traced && x % traced == 0 && y % traced == 0; }
    int firstFrom(int start) const { return (start + every - 1) / every * every; }
};

/// Renders one of them, or a pass of it; a pixel whose exercise is not attempted is magenta. Returns early once `stop` is set.
template <class Tracer, std::floating_point Real>
void renderTile(Image& image, int tile, const Scene<Real>& scene, int spp, const Pass& pass = {},
                const std::atomic<bool>* stop = nullptr)
{
    Tracer tracer{scene};
    const int columns = (image.width + tileSide - 1) / tileSide;
    const int left = tile % columns * tileSide, top = tile / columns * tileSide;
    for (int y = pass.firstFrom(top); y < std::min(top + tileSide, image.height); y += pass.every)
        for (int x = pass.firstFrom(left); x < std::min(left + tileSide, image.width); x += pass.every) try
            {
                if (pass.had(x, y)) continue;
                if (stop && *stop) return;
                image.at(x, y) = Vec3<double>(renderPixel(scene, tracer, x, y, spp));
            }
            catch (const NotAttempted&)
            {
                image.at(x, y) = magenta;
            }
}

/// The whole picture, on this thread, one sample a pixel.
template <class Tracer, std::floating_point Real>
Image renderAlone(const Scene<Real>& scene, int width, int height)
{
    Image image(width, height);
    for (int tile = 0; tile < tilesOf(image); ++tile) renderTile<Tracer>(image, tile, scene, 1);
    return image;
}

} // namespace rt
