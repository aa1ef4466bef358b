#include "tests/learn/pictures.h"

#include <filesystem>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

Image differenceOf(const Image& a, const Image& b)
{
    Image result(a.width, a.height);
    for (std::size_t i = 0; i < result.pixels.size(); ++i)
    {
        const auto d = abs(a.pixels[i] - b.pixels[i]);
        result.pixels[i] = isFinite(d) ? d : magenta;
    }
    return result;
}

std::string color(int plane, const Vec3<double>& c)
{
    return fmt::format("\033[{};2;{};{};{}m", plane, toSrgb8(c.x), toSrgb8(c.y), toSrgb8(c.z));
}

} // namespace

std::optional<PictureTriple> triple(const std::string& what, const Seen& seen)
{
    const auto end = what.find(".exr: ");
    if (end == std::string::npos || what.find('/') < end) return std::nullopt;
    const fs::path project = RAYTREE_SOURCE_DIR;
    const auto stored = project / "tests/cases/golden" / (what.substr(0, end) + ".exr");
    if (!fs::exists(stored)) return std::nullopt;
    PictureTriple result;
    result.expected = readImage(stored.string());
    result.got = seen.picture;
    const auto comparison = compare(result.got, result.expected, 1e-7, 1e-6);
    if (!comparison.sameSize) return std::nullopt;
    result.difference = differenceOf(result.got, result.expected);
    result.title = fs::path(seen.scene.file).lexically_relative(project).string();
    const auto own = loadScene(seen.scene.file).camera;
    result.x = (2 * std::max(0, comparison.x) + 1) * own.width / (2 * result.got.width);
    result.y = (2 * std::max(0, comparison.y) + 1) * own.height / (2 * result.got.height);
    return result;
}

Image sideBySide(const PictureTriple& triple, int scale)
{
    const int gap = 2, width = triple.expected.width, height = triple.expected.height;
    Image result((3 * width + 2 * gap) * scale, height * scale);
    for (auto& pixel : result.pixels) pixel = {1, 1, 1};
    int left = 0;
    for (const auto* picture : {&triple.expected, &triple.got, &triple.difference})
    {
        for (int y = 0; y < height * scale; ++y)
            for (int x = 0; x < width * scale; ++x) result.at(left + x, y) = picture->at(x / scale, y / scale);
        left += (width + gap) * scale;
    }
    return result;
}

std::string halfBlocks(const PictureTriple& triple)
{
    std::string text;
    for (int y = 0; y + 3 < triple.expected.height; y += 4)
    {
        for (const auto* picture : {&triple.expected, &triple.got, &triple.difference})
        {
            for (int x = 0; x + 1 < picture->width; x += 2)
                text += color(38, picture->at(x, y)) + color(48, picture->at(x, y + 2)) + "\u2580";
            text += "\033[0m ";
        }
        text += '\n';
    }
    return text;
}

} // namespace rt::grade
