// The line at the bottom: what the keys do.
#pragma once

#include "viz/pane.h"

namespace rt::viz
{

class StripPane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned changes) override;

private:
    void paint(Canvas& canvas) override;
};

struct KeyHelp
{
    const char* keys;  ///< separated by spaces, each drawn as a key
    const char* brief; ///< for the strip; empty: only on the cheat sheet
    const char* what;
};

/// All keys and mouse gestures, the important ones first.
const std::vector<KeyHelp>& keyHelp();

/// Draws one key cap at x; returns where it ends.
double drawKey(Canvas& canvas, double x, double y, const std::string& key, double size);

} // namespace rt::viz
