// The cheat sheet: takes the place of all panes between title and strip.
#pragma once

#include "viz/pane.h"

namespace rt::viz
{

class HelpPane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned) override { return false; }
    bool click(int x, int y) override;

private:
    void paint(Canvas& canvas) override;
};

} // namespace rt::viz
