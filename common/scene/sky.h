// What rays see that leave the scene.
#pragma once

#include <array>
#include <numbers>

#include "common/base/portable.h"
#include "common/scene/scene_description.h"

namespace rt
{

/// Where a direction lies in an image of the sky: u to the right, v down, both in [0, 1]. Exercise 04 replaces the first.
template <std::floating_point Real>
struct SkyFormulas
{
    using vec3 = Vec3<Real>;
    using vec2 = std::array<Real, 2>;
    static constexpr Real PI = std::numbers::pi_v<Real>;

    /// Longitude and angle to the zenith: -z is the middle (0.5, 0.5), +x is to its right, +y is the top edge v = 0.
    static vec2 latLong(const vec3& D)
    {
        // SOLUTION 04-latlong
        const Real longitude = portable::atan2(D.x, -D.z);                  // -pi .. pi
        const Real polar = portable::atan2(portable::hypot(D.x, D.z), D.y); // 0 at the zenith .. pi
        return {Real(0.5) + longitude / (2 * PI), polar / PI};
        // END
    }

    /// Debevec's angular map: the distance from the middle is the angle to -z, the rim is +z.
    static vec2 angularMap(const vec3& D)
    {
        const Real across = portable::hypot(D.x, D.y);
        if (across == 0) return {D.z < 0 ? Real(0.5) : Real(1), Real(0.5)};
        const Real r = portable::atan2(across, -D.z) / PI;
        return {(1 + D.x / across * r) / 2, (1 - D.y / across * r) / 2};
    }
};

/// The sky in the tracer's scalar type.
template <std::floating_point Real>
class Sky
{
public:
    explicit Sky(const SkyDescription& sky)
        : horizon(narrowColor<Real>(sky.color, sky.zenith ? "sky.horizon" : "sky.color")),
          zenith(narrowColor<Real>(sky.zenith.value_or(sky.color), "sky.zenith")), gradient(sky.zenith.has_value()),
          mapping(sky.mapping), image(sky.image)
    {
        if (!sky.sun) return;
        sun = unit(Vec3<Real>(unit(Vec3<Wide<Real>>(sky.sun->direction))));
        sunColor = narrowColor<Real>(sky.sun->color, "sky.sun.color");
        sunChord = 2 * portable::sin(Real(sky.sun->size) / 4 * SkyFormulas<Real>::PI / 180);
    }

    /// What a ray in direction D (unit) sees; any non-negative value, often far above 1.
    template <class Formulas = SkyFormulas<Real>>
    Vec3<Real> color(const Vec3<Real>& D, const Formulas& formulas = {}) const
    {
        if (sunChord >= 0 && length(D - sun) <= sunChord) return sunColor;
        if (image)
        {
            const auto [u, v] = mapping == SkyMapping::latlong ? formulas.latLong(D) : SkyFormulas<Real>::angularMap(D);
            return lookUp(u, v);
        }
        if (!gradient) return horizon;
        const Real height = std::clamp<Real>(D.y, 0, 1);
        return (1 - height) * horizon + height * zenith;
    }

    /// The largest channel anywhere in the sky.
    Real brightest() const
    {
        Real most = std::max({largestChannel(horizon), largestChannel(zenith), largestChannel(sunColor)});
        if (image)
            for (const auto& texel : image->pixels) most = std::max(most, Real(largestChannel(texel)));
        return most;
    }

private:
    Vec3<Real> horizon, zenith;
    bool gradient;
    Vec3<Real> sun{0, 0, 0}, sunColor{0, 0, 0};
    Real sunChord = -1; ///< from the middle of its disc to the edge, as points of the unit sphere; -1: there is no sun
    SkyMapping mapping;
    std::shared_ptr<const Image> image;

    /// Bilinear between the four nearest texels; a lat-long image is closed at its left and right edges.
    Vec3<Real> lookUp(Real u, Real v) const
    {
        u = u > 0 ? std::min<Real>(u, 1) : 0; // whatever an exercise returns, NaN too, is a place in the picture
        v = v > 0 ? std::min<Real>(v, 1) : 0;
        const Real x = u * Real(image->width) - Real(0.5), y = v * Real(image->height) - Real(0.5);
        const Real left = std::floor(x), top = std::floor(y), fx = x - left, fy = y - top;
        const auto texel = [&](int dx, int dy) {
            const int last = image->width - 1;
            int column = int(left) + dx;
            if (mapping == SkyMapping::latlong)
                column = column < 0 ? last : column > last ? 0 : column;
            else
                column = std::clamp(column, 0, last);
            return Vec3<Real>(image->at(column, std::clamp(int(top) + dy, 0, image->height - 1)));
        };
        return (1 - fy) * ((1 - fx) * texel(0, 0) + fx * texel(1, 0)) +
               fy * ((1 - fx) * texel(0, 1) + fx * texel(1, 1));
    }
};

} // namespace rt
