// The rendered picture with a cross-hair on the chosen pixel.
#pragma once

#include "viz/drawing/picture_view.h"
#include "viz/window/pane.h"

namespace rt::viz
{

class ImagePane : public Pane
{
public:
    explicit ImagePane(Controller& watched);
    bool update(unsigned changes) override;
    void dress() override;
    bool click(int x, int y) override;
    bool drag(int dx, int dy) override;
    bool wheel(int x, int y, bool forward) override;
    void fit();

private:
    ScreenPicture picture;
    PictureView view;
    vtkNew<vtkImageData> shown;

    void placed() override;
    void paint(Canvas& canvas) override;
    void resample();
    int margin() const { return int(10 * scale); }
};

} // namespace rt::viz
