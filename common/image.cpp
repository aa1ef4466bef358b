#include "common/image.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include "common/interrupt.h"

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

/// In the format that the ending of `path` names; into `memory`, if it is given, and not to a file.
void writePixels(const Image& image, const std::string& path, OIIO::Filesystem::IOProxy* memory = nullptr)
{
    auto out = OIIO::ImageOutput::create(path);
    if (!out) throw std::runtime_error(OIIO::geterror());
    const bool linear = isLinear(path);
    OIIO::ImageSpec spec(image.width, image.height, 3, linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    spec.attribute("DateTime", "1970:01:01 00:00:00"); // else EXR takes the clock's, and equal pictures differ
    if ((memory && !out->set_ioproxy(memory)) || !out->open(path, spec)) throw std::runtime_error(out->geterror());
    bool good = true;
    if (linear)
    {
        std::vector<float> values;
        values.reserve(image.pixels.size() * 3);
        for (const auto& p : image.pixels) values.insert(values.end(), {float(p.x), float(p.y), float(p.z)});
        good = out->write_image(OIIO::TypeDesc::FLOAT, values.data());
    }
    else
    {
        std::vector<unsigned char> values;
        values.reserve(image.pixels.size() * 3);
        for (const auto& p : image.pixels) values.insert(values.end(), {toSrgb8(p.x), toSrgb8(p.y), toSrgb8(p.z)});
        good = out->write_image(OIIO::TypeDesc::UINT8, values.data());
    }
    if (!good || !out->close()) throw std::runtime_error(out->geterror());
}

} // namespace

unsigned char toSrgb8(double linear)
{
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    return static_cast<unsigned char>(OIIO::linear_to_sRGB(float(linear)) * 255.0f + 0.5f);
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
    checkFolder(path);
}

void writeImage(const Image& image, const std::string& path)
{
    checkWritable(path);
    replaceFile(path, [&](const std::string& temporary) { writePixels(image, temporary); });
}

std::string pngBytes(const Image& image)
{
    OIIO::Filesystem::IOVecOutput memory;
    writePixels(image, "memory.png", &memory);
    const auto& bytes = memory.buffer();
    return {bytes.begin(), bytes.end()};
}

Image readImage(const std::string& path)
{
    auto in = OIIO::ImageInput::open(path);
    if (!in) throw std::runtime_error(fmt::format("{}: cannot be read as a picture: {}", path, OIIO::geterror()));
    const auto& spec = in->spec();
    const auto channels = std::size_t(spec.nchannels);
    if (spec.width < 1 || spec.height < 1 ||
        std::size_t(spec.width) * std::size_t(spec.height) > (std::size_t(1) << 28))
        throw std::runtime_error(fmt::format("{}: {}x{} pixels, at most 2^28 are read", path, spec.width, spec.height));
    std::vector<float> values(std::size_t(spec.width) * std::size_t(spec.height) * channels);
    if (!in->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data()))
        throw std::runtime_error(fmt::format("{}: cannot be read: {}", path, in->geterror()));
    const bool srgb = !spec.format.is_floating_point();
    Image image(spec.width, spec.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
        {
            const float value = values[i * channels + (channels < 3 ? 0 : c)];
            image.pixels[i][int(c)] = double(srgb ? OIIO::sRGB_to_linear(value) : value);
        }
    return image;
}

void writeTextFile(const std::string& path, const std::string& text)
{
    checkFolder(path);
    replaceFile(path, [&](const std::string& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(text.data(), std::streamsize(text.size()));
        out.close();
        if (!out) throw std::runtime_error("the disk may be full");
    });
}

std::string readTextFile(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf())) throw std::runtime_error(fmt::format("{}: cannot be read", path));
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
