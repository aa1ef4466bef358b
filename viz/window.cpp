#include "viz/window.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkUnsignedCharArray.h>

namespace rt::viz
{

Window::Window(Controller& shown, int windowWidth, int windowHeight, bool onScreen)
    : controller(shown), title(shown), image(shown), numbers(shown), scene(shown), strip(shown), width(windowWidth),
      height(windowHeight)
{
    window->SetWindowName("raytree");
    window->SetSize(width, height);
    window->SetMultiSamples(0); // with depth peeling more than 0 loses what is translucent
    window->SetDPI(72);
    window->SetAlphaBitPlanes(true);
    window->SetNumberOfLayers(2);
    for (auto* pane : panes)
    {
        for (auto* part : pane->renderers())
        {
            window->AddRenderer(part);
            part->SetInteractive(part == scene.renderer());
        }
    }
    layOut();
    scene.fitScene();
    controller.changed = [this](unsigned changes) { update(changes); };
    if (!onScreen)
    {
        window->SetOffScreenRendering(true);
        return;
    }
    interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
    interactor->SetRenderWindow(window);
    style->window = this;
    interactor->SetInteractorStyle(style);
    vtkNew<vtkCallbackCommand> onResize;
    onResize->SetClientData(this);
    onResize->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<Window*>(self)->resized(); });
    window->AddObserver(vtkCommand::WindowResizeEvent, onResize);
}

Window::~Window()
{
    controller.changed = nullptr;
    window->RemoveAllObservers();
    if (interactor) interactor->SetInteractorStyle(nullptr);
}

void Window::layOut()
{
    const Layout layout = layoutFor(width, height);
    const Rect places[] = {layout.title, layout.image, layout.numbers, layout.scene, layout.strip};
    for (std::size_t i = 0; i < panes.size(); ++i) panes[i]->place(places[i], width, height, layout.scale);
}

void Window::resized()
{
    const int* size = window->GetSize();
    if (size[0] == width && size[1] == height) return;
    width = size[0];
    height = size[1];
    layOut();
}

void Window::run()
{
    interactor->Initialize();
    window->Render();
    interactor->Start();
}

Image Window::picture()
{
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* size = window->GetActualSize();
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    Image shot(size[0], size[1]);
    const unsigned char* in = pixels->GetPointer(0);
    for (int y = shot.height - 1; y >= 0; --y)
        for (int x = 0; x < shot.width; ++x, in += 3)
            shot.at(x, y) = {fromSrgb8(in[0]), fromSrgb8(in[1]), fromSrgb8(in[2])};
    return shot;
}

Pane* Window::paneAt(int x, int y)
{
    for (auto* pane : panes)
        if (pane->contains(x, y)) return pane;
    return nullptr;
}

void Window::drawOnly(const std::vector<Pane*>& some)
{
    for (auto* pane : panes)
        for (auto* part : pane->renderers()) part->SetDraw(std::find(some.begin(), some.end(), pane) != some.end());
}

void Window::redraw(const std::vector<Pane*>& some)
{
    drawOnly(some);
    window->Render();
    drawOnly(panes);
}

void Window::update(unsigned changes)
{
    std::vector<Pane*> some;
    for (auto* pane : panes)
        if (pane->update(changes)) some.push_back(pane);
    if (interactor && !some.empty()) redraw(some);
}

void Window::click(int x, int y)
{
    if (auto* pane = paneAt(x, y))
    {
        const int* origin = pane->renderer()->GetOrigin();
        if (pane->click(x - origin[0], y - origin[1])) redraw({pane});
    }
}

void Window::drag(int fromX, int fromY, int dx, int dy)
{
    if (auto* pane = paneAt(fromX, fromY))
        if (pane->drag(dx, dy)) redraw({pane});
}

void Window::wheel(int x, int y, bool forward)
{
    auto* pane = paneAt(x, y);
    if (!pane) return;
    const int* origin = pane->renderer()->GetOrigin();
    if (pane->wheel(x - origin[0], y - origin[1], forward)) redraw({pane});
}

void Window::beginMotion()
{
    scene.setMoving(true);
    drawOnly({&scene});
}

void Window::endMotion()
{
    scene.setMoving(false);
    scene.viewChanged();
    redraw({&scene});
}

void Window::key(const std::string& key, bool shift, int x, int y)
{
    const bool onPicture = shift || paneAt(x, y) == &image;
    if (key == "q" || key == "Q") return interactor->TerminateApp();
    if (key == "Up") return onPicture ? controller.movePixel(0, -1) : controller.previousNode();
    if (key == "Down") return onPicture ? controller.movePixel(0, 1) : controller.nextNode();
    if (key == "Left" && onPicture) return controller.movePixel(-1, 0);
    if (key == "Right" && onPicture) return controller.movePixel(1, 0);
    if (key == "Prior") return controller.parentNode();
    if (key == "bracketleft") return controller.setMaxDepth(controller.maxDepth() - 1);
    if (key == "bracketright") return controller.setMaxDepth(controller.maxDepth() + 1);
    if (key == "n") return controller.toggleNormals();
    if (key == "h" || key == "question") return controller.toggleHelp();
    if (key == "Escape" && controller.showsHelp()) return controller.toggleHelp();
    if (key == "F12") return saveScreenshot();
    if (key == "r")
    {
        scene.fitScene();
        image.fit();
        redraw({&scene, &image});
    }
    if (key == "t")
    {
        scene.fitRays();
        redraw({&scene});
    }
}

void Window::saveScreenshot()
{
    const char* file = "raytree.png";
    try
    {
        writeImage(picture(), file);
        std::cerr << file << ": written\n";
    }
    catch (const std::exception& error)
    {
        std::cerr << error.what() << '\n';
    }
}

} // namespace rt::viz
