#include "tests/learn/terminal.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "common/base/interrupt.h"

namespace rt::grade
{

namespace
{

termios before;
bool changed = false;
std::optional<UndoAtInterrupt> undo;

void restore()
{
    if (changed) ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    changed = false;
}

bool plain()
{
    const char* none = std::getenv("NO_COLOR");
    const char* term = std::getenv("TERM");
    return (none && *none) || !term || std::strcmp(term, "dumb") == 0;
}

} // namespace

Keys::Keys()
{
    if (!isTerminal() || ::tcgetattr(STDIN_FILENO, &before) != 0) return;
    termios now = before;
    // ISIG stays: Ctrl-C is a signal.
    now.c_lflag &= ~tcflag_t(ICANON | ECHO);
    now.c_cc[VMIN] = 0;
    now.c_cc[VTIME] = 0;
    changed = true;
    undo.emplace(restore);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keys::~Keys()
{
    restore();
    undo.reset();
}

std::optional<char> Keys::read(double seconds)
{
    if (!changed)
    {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        return std::nullopt;
    }
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, int(seconds * 1000)) <= 0) return std::nullopt;
    char key = 0;
    const auto count = ::read(STDIN_FILENO, &key, 1);
    if (count == 1) return key;
    return count < 0 && errno == EINTR ? std::nullopt : std::optional('q');
}

bool isTerminal()
{
    return ::isatty(STDIN_FILENO) && ::isatty(STDOUT_FILENO);
}

bool showsColor()
{
    return ::isatty(STDOUT_FILENO) && !plain();
}

bool showsPictures()
{
    const char* depth = std::getenv("COLORTERM");
    if (!showsColor() || !depth || (std::strcmp(depth, "truecolor") != 0 && std::strcmp(depth, "24bit") != 0))
        return false;
    winsize size{};
    return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 100;
}

} // namespace rt::grade
