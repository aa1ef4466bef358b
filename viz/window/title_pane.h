// The line at the top: what is shown.
#pragma once

#include "viz/window/pane.h"

namespace rt::viz
{

class TitlePane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned changes) override;

private:
    void paint(Canvas& canvas) override;
    void paintComparison(Canvas& canvas, double height);
};

} // namespace rt::viz
