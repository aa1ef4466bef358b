#include "common/files/picture_file.h"

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

#include "common/files/picture_module.h"
#include "common/files/text_file.h"

namespace rt
{

namespace
{

std::string ending(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

bool isLinear(const std::string& path)
{
    return ending(path) == ".exr" || ending(path) == ".hdr";
}

/// Red, green, blue: a byte each, row by row.
std::string srgbBytes(const Image& image)
{
    if (image.pixels.empty()) throw std::runtime_error("there are no pixels");
    std::string bytes;
    bytes.reserve(image.pixels.size() * 3);
    for (const auto& p : image.pixels)
        for (int c = 0; c < 3; ++c) bytes += char(toSrgb8(p[c]));
    return bytes;
}

std::string ppmBytes(const Image& image)
{
    return fmt::format("P6\n{} {}\n255\n", image.width, image.height) + srgbBytes(image);
}

} // namespace

void checkWritable(const std::string& path)
{
    const auto known = ending(path);
    if (known != ".png" && known != ".ppm" && !isLinear(path))
        throw std::runtime_error(
            fmt::format("{}: pictures end in .png, .ppm (8-bit sRGB), .exr or .hdr (linear), not \"{}\"", path, known));
    if (isLinear(path)) pictureModule(path);
    checkFolder(path);
}

void writeImage(const Image& image, const std::string& path)
{
    checkWritable(path);
    replaceFile(path, [&](const std::string& temporary) {
        if (isLinear(path))
            pictureModule(path).writeLinear(image, temporary);
        else
            writeBytes(temporary, ending(path) == ".png" ? pngBytes(image) : ppmBytes(image));
    });
}

std::string pngBytes(const Image& image)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.width);
    png.height = png_uint_32(image.height);
    png.format = PNG_FORMAT_RGB;
    const std::string pixels = srgbBytes(image);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
        throw std::runtime_error(png.message);
    bytes.resize(size);
    return bytes;
}

Image readImage(const std::string& path)
{
    return pictureModule(path).read(path);
}

} // namespace rt
