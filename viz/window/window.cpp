#include "viz/window/window.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkUnsignedCharArray.h>

#include "common/files/picture_file.h"
#include "common/files/text_file.h"
#include "common/program/program.h"
#include "viz/window/pending_input.h"
#include "viz/window/recording.h"
#include "viz/window/window_name.h"

namespace rt::viz
{

namespace
{

constexpr auto messageTime = std::chrono::seconds(6);
constexpr unsigned long tickTime = 80; // milliseconds
const double letterStep = std::pow(2, 0.25);
constexpr std::size_t mostDigits = 7;
constexpr PaneId panesInTurn[] = {PaneId::scene,   PaneId::tree,  PaneId::code,
                                  PaneId::numbers, PaneId::image, PaneId::chart};

/// Panes make what they draw when they are made: fonts and colours must be right before.
Controller& dressed(Controller& controller)
{
    if (const auto problem = prepareFonts(); !problem.empty()) controller.say(problem);
    useLook(controller.look());
    return controller;
}

} // namespace

Window::Window(Controller& shown, const WindowPlace& place, bool onScreen)
    : controller(dressed(shown)), title(shown), image(shown), numbers(shown), scene(shown), code(shown), tree(shown),
      chart(shown), strip(shown), help(shown), width(place.width), height(place.height), scale(place.scale),
      dressedFor(shown.look())
{
    name();
    window->SetPosition(place.x, place.y);
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
    strip.typeKey = help.typeKey = [this](const std::string& name) { key(name, false); };
    layOut();
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
    // The close button. Without an observer VTK would end by itself; but a recorder is one.
    vtkNew<vtkCallbackCommand> onClose;
    onClose->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
        static_cast<vtkRenderWindowInteractor*>(caller)->TerminateApp();
    });
    interactor->AddObserver(vtkCommand::ExitEvent, onClose);
}

Window::~Window()
{
    controller.changed = nullptr;
    window->RemoveAllObservers();
    if (interactor) interactor->SetInteractorStyle(nullptr);
}

/// As the desktop lists it: whose rays of what scene these are.
void Window::name()
{
    std::string source = controller.source().title;
    if (const auto gap = source.find("  "); gap != std::string::npos) source.erase(gap, 1);
    const auto& of = controller.scene();
    const auto shown = of.title.empty() ? std::filesystem::path(of.file).filename().string() : of.title;
    const auto words = "raytree: " + source + (shown.empty() || shown == source ? "" : ", " + shown);
    window->SetWindowName(words.c_str());
    if (interactor) nameWindow(window->GetGenericDisplayId(), window->GetGenericWindowId(), words);
}

LayoutWishes Window::wishes() const
{
    return {controller.showsHelp() ? PaneId::help : whole, controller.canCompare(), scale};
}

void Window::layOut()
{
    laidOut = wishes();
    const Layout layout = layoutFor(width, height, laidOut);
    drawnScale = layout.scale;
    for (std::size_t i = 0; i < panes.size(); ++i)
        panes[i]->place(layout.panes[i], width, height, layout.scaleOf(PaneId(i)));
    under = nullptr;
    drawOnly(panes);
}

void Window::resized()
{
    const int* size = window->GetSize();
    if (size[0] == width && size[1] == height) return;
    width = std::max(1, size[0]);
    height = std::max(1, size[1]);
    layOut();
}

void Window::resize(int newWidth, int newHeight)
{
    window->SetSize(std::max(1, newWidth), std::max(1, newHeight));
    resized();
    if (interactor) window->Render();
}

void Window::run(const std::string& record)
{
    const std::string part = record + ".part";
    const UndoAtInterrupt undo([&part] {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
    });
    const WindowPlace recorded{.width = width, .height = height, .scale = scale};
    if (!record.empty()) writeTextFile(part, ""); // or says now why it cannot be written
    auto recorder = vtkSmartPointer<vtkInteractorEventRecorder>::New();
    interactor->Initialize();
    window->Render();
    name();
    interactor->CreateRepeatingTimer(tickTime);
    if (!record.empty())
    {
        recorder->SetInteractor(interactor);
        recorder->KeyPressActivationOff(); // otherwise key i would turn it off
        recorder->SetFileName(part.c_str());
        recorder->EnabledOn();
        recorder->Record();
        // It goes off at key e, which exports here: everything but that key is recorded.
        vtkNew<vtkCallbackCommand> goOn;
        goOn->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
            static_cast<vtkInteractorEventRecorder*>(caller)->EnabledOn();
        });
        recorder->AddObserver(vtkCommand::DisableEvent, goOn);
    }
    interactor->Start();
    if (record.empty()) return;
    recorder->RemoveObservers(vtkCommand::DisableEvent);
    recorder = nullptr; // closes the file
    writeTextFile(record, tidyRecording(readTextFile(part), recorded));
    std::filesystem::remove(part);
}

void Window::replay(const std::string& file)
{
    vtkNew<vtkInteractorEventRecorder> recorder;
    interactor->Initialize();
    window->Render();
    recorder->SetInteractor(interactor);
    recorder->KeyPressActivationOff();
    recorder->SetFileName(file.c_str());
    recorder->EnabledOn();
    recorder->Play();
    recorder->EnabledOff();
}

void Window::press(const std::string& keys)
{
    const std::string shift = "Shift+";
    const bool withShift = keys.starts_with(shift);
    key(withShift ? keys.substr(shift.size()) : keys, withShift);
}

void Window::dragFrom(int fromX, int fromY, int toX, int toY)
{
    press(fromX, fromY);
    drag(fromX, fromY, toX - fromX, toY - fromY);
    release();
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
    {
        const bool isDrawn = pane->isPlaced() && std::find(some.begin(), some.end(), pane) != some.end();
        for (auto* part : pane->renderers()) part->SetDraw(isDrawn);
    }
}

void Window::redraw(const std::vector<Pane*>& some)
{
    if (!interactor) return;
    for (auto* pane : some)
        if (std::find(late.begin(), late.end(), pane) == late.end()) late.push_back(pane);
    // Keys that repeat, and the wheel, are faster than drawing: what they have done is drawn once.
    if (isInputPending(window->GetGenericDisplayId())) return;
    drawOnly(std::exchange(late, {}));
    window->Render();
    drawOnly(panes);
}

void Window::redrawIfAsked()
{
    std::vector<Pane*> some;
    for (auto* pane : panes)
        if (pane->wantsDrawing() && pane->isPlaced()) some.push_back(pane);
    if (!some.empty()) redraw(some);
}

void Window::dress()
{
    dressedFor = controller.look();
    useLook(dressedFor);
    for (auto* pane : panes) pane->dress();
}

void Window::update(unsigned changes)
{
    if (controller.look() != dressedFor) dress();
    if (changes & changedMessage) saidAt = Clock::now();
    if (changes & changedScene) name();
    std::vector<Pane*> some;
    for (auto* pane : panes)
        if (pane->update(changes) && pane->isPlaced()) some.push_back(pane);
    if (const auto now = wishes(); now.whole != laidOut.whole || now.titleHasTwoLines != laidOut.titleHasTwoLines)
    {
        layOut();
        some = panes;
    }
    if (!some.empty()) redraw(some);
}

bool Window::press(int x, int y)
{
    auto* pane = paneAt(x, y);
    if (!pane) return false;
    const int* origin = pane->renderer()->GetOrigin();
    return pane->press(x - origin[0], y - origin[1]);
}

void Window::release()
{
    for (auto* pane : panes) pane->release();
    redrawIfAsked();
}

void Window::click(int x, int y)
{
    if (auto* pane = paneAt(x, y))
    {
        const auto id = PaneId(std::find(panes.begin(), panes.end(), pane) - panes.begin());
        if (whole == PaneId::none &&
            std::find(std::begin(panesInTurn), std::end(panesInTurn), id) != std::end(panesInTurn))
            clicked = id;
        const int* origin = pane->renderer()->GetOrigin();
        if (pane->click(x - origin[0], y - origin[1])) redraw({pane});
    }
}

void Window::drag(int fromX, int fromY, int dx, int dy)
{
    if (auto* pane = paneAt(fromX, fromY))
        if (pane->drag(dx, dy)) redraw({pane});
}

void Window::hover(int x, int y)
{
    auto* pane = paneAt(x, y);
    if (under && under != pane) under->leave();
    under = pane;
    if (pane)
    {
        const int* origin = pane->renderer()->GetOrigin();
        pane->hover(x - origin[0], y - origin[1]);
    }
    redrawIfAsked();
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

void Window::tick()
{
    if (interrupted()) return interactor->TerminateApp();
    const auto now = Clock::now();
    if (!late.empty()) redraw({});
    controller.reread();
    controller.poll();
    if (!controller.isPlaying()) lastStep = now; // the button, too, begins to play with the first step
    const int due = int(std::chrono::duration<double>(now - lastStep).count() * controller.speed());
    if (controller.isPlaying() && due > 0)
    {
        lastStep = now;
        controller.playOn(due);
    }
    if (controller.tone() == Tone::done && now - saidAt >= messageTime) controller.say("");
}

void Window::key(const std::string& asTyped, bool shift)
{
    if (strip.typed) return type(asTyped);
    // Capital letters, of Shift or Caps Lock, are as good as small ones.
    const std::string key =
        asTyped.size() == 1 ? std::string(1, char(std::tolower(static_cast<unsigned char>(asTyped[0])))) : asTyped;
    if (key == "q")
    {
        if (interactor) interactor->TerminateApp();
        return;
    }
    if (key == "Up") return shift ? controller.movePixel(0, -1) : controller.previousNode();
    if (key == "Down") return shift ? controller.movePixel(0, 1) : controller.nextNode();
    if (key == "Left") return shift ? controller.movePixel(-1, 0) : controller.stepBy(-1);
    if (key == "Right") return shift ? controller.movePixel(1, 0) : controller.stepBy(1);
    if (key == "Home") return controller.stepTo(0);
    if (key == "End") return controller.stepTo(controller.lastStep());
    if (key == "space")
    {
        lastStep = Clock::now();
        return controller.setPlaying(!controller.isPlaying());
    }
    if (key == "comma") return controller.playFaster(false);
    if (key == "period") return controller.playFaster(true);
    if (key == "plus" || key == "equal" || key == "KP_Add") return setScale(scale * letterStep);
    if (key == "minus" || key == "KP_Subtract") return setScale(scale / letterStep);
    if (key == "Prior") return controller.parentNode();
    if (key == "bracketleft") return controller.setMaxDepth(controller.maxDepth() - 1);
    if (key == "bracketright") return controller.setMaxDepth(controller.maxDepth() + 1);
    if (key.size() == 1 && key[0] >= '1' && key[0] < '1' + kinds) return controller.toggle(Kind(key[0] - '1'));
    if (key == "n") return controller.toggleNormals();
    if (key == "c") return controller.toggleComparison();
    if (key == "d") return controller.selectDifference();
    if (key == "l") return controller.toggleLook();
    if (key == "h" || key == "question") return controller.toggleHelp();
    if (key == "m") return enlargeNext();
    if (key == "F12") return saveScreenshot();
    if (key == "e" && exportAll) return exportAll();
    if (key == "g" || key == "slash")
    {
        strip.typed = "";
        return redraw({&strip});
    }
    if (key == "Escape")
    {
        if (controller.showsHelp()) return controller.toggleHelp();
        if (whole != PaneId::none) return enlarge(PaneId::none);
        return controller.say("");
    }
    if (key == "r")
    {
        scene.fitScene();
        image.fit();
        redraw({&scene, &image});
    }
    if (key == "t")
    {
        scene.fitRays();
        tree.fit();
        redraw({&scene, &tree});
    }
}

void Window::setScale(double wanted)
{
    scale = std::clamp(wanted, smallestScale, largestScale);
    layOut();
    redraw(panes);
}

/// This pane takes the place of all; `none`: all have theirs.
void Window::enlarge(PaneId pane)
{
    whole = pane;
    layOut();
    redraw(panes);
}

/// One pane after the other, beginning with the one that was clicked last, and then all of them again.
void Window::enlargeNext()
{
    if (controller.showsHelp()) return;
    if (whole == PaneId::none) return enlarge(clicked);
    const auto now = std::find(std::begin(panesInTurn), std::end(panesInTurn), whole);
    const auto next = now + 1 == std::end(panesInTurn) ? std::begin(panesInTurn) : now + 1;
    enlarge(*next == clicked ? PaneId::none : *next);
}

void Window::type(const std::string& key)
{
    const bool isPad = key.size() == 4 && key.starts_with("KP_");
    const char last = key.empty() ? ' ' : key.back();
    if ((key.size() == 1 || isPad) && last >= '0' && last <= '9')
    {
        if (strip.typed->size() < mostDigits) *strip.typed += last;
    }
    else if (key == "BackSpace")
    {
        if (!strip.typed->empty()) strip.typed->pop_back();
    }
    else if (key == "Return" || key == "KP_Enter" || key == "Escape")
    {
        const auto digits = *strip.typed;
        strip.typed.reset();
        if (key != "Escape" && !digits.empty()) goTo(digits);
    }
    redraw({&strip});
}

void Window::goTo(const std::string& digits)
{
    tree.search(digits);
    redraw({&tree});
}

/// Never over a picture that is there.
void Window::saveScreenshot()
{
    std::string file = "raytree.png";
    for (int i = 2; std::filesystem::exists(file) && i < 10000; ++i) file = fmt::format("raytree-{}.png", i);
    try
    {
        if (controller.isRefining()) controller.wait(); // a coarse picture is no result
        const Image shot = picture();
        writeImage(shot, file);
        controller.say(file + ": written", Tone::done);
    }
    catch (const std::exception& error)
    {
        controller.say(error.what());
    }
}

} // namespace rt::viz
