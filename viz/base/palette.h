// Colours of the viewer. The colours of rays keep apart for colour-blind eyes too (after Okabe and Ito, "Color Universal
// Design"); a test simulates the three kinds of dichromacy, in both looks.
#pragma once

#include "common/base/ray.h"
#include "viz/base/look.h"

namespace rt::viz
{

/// 8-bit sRGB with coverage.
struct Rgba
{
    unsigned char r = 0, g = 0, b = 0, a = 255;

    constexpr Rgba withAlpha(double alpha) const { return {r, g, b, static_cast<unsigned char>(alpha * 255 + 0.5)}; }
    bool operator==(const Rgba&) const = default;
};

constexpr Rgba mix(const Rgba& a, const Rgba& b, double t)
{
    const auto channel = [t](unsigned char p, unsigned char q) {
        return static_cast<unsigned char>(p + (q - p) * t + 0.5);
    };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

/// What a line of the 3D view stands for.
enum class RayRole
{
    camera,
    reflected,
    transmitted,
    reaches, ///< a shadow ray that reaches its light
    blocked, ///< a shadow ray, up to what is in its way
    beyond,  ///< the rest of it, which no light travels
    normal,
    other ///< a ray of the tree that this one is compared with; dashed
};

constexpr RayRole rayRole(RayKind kind)
{
    return kind == RayKind::camera      ? RayRole::camera
           : kind == RayKind::reflected ? RayRole::reflected
                                        : RayRole::transmitted;
}

constexpr bool isRay(RayRole role)
{
    return role == RayRole::camera || role == RayRole::reflected || role == RayRole::transmitted;
}

constexpr bool isShadow(RayRole role)
{
    return role == RayRole::reaches || role == RayRole::blocked || role == RayRole::beyond;
}

/// All colours that do not stand for a ray.
struct Theme
{
    Rgba window;      ///< behind everything
    Rgba panel;       ///< panes with text
    Rgba panelRaised; ///< chips and key caps
    Rgba line;        ///< between panes
    Rgba skyLow;      ///< background of the 3D view
    Rgba skyHigh;
    Rgba text;
    Rgba textDim;
    Rgba textFaint;
    Rgba accent; ///< headings, what is pressed
    Rgba dark;   ///< ink on what is coloured, and plates beneath text; white in the light look
    Rgba warning;
    Rgba lit;                             ///< beneath the current line
    Rgba keyword, type, literal, comment; ///< of source text
};

const Theme& themeOf(Look look);
/// Legible on the panels of that look.
Rgba colorOf(RayRole role, Look look);

/// From now on `color` and colorOf(role) give this look's. What is already drawn stays: call it before painting.
void useLook(Look look);
Rgba colorOf(RayRole role);

namespace color
{
namespace current
{
extern Theme theme;
}
inline const Rgba& window = current::theme.window;
inline const Rgba& panel = current::theme.panel;
inline const Rgba& panelRaised = current::theme.panelRaised;
inline const Rgba& line = current::theme.line;
inline const Rgba& skyLow = current::theme.skyLow;
inline const Rgba& skyHigh = current::theme.skyHigh;
inline const Rgba& text = current::theme.text;
inline const Rgba& textDim = current::theme.textDim;
inline const Rgba& textFaint = current::theme.textFaint;
inline const Rgba& accent = current::theme.accent;
inline const Rgba& dark = current::theme.dark;
inline const Rgba& warning = current::theme.warning;
inline const Rgba& lit = current::theme.lit;
inline const Rgba& keyword = current::theme.keyword;
inline const Rgba& type = current::theme.type;
inline const Rgba& literal = current::theme.literal;
inline const Rgba& comment = current::theme.comment;
} // namespace color

} // namespace rt::viz
