#include "metrics.h"

namespace rt::lesson10
{

Errors errorsAgainst(const Image& image, const Image& reference)
{
    Errors errors;
    double squares = 0, relativeSquares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
    {
        const auto &p = image.pixels[i], &q = reference.pixels[i];
        const bool finite = isFinite(p);
        double worst = 0;
        for (int c = 0; c < 3; ++c)
        {
            const double off = finite ? std::abs(p[c] - q[c]) : 1;
            const double relative = off / std::max(std::abs(q[c]), 1.0 / 255);
            squares += off * off;
            relativeSquares += relative * relative;
            worst = std::max(worst, off);
            errors.maxRelative = std::max(errors.maxRelative, relative);
        }
        errors.maxAbsolute = std::max(errors.maxAbsolute, worst);
        errors.visible += worst > 1.0 / 255;
        errors.nonFinite += !finite;
    }
    const double channels = 3 * double(image.pixels.size());
    errors.rms = std::sqrt(squares / channels);
    errors.rmsRelative = std::sqrt(relativeSquares / channels);
    errors.psnr = errors.rms > 0 ? -20 * std::log10(errors.rms) : infinity<double>;
    return errors;
}

int pixelsOff(const Image& image, const Image& reference, double tolerance)
{
    return compare(image, reference, tolerance, 0).wrong;
}

Rays raysAgainst(const std::vector<PixelFacts>& facts, const std::vector<PixelFacts>& reference)
{
    Rays rays;
    std::int64_t total = 0;
    for (std::size_t i = 0; i < facts.size(); ++i)
    {
        total += facts[i].rays;
        rays.wrongFirst += facts[i].first != reference[i].first;
        rays.wrongShape += facts[i].shape != reference[i].shape;
        rays.acnePixels += facts[i].acne > 0;
        rays.leakPixels += facts[i].leaks > 0;
    }
    rays.perPixel = double(total) / double(facts.size());
    return rays;
}

} // namespace rt::lesson10
