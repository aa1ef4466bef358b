#include "common/image.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include "common/interrupt.h"
#include "common/picture_module.h"

namespace rt
{

namespace fs = std::filesystem;

namespace
{

std::string ending(const std::string& path)
{
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

bool isLinear(const std::string& path)
{
    return ending(path) == ".exr" || ending(path) == ".hdr";
}

/// The first argument of `write` is a temporary path beside `path`, with the same ending. If it throws, nothing is left.
void replaceFile(const std::string& path, const std::function<void(const std::string&)>& write)
{
    const fs::path target(path);
    const auto temporary =
        (target.parent_path() / fmt::format(".part-{}-{}", getpid(), target.filename().string())).string();
    const auto remove = [&temporary] {
        std::error_code ignored;
        fs::remove(temporary, ignored);
    };
    const UndoAtInterrupt undo(remove);
    try
    {
        write(temporary);
        noteWritten();
        fs::rename(temporary, target);
    }
    catch (const std::exception& error)
    {
        remove();
        throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, error.what()));
    }
}

void writeBytes(const std::string& path, const std::string& bytes)
{
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    out.close();
    if (!out) throw std::runtime_error("the disk may be full");
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

unsigned char toSrgb8(double linear)
{
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    const auto x = float(linear);
    const float srgb = x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1.f / 2.4f) - 0.055f;
    return static_cast<unsigned char>(srgb * 255.0f + 0.5f);
}

void checkFolder(const std::string& path)
{
    const auto folder = fs::absolute(path).parent_path();
    if (!fs::is_directory(folder))
        throw std::runtime_error(fmt::format("{}: there is no folder {}", path, folder.string()));
    if (access(folder.c_str(), W_OK) != 0)
        throw std::runtime_error(fmt::format("{}: the folder {} is not writable", path, folder.string()));
    if (fs::is_directory(path)) throw std::runtime_error(fmt::format("{}: is a folder, expected a file", path));
}

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

void writeTextFile(const std::string& path, const std::string& text)
{
    checkFolder(path);
    replaceFile(path, [&](const std::string& temporary) { writeBytes(temporary, text); });
}

std::string readTextFile(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    // An empty file is a text too, though << fails where there is nothing to pass on.
    const bool isEmpty = in && in.peek() == std::ifstream::traits_type::eof() && !in.bad();
    if (!isEmpty && (!in || !(text << in.rdbuf()))) throw std::runtime_error(fmt::format("{}: cannot be read", path));
    return text.str();
}

Comparison compare(const Image& a, const Image& b, double absolute, double relative)
{
    Comparison result;
    result.sameSize = a.width == b.width && a.height == b.height;
    if (!result.sameSize) return result;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
        {
            bool wrong = false;
            for (int c = 0; c < 3; ++c)
            {
                const double p = a.at(x, y)[c], q = b.at(x, y)[c], difference = std::abs(p - q);
                if (!(std::isfinite(p) && std::isfinite(q) && difference <= absolute + relative * std::abs(q)))
                    wrong = true;
                if (result.x < 0 || difference > result.worst || std::isnan(difference))
                {
                    result.worst = difference;
                    result.x = x;
                    result.y = y;
                }
            }
            result.wrong += wrong;
        }
    return result;
}

} // namespace rt
