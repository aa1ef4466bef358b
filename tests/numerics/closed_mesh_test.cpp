// Rays do not get out of closed meshes, nor through panes, however near an edge they start and however far off zero the mesh
// is. Scaling by powers of two would not show a bound that is relative to coordinates; moving does.
#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class ClosedMesh : public testing::Test
{
};
TYPED_TEST_SUITE(ClosedMesh, Precisions);

using Triangles = std::vector<std::array<V, 3>>;

/// The cube from -1 to 1, its triangles seen counter-clockwise from outside.
Triangles cube()
{
    Triangles triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1})
        {
            const auto corner = [&](int u, int v) {
                V p;
                p[axis] = side;
                p[(axis + 1) % 3] = u;
                p[(axis + 2) % 3] = v * side;
                return p;
            };
            triangles.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
            triangles.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
        }
    return triangles;
}

/// A ball with dents: each direction has a radius of its own, so that folds are of both kinds.
Triangles dented(Random& random)
{
    const auto ball = *ballMesh(V(0), 1, 2).triangles;
    std::map<std::array<double, 3>, double> radius;
    Triangles triangles = ball;
    for (auto& triangle : triangles)
    {
        for (auto& p : triangle) p *= radius.try_emplace({p.x, p.y, p.z}, random.in(0.7, 1.3)).first->second;
        const auto& [a, b, c] = triangle;
        if (dot(cross(b - a, c - a), a) < 0) std::swap(triangle[1], triangle[2]);
    }
    return triangles;
}

Triangles turned(Triangles triangles, Random& random)
{
    const V x = random.direction(), y = unit(cross(x, random.direction())), z = cross(x, y);
    for (auto& triangle : triangles)
        for (auto& p : triangle) p = p.x * x + p.y * y + p.z * z;
    return triangles;
}

template <class Real>
Scene<Real> sceneOf(Triangles triangles, const V& at)
{
    for (auto& triangle : triangles)
        for (auto& p : triangle) p += at;
    SceneDescription description;
    description.materials.push_back({});
    description.meshes.push_back({.file = "mesh", .triangles = std::make_shared<const Triangles>(triangles)});
    return Scene<Real>(description);
}

/// A point on a side of one of the triangles, or so near it that only rounding tells them apart; of each three one is at a corner.
template <class Real>
Vec3<Real> nearAnEdge(const Scene<Real>& scene, Random& random)
{
    const auto& triangle = scene.triangles[std::size_t(random.in(0, double(scene.triangles.size())))];
    const Real along = std::max(Real(0), Real(random.in(-0.5, 1)));
    const Vec3<Real> p = triangle.a + along * (triangle.b - triangle.a);
    const Real spacing = eps<Real> * (1 + largestChannel(abs(p)));
    return p + spacing * Vec3<Real>(random.vector(-4, 4));
}

/// Follows mirror images from near `at` within the mesh. Half of the rays begin towards an edge.
template <class Real>
void expectNoLeak(const Scene<Real>& scene, const V& at, Random& random, int rays)
{
    for (int i = 0; i < rays; ++i)
    {
        Ray<Real> ray{.O = Vec3<Real>(at + random.vector(-0.2, 0.2)), .D = unit(Vec3<Real>(random.direction()))};
        if (i % 2) ray.D = unit(nearAnEdge(scene, random) - ray.O);
        for (int bounce = 0; bounce < 9; ++bounce)
        {
            const auto hit = scene.intersect(ray);
            ASSERT_TRUE(hit) << "a ray got out at bounce " << bounce << ", mesh at " << at.x;
            ASSERT_TRUE(hit->inside) << "a ray came back in at bounce " << bounce << ", mesh at " << at.x;
            ASSERT_GT(hit->t, 0);
            ASSERT_TRUE(scene.occluded({ray.O, ray.from}, ray.D, infinity<Real>));
            ray = ray.spawn(reflected, hit->I, ray.D - 2 * dot(ray.D, hit->N) * hit->N);
        }
    }
}

TYPED_TEST(ClosedMesh, LetsNoMirrorImageOutWhereverItIs)
{
    using Real = TypeParam;
    Random random(1501);
    for (const double far : {0.0, 1e1, 1e3, 1e5, 1e6})
    {
        for (const V& at : {V(far, 0, 0), V(far, -far, far)}) expectNoLeak(sceneOf<Real>(cube(), at), at, random, 1200);
        if (far > 1e5) continue; // a turned cube is no longer convex there in float
        for (int i = 0; i < 2; ++i)
        {
            const V at = far * random.vector(-1, 1);
            expectNoLeak(sceneOf<Real>(turned(cube(), random), at), at, random, 600);
        }
    }
    for (const double far : {0.0, 1e1, 1e3})
        for (int i = 0; i < 3; ++i)
        {
            const V at = far * random.vector(-1, 1);
            expectNoLeak(sceneOf<Real>(dented(random), at), at, random, 300);
        }
}

/// Rays that hit the mesh from outside, and leave it again in any direction.
template <class Real>
void expectNotMetAgain(const Triangles& triangles, double far, Random& random)
{
    const V at(far, far / 2, -far);
    const auto scene = sceneOf<Real>(triangles, at);
    for (int i = 0; i < 2000; ++i)
    {
        const V from = at + 5.0 * random.direction(), to = at + random.vector(-0.9, 0.9);
        const auto hit = scene.intersect({.O = Vec3<Real>(from), .D = unit(Vec3<Real>(to - from))});
        if (!hit) continue; // float may aim beside it from so far off zero
        ASSERT_FALSE(hit->inside);
        const Vec3<Real> D = unit(Vec3<Real>(random.direction()));
        if (dot(D, hit->N) < 64 * eps<Real> * Real(1 + far)) continue; // a far cube is crooked
        ASSERT_FALSE(scene.intersect({.O = hit->I, .D = D, .from = hit->I.on})) << far;
    }
}

TYPED_TEST(ClosedMesh, IsNotMetAgainFromOutside)
{
    Random random(1502);
    for (const double far : {0.0, 1e1, 1e3, 1e5})
    {
        expectNotMetAgain<TypeParam>(cube(), far, random);
        expectNotMetAgain<TypeParam>(turned(cube(), random), far, random);
    }
}

TYPED_TEST(ClosedMesh, PanesKeepBothSidesDownToTheTypesSpacing)
{
    using Real = TypeParam;
    Random random(1503);
    for (const double x : {0.0, 1.0, 1e3, 1e6})
    {
        const Real front = Real(x), back = x == 0 ? std::numeric_limits<Real>::min() : std::nextafter(front, Real(2e6));
        if (double(back) == x) continue; // a scene's numbers are doubles
        const auto square = [](double at) {
            return Triangles{{V(at, -1, -1), V(at, 1, -1), V(at, 1, 1)}, {V(at, -1, -1), V(at, 1, 1), V(at, -1, 1)}};
        };
        Triangles pane = square(double(front));
        for (const auto& triangle : square(double(back))) pane.push_back(triangle);
        const auto scene = sceneOf<Real>(pane, V(0));
        for (int i = 0; i < 1000; ++i)
        {
            // So near that the two sides' distances differ.
            const Vec3<Real> O(front - 8 * (back - front), Real(random.in(-0.5, 0.5)), Real(random.in(-0.5, 0.5)));
            const Vec3<Real> D = unit(Vec3<Real>(1, Real(random.in(-0.4, 0.4)), Real(random.in(-0.4, 0.4))));
            const auto first = scene.intersect({.O = O, .D = D});
            ASSERT_TRUE(first);
            const auto second = scene.intersect({.O = first->I, .D = D, .from = first->I.on});
            ASSERT_TRUE(second) << "the far side of a pane at " << x;
            EXPECT_NE(first->I.on < 2, second->I.on < 2);
            EXPECT_FALSE(scene.intersect({.O = second->I, .D = D, .from = second->I.on}));
        }
    }
}

} // namespace

} // namespace rt::numerics
