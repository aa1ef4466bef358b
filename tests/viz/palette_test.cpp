#include "viz/base/palette.h"

#include <cmath>

#include <gtest/gtest.h>

#include "viz/state/controller.h"

namespace rt::viz
{

namespace
{

using vec3 = Vec3<double>;

constexpr Look looks[] = {Look::dark, Look::light};
constexpr RayRole roles[] = {RayRole::camera,  RayRole::reflected, RayRole::transmitted, RayRole::reaches,
                             RayRole::blocked, RayRole::normal,    RayRole::other};

/// What a dichromat sees (Machado, Oliveira and Fernandes, "A Physiologically-based Model for Simulation of Color Vision
/// Deficiency", 2009; severity 1: protan, deutan, tritan). Linear.
vec3 seenBy(int kind, const vec3& c)
{
    if (kind == 0) return c;
    constexpr double rows[3][9] = {
        {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
        {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
        {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}};
    const double* m = rows[kind - 1];
    const vec3 seen(m[0] * c.x + m[1] * c.y + m[2] * c.z, m[3] * c.x + m[4] * c.y + m[5] * c.z,
                    m[6] * c.x + m[7] * c.y + m[8] * c.z);
    return clamp(seen, 0.0, 1.0);
}

vec3 lab(const vec3& c)
{
    const vec3 xyz(0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z, 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z,
                   0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(xyz.x / 0.9505), y = f(xyz.y), z = f(xyz.z / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(Palette, RaysKeepApartForColourBlindEyesInBothLooks)
{
    const auto linear = [](unsigned char v) { return std::pow(v / 255.0, 2.2); };
    for (const auto look : looks)
        for (int kind = 0; kind < 4; ++kind)
            for (const auto a : roles)
                for (const auto b : roles)
                {
                    if (a >= b) continue;
                    const auto seen = [&](RayRole role) {
                        const Rgba c = colorOf(role, look);
                        return lab(seenBy(kind, {linear(c.r), linear(c.g), linear(c.b)}));
                    };
                    EXPECT_GT(length(seen(a) - seen(b)), 15)
                        << int(a) << " and " << int(b) << " for eyes of kind " << kind << ", look " << int(look);
                }
}

/// As WCAG 2.1 defines it: 4.5 is what text needs (level AA).
double contrast(const Rgba& a, const Rgba& b)
{
    const auto luminance = [](const Rgba& c) {
        const auto linear = [](unsigned char v) {
            const double x = v / 255.0;
            return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    };
    const double p = luminance(a), q = luminance(b);
    return (std::max(p, q) + 0.05) / (std::min(p, q) + 0.05);
}

TEST(Palette, TextIsLegibleOnWhateverItIsWritten)
{
    for (const auto look : looks)
    {
        const Theme& theme = themeOf(look);
        const Rgba beneath[] = {theme.panel, theme.panelRaised, theme.window};
        const Rgba inks[] = {theme.text, theme.textDim, theme.textFaint, theme.accent, theme.warning};
        for (const auto& ground : beneath)
            for (const auto& ink : inks) EXPECT_GE(contrast(ink, ground), 4.5) << int(look);
        for (const auto& ink : {theme.text, theme.textDim}) EXPECT_GE(contrast(ink, theme.lit), 4.5) << int(look);
        for (const auto& ink : {theme.keyword, theme.type, theme.literal, theme.comment})
            EXPECT_GE(contrast(ink, theme.panel), 4.5) << int(look);
    }
}

TEST(Palette, KindsAreLegibleAsTextAndBeneathText)
{
    for (const auto look : looks)
        for (const auto role : roles)
        {
            const Theme& theme = themeOf(look);
            EXPECT_GE(contrast(colorOf(role, look), theme.panel), 4.5) << int(role) << ", look " << int(look);
            EXPECT_GE(contrast(theme.dark, colorOf(role, look)), 4.5) << int(role) << ", look " << int(look);
            EXPECT_GE(contrast(theme.dark, theme.accent), 4.5);
        }
}

TEST(Palette, GivesTheColoursOfTheLookInUse)
{
    useLook(Look::light);
    EXPECT_EQ(color::panel, themeOf(Look::light).panel);
    EXPECT_EQ(colorOf(RayRole::reflected), colorOf(RayRole::reflected, Look::light));
    useLook(Look::dark);
    EXPECT_EQ(color::panel, themeOf(Look::dark).panel);
    EXPECT_EQ(colorOf(RayRole::reflected), colorOf(RayRole::reflected, Look::dark));
}

} // namespace

} // namespace rt::viz
