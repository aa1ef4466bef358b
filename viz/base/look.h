// Dark or light: which of its two sets of colours the viewer shows.
#pragma once

namespace rt::viz
{

enum class Look
{
    dark,
    light
};

constexpr const char* name(Look look)
{
    return look == Look::dark ? "dark" : "light";
}

} // namespace rt::viz
