// From a tracer to pixels, without threads: render.h does the same on many, and gets the same bits.
#pragma once

#include <atomic>

#include "common/base/image.h"
#include "common/base/todo.h"
#include "common/scene/scene.h"

namespace rt
{

/// Where sample `index` of a pixel lies in it, in [0, 1)². The R2 sequence (Roberts 2018), whose first point is the centre.
/// In double at least: float would have lost the digits behind the point of a large index.
template <std::floating_point Real>
std::array<Real, 2> samplePosition(int index)
{
    if (index == 0) return {Real(0.5), Real(0.5)};
    using Number = Wide<Real>;
    const auto fraction = [index](Number step) {
        const Number x = Number(0.5) + Number(index) * step;
        return std::min(Real(x - std::floor(x)), 1 - std::numeric_limits<Real>::epsilon() / 2);
    };
    return {fraction(Number(0.75487766624669276005L)), fraction(Number(0.56984029099805326591L))};
}

/// The ray of sample `index` of pixel (px, py).
template <std::floating_point Real>
Ray<Real> sampleRay(const Scene<Real>& scene, int px, int py, int index)
{
    const auto [x, y] = samplePosition<Real>(index);
    return scene.camera.ray(Real(px) + x, Real(py) + y);
}

/// The colour of pixel (px, py): the mean of its samples, whose rays are rayOf(px, py, index). float sums in double, so that the
/// mean of many samples is as right as one.
template <std::floating_point Real, class Tracer, class RayOf>
[[gnu::always_inline]] inline Vec3<Real> renderSamples(Tracer& tracer, int px, int py, int spp, RayOf&& rayOf)
{
    Vec3<Wide<Real>> sum(0);
    for (int i = 0; i < spp; ++i)
    {
        beginCameraRay();
        sum += Vec3<Wide<Real>>(tracer.trace(rayOf(px, py, i)));
    }
    return Vec3<Real>(spp == 1 ? sum : sum / Wide<Real>(spp));
}

/// The same, for one pixel alone.
template <class Tracer, std::floating_point Real>
Vec3<Real> renderPixel(const Scene<Real>& scene, Tracer& tracer, int px, int py, int spp)
{
    return renderSamples<Real>(tracer, px, py, spp, [&](int x, int y, int i) { return sampleRay(scene, x, y, i); });
}

/// Pictures are rendered in squares, row by row from the top left; each one has a tracer of its own.
inline constexpr int tileSide = 32;

/// The rays of a tile's samples. If these are asked for one after the other, what they meet is found for as many at once as a
/// row has, where that is worth it.
template <std::floating_point Real>
class TileRays
{
public:
    TileRays(const Scene<Real>& s, int l, int r, int samples, bool inOrder)
        : scene(s), left(l), right(r), spp(samples), looks(inOrder && s.wantsLookAhead())
    {
    }

    /// The next in order, or any one after restart().
    Ray<Real> operator()(int px, int py, int index)
    {
        if (looks && next == most) fill(px, py, index);
        if (!looks) return sampleRay(scene, px, py, index);
        const auto& ahead = found[next++];
        return {.O = ahead.O, .D = ahead.D, .ahead = &ahead};
    }

    void restart() { next = most; }

private:
    void fill(int px, int py, int index)
    {
        for (auto& ahead : found)
        {
            const auto ray = sampleRay(scene, px, py, index);
            ahead.O = ray.O;
            ahead.D = ray.D;
            if (++index < spp) continue;
            index = 0;
            if (++px == right) px = left, ++py; // nobody asks for those below the tile
        }
        next = 0;
        try
        {
            scene.lookAhead(found, most);
        }
        catch (const NotAttempted&)
        {
            looks = false; // in exercise 01, which has formulas of its own
        }
    }

    static constexpr int most = tileSide;

    const Scene<Real>& scene;
    int left, right, spp;
    bool looks;
    int next = most;
    Ahead<Real> found[most];
};

/// How many tiles there are.
inline int tilesOf(const Image& image)
{
    return ((image.width + tileSide - 1) / tileSide) * ((image.height + tileSide - 1) / tileSide);
}

/// Some of a picture's pixels: those whose x and y are multiples of `every`, but not of `traced`, which an earlier pass had.
struct Pass
{
    int every = 1;
    int traced = 0; ///< a multiple of `every`; 0: there was no earlier pass

    bool isWhole() const { return every == 1 && !traced; }
    bool had(int x, int y) const { return traced && x % traced == 0 && y % traced == 0; }
    int firstFrom(int start) const { return (start + every - 1) / every * every; }
};

/// Renders one of them, or a pass of it; a pixel whose exercise is not attempted is magenta. Returns early once `stop` is set,
/// and between rows once `ended` is. Throws TooManyRays, with the pixel.
template <class Tracer, std::floating_point Real>
void renderTile(Image& image, int tile, const Scene<Real>& scene, int spp, const Pass& pass = {},
                const std::atomic<bool>* stop = nullptr, const std::atomic<bool>* ended = nullptr)
{
    const TraceLimit limit(stop);
    Tracer tracer{scene};
    const int columns = (image.width + tileSide - 1) / tileSide;
    const int left = tile % columns * tileSide, top = tile / columns * tileSide;
    const int right = std::min(left + tileSide, image.width), bottom = std::min(top + tileSide, image.height);
    TileRays<Real> rays(scene, left, right, spp, pass.isWhole());
    for (int y = pass.firstFrom(top); y < bottom && !(ended && *ended); y += pass.every)
        for (int x = pass.firstFrom(left); x < right; x += pass.every) try
            {
                if (pass.had(x, y)) continue;
                image.at(x, y) = Vec3<double>(renderSamples<Real>(tracer, x, y, spp, rays));
            }
            catch (const NotAttempted&)
            {
                image.at(x, y) = magenta;
                rays.restart();
            }
            catch (const Stopped&)
            {
                return;
            }
            catch (const TooManyRays&)
            {
                throw TooManyRays(pixelText(x, y), scene.settings.maxDepth);
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
