// The fonts are files: VTK's built-in one silently drops θ, ₁ and →.
#pragma once

#include <string>

namespace rt::viz
{

enum class Font
{
    sans,
    bold,
    mono
};

/// Its file. Throws std::runtime_error with one sentence if it is not installed.
const std::string& fontFile(Font font);

/// Throws if a font is missing. To be called before anything is drawn: it also makes VTK keep all fonts.
void checkFonts();

} // namespace rt::viz
