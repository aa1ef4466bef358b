#include "viz/fonts.h"

#include <array>
#include <filesystem>
#include <stdexcept>

#include <vtkFreeTypeTools.h>

namespace rt::viz
{

namespace
{

std::string find(const std::string& file)
{
    for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
                               "/usr/share/fonts/dejavu-sans-mono-fonts", "/usr/share/fonts/dejavu",
                               "/usr/share/fonts/TTF", "/usr/local/share/fonts/dejavu"})
        if (const auto path = std::filesystem::path(folder) / file; std::filesystem::exists(path)) return path.string();
    throw std::runtime_error("the font " + file + " is not installed (Debian's package is fonts-dejavu-core)");
}

} // namespace

const std::string& fontFile(Font font)
{
    static const std::array files{find("DejaVuSans.ttf"), find("DejaVuSans-Bold.ttf"), find("DejaVuSansMono.ttf")};
    return files[std::size_t(font)];
}

void checkFonts()
{
    fontFile(Font::sans);
    // VTK 9.1 counts each colour and size of a font as a face of its own, keeps a few, and looks a forgotten one up in the text
    // property that it was first seen in, which by then may hold another font: sans came out bold. So none is forgotten.
    auto* tools = vtkFreeTypeTools::GetInstance();
    tools->SetMaximumNumberOfFaces(4096);
    tools->SetMaximumNumberOfSizes(4096);
    tools->SetMaximumNumberOfBytes(8 << 20);
}

} // namespace rt::viz
