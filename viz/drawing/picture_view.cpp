#include "viz/drawing/picture_view.h"

#include <algorithm>
#include <cmath>

namespace rt::viz
{

double fromSrgb8(unsigned char value)
{
    const double x = value / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

ScreenPicture::ScreenPicture(const Image& image) : ScreenPicture(image.width, image.height)
{
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = {toSrgb8(image.pixels[i].x), toSrgb8(image.pixels[i].y), toSrgb8(image.pixels[i].z)};
}

namespace
{

/// The mean over [x0, x1) x [y0, y1), from at most 4 x 4 of its pixels.
Rgba mean(const ScreenPicture& picture, double x0, double y0, double x1, double y1)
{
    const int nx = std::clamp(int(std::ceil(x1 - x0)), 1, 4), ny = std::clamp(int(std::ceil(y1 - y0)), 1, 4);
    int r = 0, g = 0, b = 0;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
        {
            const int x = std::clamp(int(x0 + (x1 - x0) * (i + 0.5) / nx), 0, picture.width - 1);
            const int y = std::clamp(int(y0 + (y1 - y0) * (j + 0.5) / ny), 0, picture.height - 1);
            const Rgba& p = picture.at(x, y);
            r += p.r;
            g += p.g;
            b += p.b;
        }
    const auto channel = [n = nx * ny](int sum) { return static_cast<unsigned char>((sum + n / 2) / n); };
    return {channel(r), channel(g), channel(b)};
}

} // namespace

ScreenPicture ScreenPicture::reduced(int side) const
{
    if (pixels.empty()) return *this;
    const double factor = std::max(1.0, double(std::max(width, height)) / side);
    ScreenPicture small(std::max(1, int(width / factor)), std::max(1, int(height / factor)));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            small.pixels[std::size_t(y) * std::size_t(small.width) + std::size_t(x)] =
                mean(*this, double(x) * width / small.width, double(y) * height / small.height,
                     double(x + 1) * width / small.width, double(y + 1) * height / small.height);
    return small;
}

void PictureView::fit(int pictureWidth, int pictureHeight, int paneWidth, int paneHeight, int margin)
{
    width = pictureWidth;
    height = pictureHeight;
    paneWidth_ = paneWidth;
    paneHeight_ = paneHeight;
    zoomed = false;
    const double availableX = std::max(1, paneWidth - 2 * margin), availableY = std::max(1, paneHeight - 2 * margin);
    pixelsPerPixel = fittedZoom = std::min(availableX / width, availableY / height);
    left = std::round((paneWidth - width * pixelsPerPixel) / 2);
    top = std::round((paneHeight + height * pixelsPerPixel) / 2);
}

void PictureView::resize(int pictureWidth, int pictureHeight, int paneWidth, int paneHeight, int margin)
{
    if (!zoomed || pictureWidth != width || pictureHeight != height)
        return fit(pictureWidth, pictureHeight, paneWidth, paneHeight, margin);
    left += (paneWidth - paneWidth_) / 2.0;
    top += (paneHeight - paneHeight_) / 2.0;
    paneWidth_ = paneWidth;
    paneHeight_ = paneHeight;
}

void PictureView::zoomAt(double factor, double paneX, double paneY)
{
    const auto fixed = toPicture(paneX, paneY);
    pixelsPerPixel = std::clamp(pixelsPerPixel * factor, std::min(fittedZoom, 1.0) / 2, std::max(fittedZoom, 64.0));
    left = paneX - fixed[0] * pixelsPerPixel;
    top = paneY + fixed[1] * pixelsPerPixel;
    zoomed = true;
}

void PictureView::pan(double dx, double dy)
{
    left += dx;
    top += dy;
    zoomed = true;
}

std::array<double, 2> PictureView::toPane(double x, double y) const
{
    return {left + x * pixelsPerPixel, top - y * pixelsPerPixel};
}

std::array<double, 2> PictureView::toPicture(double paneX, double paneY) const
{
    return {(paneX - left) / pixelsPerPixel, (top - paneY) / pixelsPerPixel};
}

std::optional<std::array<int, 2>> PictureView::pixelAt(double paneX, double paneY) const
{
    const auto [x, y] = toPicture(paneX, paneY);
    if (!(x >= 0 && y >= 0 && x < width && y < height)) return std::nullopt;
    return std::array<int, 2>{int(x), int(y)};
}

std::vector<Rgba> PictureView::sample(const ScreenPicture& picture) const
{
    std::vector<Rgba> shown(std::size_t(paneWidth_) * std::size_t(paneHeight_), Rgba{0, 0, 0, 0});
    const double half = 0.5 / pixelsPerPixel;
    for (int py = 0; py < paneHeight_; ++py)
        for (int px = 0; px < paneWidth_; ++px)
        {
            const auto pixel = pixelAt(px + 0.5, py + 0.5);
            if (!pixel) continue;
            const auto [x, y] = toPicture(px + 0.5, py + 0.5);
            shown[std::size_t(py) * std::size_t(paneWidth_) + std::size_t(px)] =
                pixelsPerPixel >= 1 ? picture.at((*pixel)[0], (*pixel)[1])
                                    : mean(picture, x - half, y - half, x + half, y + half);
        }
    return shown;
}

} // namespace rt::viz
