// Energy per depth.
#pragma once

#include "viz/state/energy.h"
#include "viz/window/pane.h"

namespace rt::viz
{

class ChartPane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned changes) override;

private:
    void paint(Canvas& canvas) override;
    void paintTitle(Canvas& canvas, const Energy& energy);
    void paintBars(Canvas& canvas, const Energy& energy);
};

} // namespace rt::viz
