#include "viz/base/palette.h"

namespace rt::viz
{

namespace
{

constexpr Theme darkTheme{
    .window = {13, 17, 23},
    .panel = {20, 26, 35},
    .panelRaised = {31, 40, 53},
    .line = {44, 55, 71},
    .skyLow = {19, 25, 34},
    .skyHigh = {38, 50, 68},
    .text = {226, 232, 240},
    .textDim = {156, 170, 190},
    .textFaint = {128, 144, 168},
    .accent = {125, 211, 252},
    .dark = {10, 14, 20},
    .warning = {251, 191, 36},
    .lit = {62, 56, 22},
    .keyword = {147, 187, 255},
    .type = {126, 214, 199},
    .literal = {233, 186, 140},
    .comment = {134, 164, 136},
};

constexpr Theme lightTheme{
    .window = {228, 233, 240},
    .panel = {247, 249, 251},
    .panelRaised = {226, 232, 240},
    .line = {196, 205, 217},
    .skyLow = {219, 226, 236},
    .skyHigh = {250, 252, 254},
    .text = {15, 23, 42},
    .textDim = {60, 73, 92},
    .textFaint = {84, 97, 117},
    .accent = {3, 98, 152},
    .dark = {255, 255, 255},
    .warning = {150, 62, 6},
    .lit = {255, 240, 178},
    .keyword = {29, 78, 190},
    .type = {15, 105, 95},
    .literal = {150, 62, 20},
    .comment = {60, 106, 62},
};

Look used = Look::dark;

} // namespace

namespace color::current
{
Theme theme = darkTheme;
}

const Theme& themeOf(Look look)
{
    return look == Look::dark ? darkTheme : lightTheme;
}

void useLook(Look look)
{
    used = look;
    color::current::theme = themeOf(look);
}

Rgba colorOf(RayRole role)
{
    return colorOf(role, used);
}

Rgba colorOf(RayRole role, Look look)
{
    const bool dark = look == Look::dark;
    switch (role)
    {
    case RayRole::camera:
        return dark ? Rgba{86, 180, 233} : Rgba{0, 90, 200};
    case RayRole::reflected:
        return dark ? Rgba{245, 159, 20} : Rgba{185, 80, 0};
    case RayRole::transmitted:
        return dark ? Rgba{32, 166, 76} : Rgba{0, 120, 95};
    case RayRole::reaches:
        return dark ? Rgba{246, 233, 98} : Rgba{103, 65, 0};
    case RayRole::blocked:
    case RayRole::beyond:
        return dark ? Rgba{222, 110, 178} : Rgba{176, 29, 138};
    case RayRole::other:
        return dark ? Rgba{160, 118, 255} : Rgba{110, 20, 235};
    case RayRole::normal:
        break;
    }
    return dark ? Rgba{226, 232, 240} : Rgba{30, 41, 59};
}

} // namespace rt::viz
