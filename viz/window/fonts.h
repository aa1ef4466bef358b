// The fonts are files: VTK's built-in one silently drops θ, ₁ and →.
#pragma once

#include <string>

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

/// To be called before anything is drawn: makes VTK keep all fonts. One sentence if a font is missing, else empty.
std::string prepareFonts();

} // namespace rt::viz
