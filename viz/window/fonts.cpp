#include "viz/window/fonts.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <vtkFreeTypeTools.h>

namespace rt::viz
{

namespace
{

/// Empty if it is not there.
std::string find(const std::string& file)
{
    std::vector<std::filesystem::path> folders{"/usr/share/fonts/truetype/dejavu",
                                               "/usr/share/fonts/dejavu-sans-fonts",
                                               "/usr/share/fonts/dejavu-sans-mono-fonts",
                                               "/usr/share/fonts/dejavu",
                                               "/usr/share/fonts/TTF",
                                               "/usr/local/share/fonts/dejavu"};
    if (const char* chosen = std::getenv("RAYTREE_FONTS")) folders = {chosen};
    for (const auto& folder : folders)
        if (const auto path = folder / file; std::filesystem::exists(path)) return path.string();
    return "";
}

const std::string& fileOf(Font font)
{
    static const std::array files{find("DejaVuSans.ttf"), find("DejaVuSans-Bold.ttf"), find("DejaVuSansMono.ttf")};
    return files[std::size_t(font)];
}

} // namespace

void useFont(vtkTextProperty* property, Font font)
{
    if (const auto& file = fileOf(font); !file.empty())
    {
        property->SetFontFamily(VTK_FONT_FILE);
        property->SetFontFile(file.c_str());
        return;
    }
    // The one that VTK brings along: better than no text.
    property->SetFontFamily(font == Font::mono ? VTK_COURIER : VTK_ARIAL);
    property->SetBold(font == Font::bold);
}

std::string prepareFonts()
{
    // VTK 9.1 counts each colour and size of a font as a face of its own, keeps a few, and looks a forgotten one up in the text
    // property that it was first seen in, which by then may hold another font: sans came out bold. So none is forgotten.
    auto* tools = vtkFreeTypeTools::GetInstance();
    tools->SetMaximumNumberOfFaces(4096);
    tools->SetMaximumNumberOfSizes(4096);
    tools->SetMaximumNumberOfBytes(8 << 20);

    for (const auto font : {Font::sans, Font::bold, Font::mono})
        if (fileOf(font).empty())
            return "the DejaVu fonts are not installed (Debian's package is fonts-dejavu-core): some signs are missing";
    return "";
}

} // namespace rt::viz
