// A part of the window: it draws one side of the controller's state.
#pragma once

#include <functional>

#include <vtkContextActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "viz/canvas.h"
#include "viz/controller.h"
#include "viz/layout.h"

namespace rt::viz
{

class Pane
{
public:
    explicit Pane(Controller& watched);
    virtual ~Pane() = default;
    Pane(const Pane&) = delete;
    Pane& operator=(const Pane&) = delete;

    vtkRenderer* renderer() { return view; }
    /// All its renderers, the lowest first.
    virtual std::vector<vtkRenderer*> renderers() { return {view}; }
    /// Gives the pane its place in a window of this size.
    void place(const Rect& rect, int windowWidth, int windowHeight, double contentScale);
    bool contains(int windowX, int windowY) const { return area.contains(windowX, windowY); }

    /// Takes over what has changed (a sum of Change). True if the pane must be drawn again.
    virtual bool update(unsigned changes) = 0;

    /// Mouse events, in pixels of the pane; true if the pane must be drawn again.
    virtual bool click(int, int) { return false; }
    virtual bool drag(int, int) { return false; } ///< by how much
    virtual bool wheel(int, int, bool) { return false; }

protected:
    Controller& controller;
    Rect area;
    double scale = 1;

    virtual void placed() {}
    /// Puts what `paint` draws above another renderer.
    void paintIn(vtkRenderer* other);
    /// Draws the pane, or what lies over its 3D content.
    virtual void paint(Canvas&) {}

private:
    vtkNew<vtkRenderer> view;
    vtkNew<vtkContextActor> overlay;
};

} // namespace rt::viz
