// The module that picture_module.h loads; the one file that needs OpenImageIO.
#include <stdexcept>

#include <fmt/format.h>
#include <OpenImageIO/color.h>
#include <OpenImageIO/imageio.h>

#include "common/image.h"
#include "common/picture_module.h"

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

void writeLinear(const Image& image, const std::string& path)
{
    const ForgetErrors forget;
    auto out = OIIO::ImageOutput::create(path);
    if (!out) throw std::runtime_error(OIIO::geterror());
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

Image read(const std::string& path)
{
    const ForgetErrors forget;
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

} // namespace

} // namespace rt

extern "C" const rt::PictureModule raytreePictureModule;
const rt::PictureModule raytreePictureModule{rt::writeLinear, rt::read};
