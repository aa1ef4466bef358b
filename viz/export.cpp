#include "viz/export.h"

#include <filesystem>

#include <fmt/format.h>

#include "lessons/formulas.h"
#include "viz/export_gltf.h"
#include "viz/export_html.h"
#include "viz/export_vtp.h"
#include "viz/listing.h"

namespace rt::viz
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* formats[] = {".json", ".vtp", ".glb", ".gltf", ".html"};

bool isFormat(const std::string& extension)
{
    return std::find(std::begin(formats), std::end(formats), extension) != std::end(formats);
}

std::string contents(const std::string& format, const Controller& controller)
{
    const auto& tree = controller.tree();
    if (format == ".json") return toJson(tree);
    if (format == ".vtp") return vtpText(tree, controller.scene());
    if (format == ".glb") return gltfBinary(tree, controller.scene());
    if (format == ".gltf") return gltfText(tree, controller.scene());
    return htmlPage({tree, controller.scene(), controller.picture(), controller.source().title,
                     listingText(tree.source), lectureFormulas()});
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (error || !fs::is_directory(path))
        throw std::runtime_error(
            fmt::format("{}: expected a folder, or a file that ends in .json, .vtp, .glb, .gltf or "
                        ".html; the folder cannot be made{}",
                        path, error ? ": " + error.message() : ""));
}

} // namespace

void checkExport(const std::string& path)
{
    if (isFormat(fs::path(path).extension())) return checkFolder(path);
    makeFolder(path);
    checkFolder(path + "/picture.png"); // a name in it
}

std::vector<std::string> exportTo(const std::string& path, const Controller& controller)
{
    checkExport(path);
    std::vector<std::string> files;
    const auto write = [&](const std::string& file, const std::string& format) {
        writeTextFile(file, contents(format, controller));
        files.push_back(file);
    };
    if (isFormat(fs::path(path).extension()))
    {
        write(path, fs::path(path).extension());
        return files;
    }
    for (const auto* format : formats) write((fs::path(path) / (std::string("ray_tree") + format)).string(), format);
    if (controller.picture().width > 0)
    {
        files.push_back((fs::path(path) / "picture.png").string());
        writeImage(controller.picture(), files.back());
    }
    return files;
}

} // namespace rt::viz
