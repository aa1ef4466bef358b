// The cheat sheet: takes the place of all panes between title and strip.
#pragma once

#include "viz/window/pane.h"

namespace rt::viz
{

class HelpPane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned) override { return false; }
    bool click(int x, int y) override;

    /// Does what a key does, as StripPane::typeKey.
    std::function<void(const std::string& key)> typeKey;

private:
    struct Cap
    {
        Box box;
        std::string key;
    };
    std::vector<Cap> caps;

    void paint(Canvas& canvas) override;
};

} // namespace rt::viz
