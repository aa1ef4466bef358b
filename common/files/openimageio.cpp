// The module that picture_module.h loads; the one file that needs OpenImageIO.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <OpenImageIO/color.h>
#include <OpenImageIO/imageio.h>

#include "common/base/image.h"
#include "common/files/picture_module.h"

namespace rt
{

namespace
{

/// From version 2.5 on, an error that nobody asked for is printed at the end of the program.
struct ForgetErrors
{
    ~ForgetErrors()
    {
        if (OIIO::has_error()) OIIO::geterror();
    }
};

/// Neither kind of file may show infinity, or nothing, where a pixel is only larger than its numbers can be.
void checkRange(const Image& image, bool isRadiance)
{
    // RGBE: a mantissa of 8 bits and exponents up to 127.
    const double most = isRadiance ? std::ldexp(255.0 / 256, 127) : double(std::numeric_limits<float>::max());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                if (const double value = image.at(x, y)[c]; std::isfinite(value) && std::abs(value) > most)
                    throw std::runtime_error(
                        fmt::format("pixel ({}, {}) has a channel of {:.3g}, expected at most {:.3g} in such a file", x,
                                    y, value, most));
}

void writeLinear(const Image& image, const std::string& path)
{
    const ForgetErrors forget;
    auto out = OIIO::ImageOutput::create(path);
    if (!out) throw std::runtime_error(OIIO::geterror());
    checkRange(image, std::string(out->format_name()) == "hdr");
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("DateTime", "1970:01:01 00:00:00"); // else EXR takes the clock's, and equal pictures differ
    if (!out->open(path, spec)) throw std::runtime_error(out->geterror());
    std::vector<float> values;
    values.reserve(image.pixels.size() * 3);
    for (const auto& p : image.pixels) values.insert(values.end(), {float(p.x), float(p.y), float(p.z)});
    const bool good = out->write_image(OIIO::TypeDesc::FLOAT, values.data());
    if (!good || !out->close()) throw std::runtime_error(out->geterror());
}

/// The numbers of the channels that are red, green and blue; the same one three times for a grey picture.
using Channels = std::array<int, 3>;

std::string lowered(std::string text)
{
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Finds R, G and B by name: alone, or in the one layer that has them (`beauty.R`). Nothing if there is no colour at all.
/// Throws std::runtime_error with a reason if there are several.
std::optional<Channels> colorChannels(const OIIO::ImageSpec& spec)
{
    const auto find = [&](const std::string& name) {
        const auto found = std::ranges::find(spec.channelnames, name, lowered);
        return found == spec.channelnames.end() ? -1 : int(found - spec.channelnames.begin());
    };
    std::vector<std::string> layers;
    std::vector<Channels> found;
    for (const auto& channel : spec.channelnames)
    {
        const auto name = lowered(channel), last = name.substr(name.rfind('.') + 1);
        const auto layer = name.substr(0, name.size() - last.size());
        if (last != "r" && last != "red") continue;
        const bool isLong = last == "red";
        const Channels rgb{find(name), find(layer + (isLong ? "green" : "g")), find(layer + (isLong ? "blue" : "b"))};
        if (rgb[1] < 0 || rgb[2] < 0) continue;
        if (layer.empty()) return rgb;
        layers.push_back(channel.substr(0, layer.size() - 1));
        found.push_back(rgb);
    }
    if (found.size() > 1)
        throw std::runtime_error(
            fmt::format("several layers have colours, {}, expected one, or channels R, G and B outside of layers",
                        fmt::join(layers, ", ")));
    if (found.size() == 1) return found[0];
    if (const int grey = find("y"); grey >= 0 && find("ry") < 0 && find("by") < 0) return Channels{grey, grey, grey};
    return std::nullopt;
}

/// Goes to the one part of the file that has colours; the first one that has them outside of layers wins.
Channels goToColors(OIIO::ImageInput& in)
{
    std::vector<std::string> names;
    for (int part = 0; in.seek_subimage(part, 0); ++part)
    {
        if (const auto channels = colorChannels(in.spec())) return *channels;
        const auto& more = in.spec().channelnames;
        names.insert(names.end(), more.begin(), more.end());
    }
    throw std::runtime_error(
        fmt::format("there are no colours among its channels {}, expected R, G and B", fmt::join(names, ", ")));
}

/// What a .hdr says of its pixels before them: each EXPOSURE and COLORCORR has multiplied their values already.
struct RadianceHeader
{
    Vec3<double> scale{1, 1, 1};
    int orientation = 1; ///< Exif's. OpenImageIO 2.4 confuses +X +Y with -X -Y.
};

RadianceHeader radianceHeader(const std::string& path)
{
    RadianceHeader header;
    std::ifstream file(path, std::ios::binary);
    std::string line;
    const auto divide = [&](const Vec3<double>& by) {
        if (!(std::min({by.x, by.y, by.z}) > 0) || !isFinite(by))
            throw std::runtime_error(fmt::format("'{}' in its header, expected numbers greater than 0", line));
        header.scale /= by;
    };
    while (std::getline(file, line) && !line.empty() && line.size() < 1000)
    {
        double x = 0, y = 0, z = 0;
        if (line.starts_with("EXPOSURE=")) divide(Vec3<double>(std::strtod(line.c_str() + 9, nullptr)));
        if (line.starts_with("COLORCORR="))
            divide(std::sscanf(line.c_str() + 10, "%lf %lf %lf", &x, &y, &z) == 3 ? Vec3<double>(x, y, z)
                                                                                  : Vec3<double>(0));
        if (line.starts_with("FORMAT=") && line.find("xyze") != line.npos)
            throw std::runtime_error("its colours are XYZ, expected FORMAT=32-bit_rle_rgbe");
    }
    std::string outer, inner, number;
    file >> outer >> number >> inner;
    const std::array<std::string, 8> both{"-Y+X", "-Y-X", "+Y-X", "+Y+X", "+X-Y", "-X-Y", "-X+Y", "+X+Y"};
    const auto found = std::ranges::find(both, outer + inner);
    if (found != both.end()) header.orientation = 1 + int(found - both.begin());
    return header;
}

/// Turned as the file says, by the numbers of Exif: from 5 on, rows are columns.
Image oriented(const Image& stored, int orientation)
{
    if (orientation < 2 || orientation > 8) return stored;
    const bool turned = orientation > 4;
    Image image(turned ? stored.height : stored.width, turned ? stored.width : stored.height);
    const int right = stored.width - 1, bottom = stored.height - 1;
    for (int y = 0; y <= bottom; ++y)
        for (int x = 0; x <= right; ++x)
        {
            const bool fromRight = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
            const bool fromBottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
            const int u = fromRight ? right - x : x, v = fromBottom ? bottom - y : y;
            (turned ? image.at(v, u) : image.at(u, v)) = stored.at(x, y);
        }
    return image;
}

void checkSize(int width, int height)
{
    if (width < 1 || height < 1 || std::size_t(width) * std::size_t(height) > (std::size_t(1) << 28))
        throw std::runtime_error(fmt::format("{}x{} pixels, at most 2^28 are read", width, height));
}

/// The whole picture; black where the file stores no pixels, and without those outside.
Image readColors(OIIO::ImageInput& in, const Channels& channels, const Vec3<double>& scale)
{
    const OIIO::ImageSpec spec = in.spec();
    checkSize(spec.width, spec.height);
    checkSize(spec.full_width, spec.full_height);
    const auto count = std::size_t(spec.nchannels);
    std::vector<float> values(std::size_t(spec.width) * std::size_t(spec.height) * count);
    if (!in.read_image(in.current_subimage(), 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data()))
        throw std::runtime_error(fmt::format("cannot be read: {}", in.geterror()));
    const bool srgb = !spec.format.is_floating_point();
    Image image(spec.full_width, spec.full_height);
    for (int row = 0; row < spec.height; ++row)
        for (int column = 0; column < spec.width; ++column)
        {
            const int x = column + spec.x - spec.full_x, y = row + spec.y - spec.full_y;
            if (x < 0 || x >= image.width || y < 0 || y >= image.height) continue;
            const auto first = (std::size_t(row) * std::size_t(spec.width) + std::size_t(column)) * count;
            for (int c = 0; c < 3; ++c)
            {
                const float value = values[first + std::size_t(channels[std::size_t(c)])];
                image.at(x, y)[c] = double(srgb ? OIIO::sRGB_to_linear(value) : value) * scale[c];
            }
        }
    return image;
}

Image read(const std::string& path)
{
    const ForgetErrors forget;
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1); // a transparent sky has the colours that are stored
    auto in = OIIO::ImageInput::open(path, &wishes);
    if (!in) throw std::runtime_error(fmt::format("{}: cannot be read as a picture: {}", path, OIIO::geterror()));
    try
    {
        const bool isRadiance = std::string(in->format_name()) == "hdr";
        const auto header = isRadiance ? radianceHeader(path) : RadianceHeader{};
        const auto channels = goToColors(*in);
        const int orientation = isRadiance ? header.orientation : in->spec().get_int_attribute("Orientation", 1);
        return oriented(readColors(*in, channels, header.scale), orientation);
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
    }
}

} // namespace

} // namespace rt

extern "C" const rt::PictureModule raytreePictureModule;
const rt::PictureModule raytreePictureModule{rt::writeLinear, rt::read};
