#include "common/base/image.h"

#include <cmath>

namespace rt
{

unsigned char toSrgb8(double linear)
{
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    const auto x = float(linear);
    const float srgb = x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1.f / 2.4f) - 0.055f;
    return static_cast<unsigned char>(srgb * 255.0f + 0.5f);
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
