#include "viz/window/style.h"

#include <cmath>

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include "viz/window/window.h"

namespace rt::viz
{

namespace
{
constexpr double clickDistance = 4; // pixels of the design; further is a drag
}

vtkStandardNewMacro(Style);

bool Style::onScene()
{
    return window->paneAt(pressedX, pressedY) == &window->scenePane();
}

void Style::OnLeftButtonDown()
{
    this->Interactor->GetEventPosition(pressedX, pressedY);
    lastX = pressedX;
    lastY = pressedY;
    pressed = true;
    held = window->press(pressedX, pressedY);
    dragging = held;
}

void Style::OnMouseMove()
{
    int x = 0, y = 0;
    this->Interactor->GetEventPosition(x, y);
    if (pressed && !dragging && std::hypot(x - pressedX, y - pressedY) >= clickDistance * window->pixelScale())
    {
        dragging = true;
        if (onScene())
        {
            window->beginMotion();
            this->FindPokedRenderer(pressedX, pressedY);
            if (this->Interactor->GetShiftKey())
                this->StartPan();
            else
                this->StartRotate();
        }
    }
    if (this->State != VTKIS_NONE)
        Superclass::OnMouseMove();
    else if (dragging)
        window->drag(pressedX, pressedY, x - lastX, y - lastY);
    else if (!pressed)
        window->hover(x, y);
    lastX = x;
    lastY = y;
}

void Style::OnLeftButtonUp()
{
    if (pressed && !dragging) window->click(pressedX, pressedY);
    endMotion();
}

void Style::endMotion()
{
    pressed = dragging = false;
    if (held) window->release();
    held = false;
    switch (this->State)
    {
    case VTKIS_ROTATE:
        this->EndRotate();
        break;
    case VTKIS_PAN:
        this->EndPan();
        break;
    case VTKIS_DOLLY:
        this->EndDolly();
        break;
    default:
        return;
    }
    window->endMotion();
}

void Style::OnMiddleButtonDown()
{
    this->Interactor->GetEventPosition(pressedX, pressedY);
    lastX = pressedX;
    lastY = pressedY;
    if (onScene())
    {
        window->beginMotion();
        this->FindPokedRenderer(pressedX, pressedY);
        this->StartPan();
    }
    else
        pressed = dragging = true;
}

void Style::OnMiddleButtonUp()
{
    endMotion();
}

void Style::OnRightButtonDown()
{
    this->Interactor->GetEventPosition(pressedX, pressedY);
    if (!onScene()) return;
    window->beginMotion();
    this->FindPokedRenderer(pressedX, pressedY);
    this->StartDolly();
}

void Style::OnRightButtonUp()
{
    endMotion();
}

void Style::OnMouseWheelForward()
{
    int x = 0, y = 0;
    this->Interactor->GetEventPosition(x, y);
    window->wheel(x, y, true);
}

void Style::OnMouseWheelBackward()
{
    int x = 0, y = 0;
    this->Interactor->GetEventPosition(x, y);
    window->wheel(x, y, false);
}

void Style::OnKeyPress()
{
    // Who copies with Ctrl+C does not mean key c.
    if (this->Interactor->GetControlKey() || this->Interactor->GetAltKey()) return;
    const char* key = this->Interactor->GetKeySym();
    window->key(key ? key : "", this->Interactor->GetShiftKey() != 0);
}

void Style::OnKeyRelease()
{
    // Otherwise it would be said of all that the mouse does next.
    this->Interactor->SetKeySym(nullptr);
}

void Style::OnTimer()
{
    window->tick();
}

} // namespace rt::viz
