#include "make_sky.h"

#include <numbers>

namespace rt
{

namespace
{

using Color = Vec3<double>;

double smooth(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Color skyColor(const Vec3<double>& D)
{
    const Vec3<double> sun = unit(Vec3<double>(-7, 9, 9));
    const double angle = std::acos(std::clamp(dot(D, sun), -1.0, 1.0)); // radians from the middle of the sun
    const Color haze(1.0, 0.93, 0.82), blue(0.12, 0.28, 0.72), sand(0.32, 0.27, 0.2);
    const double height = std::pow(std::abs(D.y), 0.5);

    Color color = D.y > 0 ? (1 - height) * haze + height * blue : (1 - height) * 0.6 * haze + height * sand;
    const double streaks = std::sin(9 * D.x + 4 * std::sin(3 * D.z)) * std::sin(13 * D.z + 5 * D.y) * D.y;
    if (D.y > 0) color += 0.6 * smooth(0.1, 0.5, streaks) * Color(1, 0.97, 0.93);
    color += 2.5 * std::exp(-angle * angle * 40) * Color(1, 0.85, 0.6);
    return angle < 0.06 ? Color(100, 95, 85) : color;
}

} // namespace

Image makeSky(int height)
{
    constexpr double PI = 3.14159265358979323846;
    Image image(2 * height, height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
        {
            const double longitude = ((x + 0.5) / image.width - 0.5) * 2 * PI, latitude = (y + 0.5) / image.height * PI;
            image.at(x, y) = skyColor({std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                                       -std::sin(latitude) * std::cos(longitude)});
        }
    return image;
}

} // namespace rt
