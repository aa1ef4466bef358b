// The viewer's window: panes around one controller.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "viz/base/screen.h"
#include "viz/window/chart_pane.h"
#include "viz/window/code_pane.h"
#include "viz/window/help_pane.h"
#include "viz/window/image_pane.h"
#include "viz/window/numbers_pane.h"
#include "viz/window/scene_pane.h"
#include "viz/window/strip_pane.h"
#include "viz/window/style.h"
#include "viz/window/title_pane.h"
#include "viz/window/tree_pane.h"

namespace rt::viz
{

class Window
{
public:
    /// Needs a display. `onScreen`: it is shown and can be used.
    Window(Controller& shown, const WindowPlace& place, bool onScreen);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Runs until the user quits. Writes what he does to a file, if one is named.
    void run(const std::string& record = {});
    /// Does what such a file says; checkRecording has found it good.
    void replay(const std::string& file);
    /// What the window shows.
    Image picture();
    void resize(int width, int height);
    std::array<int, 2> size() const { return {width, height}; }
    /// Of what is drawn, at least 1: pixels of the window for each pixel of the design.
    double pixelScale() const { return std::max(1.0, drawnScale); }

    /// What key e does, if anything.
    std::function<void()> exportAll;

    // For the interactor style and for scripts; in pixels of the window, y up.
    ScenePane& scenePane() { return scene; }
    Pane* paneAt(int x, int y);
    /// A button goes down; true: the pane takes the drag from the first pixel on, and there will be no click.
    bool press(int x, int y);
    void release();
    void click(int x, int y);
    void drag(int fromX, int fromY, int dx, int dy);
    void hover(int x, int y);
    void wheel(int x, int y, bool forward);
    /// As X names it: "Left", "bracketleft", "a". What it does never depends on where the pointer is.
    void key(const std::string& asTyped, bool shift);
    /// The same; "Shift+Left" is allowed.
    void press(const std::string& keys);
    /// Press, drag and release of the left button.
    void dragFrom(int fromX, int fromY, int toX, int toY);
    void beginMotion();
    void endMotion();
    /// Some ten times a second: playing, and what the background has finished.
    void tick();

private:
    using Clock = std::chrono::steady_clock;

    Controller& controller;
    TitlePane title;
    ImagePane image;
    NumbersPane numbers;
    ScenePane scene;
    CodePane code;
    TreePane tree;
    ChartPane chart;
    StripPane strip;
    HelpPane help;
    std::vector<Pane*> panes{&title, &image, &numbers, &scene, &code, &tree, &chart, &strip, &help}; // as PaneId counts
    vtkNew<vtkRenderWindow> window;
    vtkSmartPointer<vtkRenderWindowInteractor> interactor;
    vtkNew<Style> style;
    int width, height;
    double scale;          // that was asked for, or chosen since by + and -
    double drawnScale = 1; // what the window's size makes of it
    Look dressedFor;
    PaneId whole = PaneId::none;    // enlarged by the user
    PaneId clicked = PaneId::scene; // last: key m begins with it
    LayoutWishes laidOut;
    Pane* under = nullptr;   // the pointer
    std::vector<Pane*> late; // to be drawn, but there was more to do first
    Clock::time_point lastStep, saidAt;

    void name();
    LayoutWishes wishes() const;
    void layOut();
    void resized();
    void dress();
    void update(unsigned changes);
    void drawOnly(const std::vector<Pane*>& some);
    /// Draws only these panes; the pixels of the others stay.
    void redraw(const std::vector<Pane*>& some);
    void redrawIfAsked();
    void setScale(double wanted);
    void enlarge(PaneId pane);
    void enlargeNext();
    void type(const std::string& key);
    void goTo(const std::string& digits);
    void saveScreenshot();
};

} // namespace rt::viz
