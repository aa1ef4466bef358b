// How far two linear pictures are from each other, as one line of JSON.
#include <iostream>

#include <fmt/format.h>
#include <OpenImageIO/imageio.h>

#include "common/program/cli.h"
#include "common/program/guarded_main.h"
#include "lessons/10_speed_and_accuracy/study/metrics.h"

namespace
{

/// The numbers of the file as they are: common/base/image.h takes whole numbers for sRGB, POV-Ray's linear ones are not.
rt::Image linearImage(const std::string& path)
{
    const auto file = OIIO::ImageInput::open(path);
    // Its error is read, and not only told of: OpenImageIO 2.5 prints what nobody read when the program ends.
    if (!file) throw std::runtime_error(fmt::format("{}: cannot be read as a picture: {}", path, OIIO::geterror()));
    const auto& spec = file->spec();
    std::vector<float> values(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    if (spec.nchannels < 3 || !file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
        throw std::runtime_error(
            fmt::format("{}: expected a picture of three channels, and all of it {}", path, file->geterror()));
    rt::Image image(spec.width, spec.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) image.pixels[i][c] = values[i * std::size_t(spec.nchannels) + std::size_t(c)];
    return image;
}

int run(int argc, char** argv)
{
    rt::CommandLine app("PSNR of a linear picture against a reference, peak 1, both clamped to [0, 1].",
                        "picture_psnr");
    std::string picture, reference;
    app.option("picture", picture, "linear: .exr, or .png of 16 bits").required().type("FILE");
    app.option("reference", reference, "the same").required().type("FILE");
    return rt::runMain(app, argc, argv, [&] {
        rt::Image a = linearImage(picture), b = linearImage(reference);
        if (a.width != b.width || a.height != b.height)
            throw std::runtime_error(fmt::format("{} has {}x{} pixels, {} has {}x{}; expected the same size", picture,
                                                 a.width, a.height, reference, b.width, b.height));
        for (auto* image : {&a, &b})
            for (auto& pixel : image->pixels)
                for (int c = 0; c < 3; ++c) // a NaN stays one
                    pixel[c] = pixel[c] < 0 ? 0 : pixel[c] > 1 ? 1 : pixel[c];
        const auto errors = rt::lesson10::errorsAgainst(a, b);
        // Nothing is infinite in JSON; 999 is more than doubles can show.
        std::cout << fmt::format("{{\"psnr\": {:.2f}, \"visible\": {}, \"pixels\": {}, \"not_finite\": {}}}\n",
                                 std::min(errors.psnr, 999.0), errors.visible, a.pixels.size(), errors.nonFinite);
        return int(rt::exitDone);
    });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
