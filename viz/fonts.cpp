#include "viz/fonts.h"

#include <array>
#include <filesystem>
#include <stdexcept>

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
}

} // namespace rt::viz
