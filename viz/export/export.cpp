#include "viz/export/export.h"

#include <filesystem>

#include <unistd.h>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/text_file.h"
#include "lessons/programs/formulas.h"
#include "viz/export/export_gltf.h"
#include "viz/export/export_vtp.h"
#include "viz/html/export_html.h"
#include "viz/state/listing.h"

namespace rt::viz
{

namespace
{

namespace fs = std::filesystem;

std::string page(const Controller& shown)
{
    const auto& tree = shown.tree();
    return htmlPage(
        {tree, shown.scene(), shown.picture(), shown.source().title, listingText(tree.source), lectureFormulas()});
}

struct Format
{
    const char* extension;
    std::string (*contents)(const Controller& shown);
};

constexpr Format formats[] = {
    {".json", [](const Controller& shown) { return toJson(shown.tree()); }},
    {".vtp", [](const Controller& shown) { return vtpText(shown.tree(), shown.scene()); }},
    {".glb", [](const Controller& shown) { return gltfBinary(shown.tree(), shown.scene()); }},
    {".gltf", [](const Controller& shown) { return gltfText(shown.tree(), shown.scene()); }},
    {".html", page},
};

/// That of the file's name, or nothing.
const Format* formatOf(const std::string& path)
{
    const auto extension = fs::path(path).extension();
    for (const auto& format : formats)
        if (extension == format.extension) return &format;
    return nullptr;
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason)
{
    throw std::runtime_error(fmt::format("{}: expected a folder, or a file that ends in .json, .vtp, .glb, .gltf or "
                                         ".html; the folder cannot be made: {}",
                                         path, reason));
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (error) refuse(path, error.message());
}

} // namespace

void checkExport(const std::string& path)
{
    if (formatOf(path)) return checkFolder(path);
    // Nothing is made yet: what is there of the path must be a folder that can be written to.
    std::error_code error;
    fs::path there = fs::absolute(path);
    while (!fs::exists(there, error) && there != there.parent_path()) there = there.parent_path();
    if (!fs::is_directory(there, error)) refuse(path, there.string() + " is no folder");
    if (access(there.c_str(), W_OK) != 0) refuse(path, there.string() + " is not writable");
}

std::vector<std::string> exportTo(const std::string& path, const Controller& controller)
{
    checkExport(path);
    if (!formatOf(path)) makeFolder(path);
    std::vector<std::string> files;
    const auto write = [&](const std::string& file, const Format& format) {
        writeTextFile(file, format.contents(controller));
        files.push_back(file);
    };
    if (const auto* format = formatOf(path))
    {
        write(path, *format);
        return files;
    }
    for (const auto& format : formats)
        write((fs::path(path) / (std::string("ray_tree") + format.extension)).string(), format);
    if (controller.picture().width > 0)
    {
        files.push_back((fs::path(path) / "picture.png").string());
        writeImage(controller.picture(), files.back());
    }
    return files;
}

} // namespace rt::viz
