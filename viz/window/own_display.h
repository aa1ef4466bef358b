// An X server of the viewer's own, for pictures where no display can draw them.
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace rt::viz
{

/// Xvfb, which DISPLAY names as long as this lives. It ends with this process, however that ends, and only this process can
/// connect to it. To be made before Xlib is first used.
class OwnDisplay
{
public:
    /// Throws std::runtime_error that says why it cannot be started.
    OwnDisplay(int width, int height);
    ~OwnDisplay();
    OwnDisplay(const OwnDisplay&) = delete;
    OwnDisplay& operator=(const OwnDisplay&) = delete;

private:
    pid_t server = -1;
    std::optional<std::string> before; // DISPLAY

    void stop();
};

} // namespace rt::viz
