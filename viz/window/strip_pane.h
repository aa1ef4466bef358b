// The strip at the bottom: stepping, sliders, what is shown, and what the keys do.
#pragma once

#include "viz/base/slider.h"
#include "viz/window/pane.h"

namespace rt::viz
{

class StripPane : public Pane
{
public:
    using Pane::Pane;
    bool update(unsigned changes) override;
    bool press(int x, int y) override;
    bool drag(int dx, int dy) override;
    void release() override;
    bool click(int x, int y) override;
    void hover(int x, int y) override;
    void leave() override;

    /// The digits typed so far, to go to a ray by its number; empty: nobody types.
    std::optional<std::string> typed;
    /// Does what a key does; `key` as X names it.
    std::function<void(const std::string& key)> typeKey;

private:
    /// Something to click.
    struct Spot
    {
        Box box;
        std::function<void()> act;
        std::string hint; ///< what it does, shown while the pointer is over it
    };
    enum Role
    {
        stepSlider,
        depthSlider,
        weakSlider,
        sliders
    };

    std::vector<Spot> spots;
    Slider tracks[sliders];
    Box grips[sliders]; ///< where a press takes hold of the slider
    int held = -1, hot = -1, hotSlider = -1;
    double heldX = 0;
    int deepestCap = 0; ///< right end of the depth slider: never shrinks, or the knob would run away

    void paint(Canvas& canvas) override;
    double paintButtons(Canvas& canvas, double x, double y);
    void paintSlider(Canvas& canvas, Role role, const Box& place, const std::string& label, const std::string& value,
                     double position);
    double paintChips(Canvas& canvas, double x, double y);
    void paintKeys(Canvas& canvas, double x, double y);
    bool paintLine(Canvas& canvas, double x, double y);
    void set(int slider, double x);
    bool isHot(const Box& box) const;
    void addSpot(const Box& box, const std::string& hint, std::function<void()> act);

    double pointerX = -1, pointerY = -1;
};

struct KeyHelp
{
    const char* keys;  ///< separated by spaces, each drawn as a key
    const char* brief; ///< for the strip; empty: only on the cheat sheet
    const char* what;
};

/// All keys and mouse gestures, the important ones first.
const std::vector<KeyHelp>& keyHelp();

/// X's name of the key with this cap; empty: the cap stands for no single key ("click", "⇧").
std::string keyOfCap(const std::string& cap);

/// The box of a key cap at x.
Box capBox(Canvas& canvas, double x, double y, const std::string& cap, double size);
/// Draws a key cap at x; returns where it ends. One that is no button, or stands for no single key, is flat.
double drawKey(Canvas& canvas, double x, double y, const std::string& key, double size, bool isHot = false);

} // namespace rt::viz
