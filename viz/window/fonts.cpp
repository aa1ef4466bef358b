#include "viz/window/fonts.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string_view>
#include <vector>

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextRenderer.h>

#include "viz/base/palette.h"

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

/// For what DejaVu lacks, where Debian's packages fonts-noto-cjk, fonts-droid-fallback, fonts-wqy-microhei, fonts-wqy-zenhei,
/// fonts-symbola and unifont put them. (The colours of fonts-noto-color-emoji are none that FreeType could scale.)
const std::vector<std::string>& otherFiles()
{
    static const auto files = [] {
        std::vector<std::string> found;
        const std::string folder = std::getenv("RAYTREE_FONTS") ? "" : "/usr/share/fonts/";
        for (const char* file :
             {"opentype/noto/NotoSansCJK-Regular.ttc", "truetype/droid/DroidSansFallbackFull.ttf",
              "truetype/wqy/wqy-microhei.ttc", "truetype/wqy/wqy-zenhei.ttc", "truetype/noto/NotoEmoji-Regular.ttf",
              "truetype/ancient-scripts/Symbola_hint.ttf", "opentype/unifont/unifont.otf",
              "opentype/unifont/unifont_upper.otf", "truetype/unifont/unifont.ttf"})
            if (!folder.empty() && std::filesystem::exists(folder + file)) found.push_back(folder + file);
        return found;
    }();
    return files;
}

/// What has no ink of its own: blanks, joiners, and what chooses among looks of the sign before.
bool hasNoInk(char32_t c)
{
    return c == 0xA0 || c == 0xAD || (c >= 0x2000 && c <= 0x200F) || (c >= 0x2028 && c <= 0x202F) ||
           (c >= 0x2060 && c <= 0x206F) || c == 0x3000 || (c >= 0xFE00 && c <= 0xFE0F) || c == 0xFEFF ||
           (c >= 0xE0000 && c <= 0xE01EF);
}

/// VTK leaves out what a font does not have.
bool draws(Font font, int other, const std::string& sign)
{
    vtkNew<vtkTextProperty> property;
    useFont(property, font, other);
    property->SetFontSize(20);
    vtkNew<vtkImageData> drawn;
    int used[2] = {0, 0};
    if (!vtkTextRenderer::GetInstance()->RenderString(property, vtkStdString(sign), drawn, used, 72)) return false;
    const int* sides = drawn->GetDimensions();
    const auto* pixels = static_cast<const Rgba*>(drawn->GetScalarPointer());
    return std::any_of(pixels, pixels + sides[0] * sides[1], [](const Rgba& pixel) { return pixel.a > 0; });
}

constexpr int nothing = -2, standIn = -3;

/// Which font has the sign: an index of otherFiles, -1, `nothing` if there is none to draw, or `standIn`.
int fontOf(Font font, char32_t c, const std::string& sign)
{
    static std::map<std::pair<Font, char32_t>, int> known;
    const auto [entry, isNew] = known.try_emplace({font, c}, standIn);
    auto& found = entry->second;
    if (!isNew) return found;
    if (hasNoInk(c)) return found = c == 0xA0 || c == 0x3000 || (c >= 0x2000 && c <= 0x200A) ? -1 : nothing;
    for (int other = -1; other < int(otherFiles().size()); ++other)
        if (draws(font, other, sign)) return found = other;
    return found;
}

} // namespace

std::vector<FontRun> fontRuns(const std::string& text, Font font)
{
    std::vector<FontRun> runs;
    const auto add = [&](int other, std::string_view piece) {
        if (runs.empty() || runs.back().other != other) runs.push_back({other, ""});
        runs.back().text += piece;
    };
    for (std::size_t i = 0; i < text.size();)
    {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(k < text.size() ? text[k] : 0); };
        const int length = byte(i) < 0x80 ? 1 : byte(i) < 0xE0 ? 2 : byte(i) < 0xF0 ? 3 : 4;
        char32_t c = length == 1 ? byte(i) : byte(i) & (0x7F >> length);
        for (int k = 1; k < length; ++k) c = c << 6 | (byte(i + std::size_t(k)) & 0x3F);
        const auto sign = text.substr(i, std::size_t(length));
        const auto goesOn = [](char byteOfSign) { return (static_cast<unsigned char>(byteOfSign) & 0xC0) == 0x80; };
        if (sign.size() < std::size_t(length) || !std::all_of(sign.begin() + 1, sign.end(), goesOn) || goesOn(sign[0]))
        {
            add(-1, "□"); // no UTF-8
            for (++i; i < text.size() && goesOn(text[i]);) ++i;
            continue;
        }
        const int other = length == 1 ? -1 : fontOf(font, c, sign);
        if (other == standIn)
            add(-1, "□");
        else if (other != nothing)
            add(other, sign);
        i += sign.size();
    }
    return runs;
}

void useFont(vtkTextProperty* property, Font font, int other)
{
    if (other < 0) return useFont(property, font);
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(otherFiles()[std::size_t(other)].c_str());
}

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
