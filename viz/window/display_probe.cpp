#include "viz/window/display_probe.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <sys/uio.h>
#include <unistd.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include "common/program/program.h"

#include <GL/glx.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace rt::viz
{

namespace
{

static_assert(std::is_trivially_copyable_v<DisplayAnswer>);

/// For a window manager that says that it answers; the frame is guessed otherwise.
constexpr auto frameTime = std::chrono::milliseconds(500);
constexpr Frame guessedFrame{6, 6, 40, 6};

/// As vtkXOpenGLRenderWindow of VTK 9.1 to 9.3 asks for it; null if there is none.
GLXFBConfig chosenConfig(Display* display, bool twoBuffers)
{
    std::vector<int> wishes{GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT,
                            GLX_RENDER_TYPE,   GLX_RGBA_BIT,
                            GLX_RED_SIZE,      1,
                            GLX_GREEN_SIZE,    1,
                            GLX_BLUE_SIZE,     1,
                            GLX_DEPTH_SIZE,    1,
                            GLX_ALPHA_SIZE,    1};
    if (twoBuffers) wishes.insert(wishes.end(), {GLX_DOUBLEBUFFER, True});
    wishes.push_back(None);
    int count = 0;
    GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wishes.data(), &count);
    return configs && count > 0 ? configs[0] : nullptr;
}

/// "3.1", from a context that is made current; empty if it cannot be.
std::string versionOf(Display* display, Window window, GLXContext context)
{
    if (!context || !glXMakeCurrent(display, window, context)) return "";
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString =
        reinterpret_cast<GetString>(glXGetProcAddressARB(reinterpret_cast<const unsigned char*>("glGetString")));
    const auto* text = getString ? reinterpret_cast<const char*>(getString(GL_VERSION)) : nullptr;
    if (!text) return "";
    const std::string version = text;
    return version.substr(0, std::min(version.find(' '), std::size_t(8)));
}

bool isEnough(const std::string& version)
{
    int major = 0, minor = 0;
    const char* end = version.data() + version.size();
    const auto [dot, error] = std::from_chars(version.data(), end, major);
    if (error != std::errc() || dot == end || *dot != '.') return false;
    std::from_chars(dot + 1, end, minor);
    return major > 3 || (major == 3 && minor >= 2);
}

/// Does what VTK will do, as far as a current context. Empty if that works.
std::string lackOf(Display* display)
{
    int ignored = 0;
    if (!glXQueryExtension(display, &ignored, &ignored)) return "has no OpenGL (the extension GLX)";
    GLXFBConfig config = chosenConfig(display, true);
    if (!config) config = chosenConfig(display, false);
    XVisualInfo* visual = config ? glXGetVisualFromFBConfig(display, config) : nullptr;
    if (!visual)
        return fmt::format("has no OpenGL in colours of 24 bits (its screen has {} bits a pixel)",
                           DefaultDepth(display, DefaultScreen(display)));

    const Window root = RootWindow(display, visual->screen);
    XSetWindowAttributes attributes{};
    attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
    const Window window = XCreateWindow(display, root, 0, 0, 16, 16, 0, visual->depth, InputOutput, visual->visual,
                                        CWBackPixel | CWBorderPixel | CWColormap, &attributes);
    const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
        glXGetProcAddressARB(reinterpret_cast<const unsigned char*>("glXCreateContextAttribsARB")));
    // VTK asks for 4.5 first and for less and less then: what has 4.5 has 3.2.
    const int wanted[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2, None};
    GLXContext context = create ? create(display, config, nullptr, True, wanted) : nullptr;
    XSync(display, False); // errors arrive now
    if (isEnough(versionOf(display, window, context))) return "";

    // So that the sentence says what there is instead.
    context = glXCreateContext(display, visual, nullptr, True);
    XSync(display, False);
    const auto version = versionOf(display, window, context);
    if (version.empty()) return "has no OpenGL that works (GLX makes no context)";
    return fmt::format("has OpenGL {}{}, and 3.2 is needed", version,
                       glXIsDirect(display, context) ? "" : ", indirect");
}

/// Numbers of 32 bits, which Xlib hands out as longs; empty if the property is not there.
std::vector<long> numbersOf(Display* display, Window window, const char* name, Atom type)
{
    const Atom property = XInternAtom(display, name, True);
    if (property == None) return {};
    Atom found = None;
    int format = 0;
    unsigned long count = 0, rest = 0;
    unsigned char* data = nullptr;
    if (XGetWindowProperty(display, window, property, 0, 1024, False, type, &found, &format, &count, &rest, &data) != 0)
        return {};
    std::vector<long> numbers;
    if (data && format == 32)
    {
        const auto* longs = reinterpret_cast<const long*>(data);
        numbers.assign(longs, longs + count);
    }
    if (data) XFree(data);
    return numbers;
}

/// Empty if no window manager has set it.
Area workAreaOf(Display* display, Window root)
{
    const auto areas = numbersOf(display, root, "_NET_WORKAREA", XA_CARDINAL);
    const auto desktop = numbersOf(display, root, "_NET_CURRENT_DESKTOP", XA_CARDINAL);
    std::size_t first = desktop.empty() ? 0 : 4 * std::size_t(std::max(0L, desktop[0]));
    if (first + 4 > areas.size()) first = 0;
    if (areas.size() < 4) return {};
    return {int(areas[first]), int(areas[first + 1]), int(areas[first + 2]), int(areas[first + 3])};
}

/// As XRandR and Xinerama tell: QueryScreens of the latter, which every server of the former answers. Without a library,
/// whose headers would be one package more for one request.
std::vector<Area> monitors()
{
    xcb_connection_t* server = xcb_connect(nullptr, nullptr);
    static xcb_extension_t xinerama{"XINERAMA", 0};
    const auto* extension = xcb_connection_has_error(server) ? nullptr : xcb_get_extension_data(server, &xinerama);
    if (!extension || !extension->present) return {};

    unsigned char request[4] = {}; // opcodes and length are filled in
    const xcb_protocol_request_t protocol{2, &xinerama, 5, 0};
    iovec parts[4] = {};
    parts[2] = {request, sizeof request};
    const auto sequence = xcb_send_request(server, XCB_REQUEST_CHECKED, parts + 2, &protocol);
    const std::unique_ptr<void, decltype(&std::free)> reply(xcb_wait_for_reply(server, sequence, nullptr), &std::free);
    if (!reply) return {};

    const auto* bytes = static_cast<const unsigned char*>(reply.get());
    std::uint32_t length = 0, count = 0;
    std::memcpy(&length, bytes + 4, sizeof length);
    std::memcpy(&count, bytes + 8, sizeof count);
    std::vector<Area> found;
    for (std::uint32_t i = 0; i < std::min(count, length / 2); ++i)
    {
        std::int16_t corner[2];
        std::uint16_t size[2];
        std::memcpy(corner, bytes + 32 + 8 * i, sizeof corner);
        std::memcpy(size, bytes + 32 + 8 * i + 4, sizeof size);
        found.push_back({corner[0], corner[1], size[0], size[1]});
    }
    return found;
}

/// What the window manager will put around a window: nothing if there is none.
Frame frameOf(Display* display, Window root)
{
    // A window of the manager's names itself: what it said of the root window stays there when it ends.
    const char* check = "_NET_SUPPORTING_WM_CHECK";
    const auto manager = numbersOf(display, root, check, XA_WINDOW);
    if (manager.empty() || numbersOf(display, Window(manager[0]), check, XA_WINDOW) != manager) return {};
    const auto known = numbersOf(display, root, "_NET_SUPPORTED", XA_ATOM);
    const Atom ask = XInternAtom(display, "_NET_REQUEST_FRAME_EXTENTS", False);
    if (std::find(known.begin(), known.end(), long(ask)) == known.end()) return guessedFrame;

    const Window window = XCreateSimpleWindow(display, root, 0, 0, 100, 100, 0, 0, 0);
    XSelectInput(display, window, PropertyChangeMask);
    XEvent request{};
    request.xclient.type = ClientMessage;
    request.xclient.window = window;
    request.xclient.message_type = ask;
    request.xclient.format = 32;
    XSendEvent(display, root, False, SubstructureNotifyMask | SubstructureRedirectMask, &request);
    const auto end = std::chrono::steady_clock::now() + frameTime;
    while (true)
    {
        XSync(display, False);
        const auto sides = numbersOf(display, window, "_NET_FRAME_EXTENTS", XA_CARDINAL);
        if (sides.size() >= 4) return {int(sides[0]), int(sides[1]), int(sides[2]), int(sides[3])};
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
        if (left <= 0) return guessedFrame;
        for (XEvent event; XPending(display) > 0;) XNextEvent(display, &event);
        pollfd wait{ConnectionNumber(display), POLLIN, 0};
        poll(&wait, 1, int(left));
    }
}

} // namespace

void endWithDisplay()
{
    XSetIOErrorHandler([](Display*) -> int {
        constexpr char sentence[] = "viewer: the display has closed the connection\n";
        [[maybe_unused]] const auto written = write(STDERR_FILENO, sentence, sizeof sentence - 1);
        _exit(exitNoDisplay);
    });
}

void probeDisplay(DisplayAnswer& answer, bool forWindow)
{
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    XSetIOErrorHandler([](Display*) -> int { _exit(1); });
    const auto lacks = [&](const std::string& what) {
        fmt::format_to_n(answer.lacks, sizeof answer.lacks - 1, "{}", what);
    };
    Display* display = XOpenDisplay(nullptr);
    if (!display) return lacks("cannot be opened");
    if (const auto lack = lackOf(display); !lack.empty()) return lacks(lack);
    if (!forWindow) return;

    const int number = DefaultScreen(display);
    const Window root = RootWindow(display, number);
    Window pointerRoot = None, pointerChild = None;
    int x = 0, y = 0, inside = 0;
    unsigned buttons = 0;
    XQueryPointer(display, root, &pointerRoot, &pointerChild, &x, &y, &inside, &inside, &buttons);
    const Area screen{0, 0, DisplayWidth(display, number), DisplayHeight(display, number)};
    answer.area = areaFor(screen, monitors(), x, y, workAreaOf(display, root));
    answer.frame = frameOf(display, root);
    answer.scale =
        wishedScale(XGetDefault(display, "Xft", "dpi"), std::getenv("GDK_SCALE"), std::getenv("QT_SCALE_FACTOR"));
}

} // namespace rt::viz
