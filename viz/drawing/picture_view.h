// How the picture lies in its pane: zoom, position, and which pixel is under the pointer.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "common/base/image.h"
#include "viz/base/layout.h"
#include "viz/base/palette.h"

namespace rt::viz
{

/// A picture as the screen shows it: row by row from the top left.
struct ScreenPicture
{
    int width = 0, height = 0;
    std::vector<Rgba> pixels;

    explicit ScreenPicture(const Image& image);
    const Rgba& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }

    /// The same at most `side` pixels wide and high, each pixel the mean of those it stands for.
    ScreenPicture reduced(int side) const;

private:
    ScreenPicture(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
};

/// The linear value that toSrgb8 turns into this one again.
double fromSrgb8(unsigned char value);

/// Pane coordinates are pixels with y up from the pane's lower left; picture coordinates are pixels with y down.
class PictureView
{
public:
    /// Shows the whole picture in the middle of the pane, as large as it fits.
    void fit(int pictureWidth, int pictureHeight, int paneWidth, int paneHeight, int margin);
    /// The pane changed its size: fits again unless the user has zoomed.
    void resize(int pictureWidth, int pictureHeight, int paneWidth, int paneHeight, int margin);
    /// Zooms about a point of the pane, which stays where it is.
    void zoomAt(double factor, double paneX, double paneY);
    void pan(double dx, double dy);

    /// Screen pixels for each pixel of the picture.
    double zoom() const { return pixelsPerPixel; }
    std::array<double, 2> toPane(double x, double y) const;
    std::array<double, 2> toPicture(double paneX, double paneY) const;
    /// The pixel under a point of the pane; empty beside the picture.
    std::optional<std::array<int, 2>> pixelAt(double paneX, double paneY) const;

    /// What the pane shows, row by row from its LOWER left: nearest pixel when magnified, a mean when reduced; transparent
    /// beside the picture.
    std::vector<Rgba> sample(const ScreenPicture& picture) const;

private:
    int width = 1, height = 1, paneWidth_ = 1, paneHeight_ = 1;
    double pixelsPerPixel = 1, fittedZoom = 1;
    double left = 0, top = 0; // pane coordinates of the picture's top left corner
    bool zoomed = false;
};

} // namespace rt::viz
