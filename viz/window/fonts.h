// The fonts are files: VTK's built-in one silently drops θ, ₁ and →.
#pragma once

#include <string>
#include <vector>

#include <vtkTextProperty.h>

namespace rt::viz
{

enum class Font
{
    sans,
    bold,
    mono
};

/// Sets the font alone. Its file is looked for where distributions put DejaVu, or in the folder RAYTREE_FONTS; without it
/// VTK's own font is taken.
void useFont(vtkTextProperty* property, Font font);

/// A piece of a text, and the font that has its signs: -1 the chosen one, else one of the others that are installed.
struct FontRun
{
    int other = -1;
    std::string text;

    bool operator==(const FontRun&) const = default;
};

/// The whole text. DejaVu has neither Chinese nor emoji; what no font has becomes "□", so that nothing vanishes.
std::vector<FontRun> fontRuns(const std::string& text, Font font);
void useFont(vtkTextProperty* property, Font font, int other);

/// To be called before anything is drawn: makes VTK keep all fonts. One sentence if a font is missing, else empty.
std::string prepareFonts();

} // namespace rt::viz
