// Mouse and keys, handed to the pane under the pointer. All of VTK's own keys are consumed: several do harm. Nothing is
// done with Ctrl or Alt.
#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

namespace rt::viz
{

class Window;

class Style : public vtkInteractorStyleTrackballCamera
{
public:
    static Style* New();
    vtkTypeMacro(Style, vtkInteractorStyleTrackballCamera);

    Window* window = nullptr;

    void OnLeftButtonDown() override;
    void OnLeftButtonUp() override;
    void OnMiddleButtonDown() override;
    void OnMiddleButtonUp() override;
    void OnRightButtonDown() override;
    void OnRightButtonUp() override;
    void OnMouseMove() override;
    void OnMouseWheelForward() override;
    void OnMouseWheelBackward() override;
    void OnKeyPress() override;
    void OnKeyRelease() override;
    void OnKeyDown() override {}
    void OnKeyUp() override {}
    void OnChar() override {}
    // The default moves the camera on every timer event, whoever asked for the timer.
    void OnTimer() override;

private:
    int pressedX = 0, pressedY = 0, lastX = 0, lastY = 0;
    bool pressed = false, dragging = false;
    bool held = false; // the pane took the press: no click follows

    bool onScene();
    void endMotion();
};

} // namespace rt::viz
