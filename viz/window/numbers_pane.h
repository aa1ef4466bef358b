// The selected node explained: the lecture's formulas with its numbers.
#pragma once

#include "viz/window/pane.h"

namespace rt::viz
{

class NumbersPane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned changes) override;
    bool click(int x, int y) override;
    void hover(int x, int y) override;
    void leave() override;
    bool wheel(int x, int y, bool forward) override;

private:
    double scrolled = 0, overflow = 0;
    struct Chip
    {
        Box box;
        int node;
    };
    std::vector<Chip> chips;

    void paint(Canvas& canvas) override;
    double paintChips(Canvas& canvas, double top);
    void paintHeading(Canvas& canvas, double top);
};

} // namespace rt::viz
