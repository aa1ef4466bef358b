#include "viz/window/image_pane.h"

#include <cmath>

namespace rt::viz
{

namespace
{

/// A source without pictures has an empty frame, in which pixels can be chosen all the same.
ScreenPicture shownPicture(const Controller& controller)
{
    const auto& camera = controller.scene().camera;
    if (controller.picture().width > 0) return ScreenPicture(controller.picture());
    Image frame(camera.width, camera.height);
    const auto& grey = color::panelRaised;
    for (auto& pixel : frame.pixels) pixel = {fromSrgb8(grey.r), fromSrgb8(grey.g), fromSrgb8(grey.b)};
    return ScreenPicture(frame);
}

} // namespace

ImagePane::ImagePane(Controller& watched) : Pane(watched), picture(shownPicture(watched))
{
    dress();
}

void ImagePane::dress()
{
    setBackground(color::window);
}

bool ImagePane::update(unsigned changes)
{
    if (changes & (changedPicture | changedPass | changedScene))
    {
        picture = shownPicture(controller);
        if (isPlaced()) placed();
    }
    return changes & (changedPicture | changedPass | changedTree | changedShare);
}

void ImagePane::placed()
{
    view.resize(picture.width, picture.height, area.width, area.height, margin());
    resample();
}

void ImagePane::fit()
{
    view.fit(picture.width, picture.height, area.width, area.height, margin());
    resample();
}

void ImagePane::resample()
{
    const auto pixels = view.sample(picture);
    shown->SetDimensions(area.width, area.height, 1);
    shown->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* out = static_cast<unsigned char*>(shown->GetScalarPointer());
    for (const auto& p : pixels)
    {
        *out++ = p.r;
        *out++ = p.g;
        *out++ = p.b;
        *out++ = p.a;
    }
    shown->Modified();
}

bool ImagePane::click(int x, int y)
{
    if (const auto pixel = view.pixelAt(x + 0.5, y + 0.5)) controller.choosePixel((*pixel)[0], (*pixel)[1]);
    return false; // the controller says what has changed
}

bool ImagePane::drag(int dx, int dy)
{
    view.pan(dx, dy);
    resample();
    return true;
}

bool ImagePane::wheel(int x, int y, bool forward)
{
    view.zoomAt(forward ? 1.25 : 0.8, x, y);
    resample();
    return true;
}

void ImagePane::paint(Canvas& canvas)
{
    canvas.image(0, 0, shown);
    if (const auto pixel = controller.pixel())
    {
        // The pixel's own square, at least a few screen pixels wide, and a line to each side that leaves it free.
        const auto [x, y] = *pixel;
        const auto a = view.toPane(x, y + 1), b = view.toPane(x + 1, y);
        const double cx = (a[0] + b[0]) / 2, cy = (a[1] + b[1]) / 2;
        const double half = std::max((b[0] - a[0]) / 2 + canvas.hair(), canvas.px(4)), reach = half + canvas.px(22);
        for (const double width : {3.0, 1.0})
        {
            const Rgba ink = width > 2 ? Rgba{0, 0, 0, 150} : Rgba{255, 255, 255, 240};
            const double w = std::round(canvas.px(width)), near = half, far = reach;
            canvas.fill({cx - far, cy - w / 2, far - near, w}, ink);
            canvas.fill({cx + near, cy - w / 2, far - near, w}, ink);
            canvas.fill({cx - w / 2, cy - far, w, far - near}, ink);
            canvas.fill({cx - w / 2, cy + near, w, far - near}, ink);
        }
        canvas.frame({cx - half, cy - half, 2 * half, 2 * half}, std::max(1.0, std::round(canvas.px(1.4))),
                     colorOf(RayRole::camera));
    }
    // The picture is not final yet.
    if (const double done = controller.painted(); done < 1)
    {
        canvas.fill({0, 0, double(area.width), canvas.px(3)}, color::line);
        canvas.fill({0, 0, area.width * done, canvas.px(3)}, color::accent);
    }
    canvas.fill({area.width - canvas.hair(), 0, canvas.hair(), double(area.height)}, color::line);
}

} // namespace rt::viz
