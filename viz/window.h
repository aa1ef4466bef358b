// The viewer's window: panes around one controller.
#pragma once

#include <memory>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "viz/image_pane.h"
#include "viz/numbers_pane.h"
#include "viz/scene_pane.h"
#include "viz/strip_pane.h"
#include "viz/style.h"
#include "viz/title_pane.h"

namespace rt::viz
{

class Window
{
public:
    /// Needs a display. `onScreen`: it is shown and can be used.
    Window(Controller& shown, int width, int height, bool onScreen);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Runs until the user quits.
    void run();
    /// What the window shows.
    Image picture();

    // For the interactor style; in pixels of the window.
    ScenePane& scenePane() { return scene; }
    Pane* paneAt(int x, int y);
    void click(int x, int y);
    void drag(int fromX, int fromY, int dx, int dy);
    void wheel(int x, int y, bool forward);
    void key(const std::string& key, bool shift, int x, int y);
    void beginMotion();
    void endMotion();

private:
    Controller& controller;
    TitlePane title;
    ImagePane image;
    NumbersPane numbers;
    ScenePane scene;
    StripPane strip;
    std::vector<Pane*> panes{&title, &image, &numbers, &scene, &strip};
    vtkNew<vtkRenderWindow> window;
    vtkSmartPointer<vtkRenderWindowInteractor> interactor;
    vtkNew<Style> style;
    int width, height;

    void layOut();
    void resized();
    void update(unsigned changes);
    void drawOnly(const std::vector<Pane*>& some);
    /// Draws only these panes; the pixels of the others stay.
    void redraw(const std::vector<Pane*>& some);
    void saveScreenshot();
};

} // namespace rt::viz
