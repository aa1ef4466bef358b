// A part of the window: it draws one side of the controller's state.
#pragma once

#include <functional>
#include <utility>

#include <vtkContextActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "viz/base/layout.h"
#include "viz/state/controller.h"
#include "viz/window/canvas.h"

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
    /// False in a window with no room for it.
    bool isPlaced() const { return !area.isEmpty(); }
    /// Takes over the look's colours; the window calls it before `update`.
    virtual void dress();

    /// Takes over what has changed (a sum of Change). True if the pane must be drawn again.
    virtual bool update(unsigned changes) = 0;

    /// Mouse events, in pixels of the pane; true if the pane must be drawn again.
    virtual bool click(int, int) { return false; }
    /// The left or middle button was pressed here; true: the pane wants the drag that may follow (a slider, say).
    virtual bool press(int, int) { return false; }
    virtual bool drag(int, int) { return false; } ///< by how much
    virtual void release() {}
    /// The pointer moves over the pane with no button down. What it is above is told to the controller.
    virtual void hover(int, int) {}
    virtual void leave() {}
    virtual bool wheel(int, int, bool) { return false; }
    /// Did `hover` or `leave` change what the pane shows? Asked once.
    bool wantsDrawing() { return std::exchange(asked, false); }

protected:
    Controller& controller;
    Rect area{0, 0, 1, 1};
    double scale = 1;

    virtual void placed() {}
    void askForDrawing() { asked = true; }
    void setBackground(const Rgba& background);
    /// Puts what `paint` draws above another renderer.
    void paintIn(vtkRenderer* other);
    /// The lines towards the panes at the right and above.
    void paintEdges(Canvas& canvas);
    /// Draws the pane, or what lies over its 3D content.
    virtual void paint(Canvas&) {}

private:
    vtkNew<vtkRenderer> view;
    vtkNew<vtkContextActor> overlay;
    bool asked = false;
};

} // namespace rt::viz
