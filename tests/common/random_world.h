// For the tests of searches: shapes and rays in every arrangement that boxes might get wrong.
#pragma once

#include <random>

#include <gtest/gtest.h>

#include "common/scene/scene.h"
#include "tests/common/random_scene.h"

namespace rt
{

/// All that a hit says.
template <class Real>
void expectSame(const Hit<Real>& a, const Hit<Real>& b)
{
    EXPECT_EQ(a.I.on, b.I.on);
    EXPECT_EQ(a.t, b.t);
    EXPECT_EQ(Vec3<Real>(a.I), Vec3<Real>(b.I));
    EXPECT_EQ(a.N, b.N);
    EXPECT_EQ(&a.mat, &b.mat);
    EXPECT_EQ(a.inside, b.inside);
}

/// Random things in every arrangement that boxes might get wrong.
struct World
{
    std::mt19937 engine;
    SceneDescription scene{};

    explicit World(unsigned seed) : engine(seed) { scene.materials.push_back({}); }

    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine); }
    Vec3<double> vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
    double anySize(double power) { return std::pow(10.0, in(-power, power)); }

    void spheres(int count, double power)
    {
        for (int i = 0; i < count; ++i)
        {
            SphereDescription sphere{vector(anySize(power)), anySize(power), 0};
            if (power == 0) sphere.radius = in(0.01, 0.3);
            if (!scene.spheres.empty() && below(4) == 0)
            {
                const auto& other = scene.spheres[std::size_t(below(int(scene.spheres.size())))];
                const int how = below(4);
                if (how == 0) sphere = other;                                                  // coincident
                if (how == 1) sphere.center = other.center;                                    // one inside the other
                if (how == 2) sphere.center.x = other.center.x + other.radius + sphere.radius; // touching
                if (how == 3) sphere.radius = other.radius, sphere.center.y = other.center.y;  // a row
            }
            scene.spheres.push_back(sphere);
        }
    }

    void triangles(int count, double power)
    {
        for (int i = 0; i < count; ++i)
        {
            const Vec3<double> a = vector(anySize(power));
            const double size = power == 0 ? 0.3 : anySize(power);
            TriangleDescription triangle{{a, a + vector(size), a + vector(size)}, 0};
            auto& [p, q, r] = triangle.vertices;
            const int how = below(8);
            if (how == 0) p.y = q.y = r.y = 0.25;                           // many in one plane
            if (how == 1) r = p + in(0, 1) * (q - p) + 1e-9 * vector(size); // a needle
            if (how == 2 && !scene.triangles.empty()) triangle = scene.triangles.back();
            if (how == 3 && !scene.triangles.empty())
                q = scene.triangles.back().vertices[0], r = scene.triangles.back().vertices[1];
            scene.triangles.push_back(triangle);
        }
    }

    template <class Real>
    Ray<Real> ray(const Scene<Real>& traced, double power)
    {
        Vec3<Real> O(vector(2 * anySize(power))), target(vector(anySize(power)));
        if (!traced.spheres.empty() && below(2))
        {
            const auto& sphere = traced.spheres[std::size_t(below(int(traced.spheres.size())))];
            // at its middle, at its rim or just beside it
            target = sphere.C + Vec3<Real>(Real(below(3) == 0 ? 0 : in(0.999999, 1.000001)) * sphere.r *
                                           unit(Vec3<Real>(vector(1))));
            if (below(6) == 0) O = sphere.C;
        }
        if (!traced.triangles.empty() && below(2))
        {
            const auto& triangle = traced.triangles[std::size_t(below(int(traced.triangles.size())))];
            const Real s = Real(in(-1, 2)), t = Real(in(-1, 2));
            target = triangle.a + s * (triangle.b - triangle.a) + t * (triangle.c - triangle.a);
            if (below(3) == 0) target = triangle.a;
            if (below(3) == 0) // in its plane
                O = triangle.a + Real(in(-9, 9)) * (triangle.b - triangle.a) +
                    Real(in(-9, 9)) * (triangle.c - triangle.a);
        }
        Ray<Real> result{.O = O, .D = unit(target - O)};
        if (below(4) == 0) // along an axis, or in a plane of two
        {
            result.D[below(3)] = below(2) ? Real(0) : -Real(0);
            if (below(2)) result.D[below(3)] = 0;
            result.D = unit(result.D);
            if (below(2)) result.O[below(3)] = target[below(3)];
        }
        return result;
    }
};

} // namespace rt
