// Colours of the viewer. The colours of rays keep apart for colour-blind eyes too (after Okabe and Ito, "Color Universal
// Design"); a test simulates the three kinds of dichromacy.
#pragma once

#include "common/vec.h"

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
    normal
};

constexpr bool isRay(RayRole role)
{
    return role == RayRole::camera || role == RayRole::reflected || role == RayRole::transmitted;
}

constexpr bool isShadow(RayRole role)
{
    return role == RayRole::reaches || role == RayRole::blocked || role == RayRole::beyond;
}

constexpr Rgba colorOf(RayRole role)
{
    switch (role)
    {
    case RayRole::camera:
        return {86, 180, 233};
    case RayRole::reflected:
        return {245, 159, 20};
    case RayRole::transmitted:
        return {32, 166, 76};
    case RayRole::reaches:
        return {246, 233, 98};
    case RayRole::blocked:
    case RayRole::beyond:
        return {222, 110, 178};
    case RayRole::normal:
        break;
    }
    return {226, 232, 240};
}

namespace color
{
inline constexpr Rgba window{13, 17, 23};      // behind everything
inline constexpr Rgba panel{20, 26, 35};       // panes with text
inline constexpr Rgba panelRaised{31, 40, 53}; // chips and key caps
inline constexpr Rgba line{44, 55, 71};        // between panes
inline constexpr Rgba skyLow{19, 25, 34};      // background of the 3D view
inline constexpr Rgba skyHigh{38, 50, 68};
inline constexpr Rgba text{226, 232, 240};
inline constexpr Rgba textDim{148, 163, 184};
inline constexpr Rgba textFaint{100, 116, 139};
inline constexpr Rgba accent{125, 211, 252};
inline constexpr Rgba dark{10, 14, 20};
} // namespace color

} // namespace rt::viz
