// Surfaces that lie on one another: which one a ray meets is decided by what they are, never by rounding. So the same ray meets
// the same surfaces in the same order wherever the scene is moved to, however it is turned, in all types and instruction sets.
#include <map>

#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class Coincident : public testing::Test
{
};
TYPED_TEST_SUITE(Coincident, Precisions);

using Triangles = std::vector<std::array<V, 3>>;

/// A turn about the origin and a move, in which directions turn only.
struct Frame
{
    V x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, at{0, 0, 0};

    V direction(const V& v) const { return v.x * x + v.y * y + v.z * z; }
    V point(const V& v) const { return at + direction(v); }
};

/// Moved along axes, and turned as well.
std::vector<Frame> frames(Random& random)
{
    std::vector<Frame> all(1);
    for (const double far : {0.3, 10.0, 1000.0})
    {
        all.push_back({.at = far * random.vector(-1, 1)});
        const V x = random.direction(), y = unit(cross(x, random.direction()));
        all.push_back({x, y, cross(x, y), far * random.vector(-1, 1)});
    }
    return all;
}

/// The box from low to high, seen counter-clockwise from outside.
Triangles box(const V& low, const V& high, const Frame& frame)
{
    Triangles triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true})
        {
            const auto corner = [&](bool u, bool v) {
                V p;
                p[axis] = upper ? high[axis] : low[axis];
                const int b = (axis + 1) % 3, c = (axis + 2) % 3;
                p[b] = u ? high[b] : low[b];
                p[c] = v == upper ? high[c] : low[c];
                return frame.point(p);
            };
            triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
            triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
    return triangles;
}

enum
{
    opaque,
    glass,
    paint ///< opaque as well
};

SceneDescription empty()
{
    SceneDescription scene;
    scene.materials = {{.name = "opaque"}, {.name = "glass", .ior = 1.5}, {.name = "paint", .color = V(0.5)}};
    return scene;
}

void addMesh(SceneDescription& scene, const Triangles& triangles, int material)
{
    scene.meshes.push_back(
        {.file = "mesh", .triangles = std::make_shared<const Triangles>(triangles), .material = material});
}

/// The names of what a ray meets that goes straight on through everything: "<" behind what it gets out of.
template <class Real>
std::string met(const Scene<Real>& scene, const Frame& frame, const V& from, const V& to, int most = 9)
{
    Ray<Real> ray{.O = Vec3<Real>(frame.point(from)), .D = unit(Vec3<Real>(frame.direction(to - from)))};
    std::string names;
    for (int i = 0; i < most; ++i)
    {
        const bool occluded = scene.occluded({ray.O, ray.from}, ray.D, infinity<Real>);
        const auto hit = scene.intersect(ray);
        EXPECT_EQ(occluded, hit.has_value());
        if (!hit) break;
        EXPECT_GT(hit->t, 0);
        EXPECT_LE(dot(ray.D, hit->N), 0);
        const auto name = scene.primitiveName(hit->I.on);
        names += name.substr(0, name.find(".")) + (hit->inside ? "< " : " ");
        ray = ray.spawn(transmitted, hit->I, ray.D);
    }
    return names;
}

/// Calls test(scene, frame) for the scene that build(frame) describes, in all frames and both instruction sets.
template <class Real, class Describe, class Test>
void everywhere(unsigned seed, Describe&& describe, Test&& test)
{
    Random random(seed);
    for (const auto& frame : frames(random))
        for (const auto instructions : {Instructions::baseline, bestInstructions()})
        {
            Scene<Real> scene(describe(frame));
            scene.instructions = instructions;
            for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) test(scene, frame, random);
            ASSERT_FALSE(testing::Test::HasFailure()) << "at " << frame.at.x << ", turned to " << frame.y.x;
        }
}

/// What rays meet between random places, above y = 0 and below.
auto downAndUp(const std::string& down, const std::string& up)
{
    return [=](const auto& scene, const Frame& frame, Random& random) {
        const V above = random.vector(1, 2), below = random.vector(-2, -1);
        EXPECT_EQ(met(scene, frame, above, below), down);
        EXPECT_EQ(met(scene, frame, below, above), up);
    };
}

TYPED_TEST(Coincident, GlassCubeStandsOnItsFloor)
{
    everywhere<TypeParam>(
        1601,
        [](const Frame& frame) {
            auto scene = empty();
            scene.planes.push_back(
                {.point = frame.point({0, -1, 0}), .normal = frame.direction({0, 1, 0}), .material = opaque});
            addMesh(scene, box(V(-1), V(1), frame), glass);
            return scene;
        },
        [](const auto& scene, const Frame& frame, Random& random) {
            const V above(random.in(-0.9, 0.9), 3, random.in(-0.9, 0.9)), on(above.x * 0.5, -1, above.z);
            const V below(above.x, -3, above.z);
            // Through a gap of air without width.
            EXPECT_EQ(met(scene, frame, above, on), "mesh0 mesh0< plane0 ");
            EXPECT_EQ(met(scene, frame, on * 0.9, on), "mesh0< plane0 ");
            EXPECT_EQ(met(scene, frame, below, on), "plane0< mesh0 mesh0< ");
            // Beside the cube there is the floor alone.
            EXPECT_EQ(met(scene, frame, V(1.5, 1, 0), V(1.5 + random.in(0, 1), -1, random.in(-1, 1))), "plane0 ");
        });
}

TYPED_TEST(Coincident, RaysReflectedByTheFloorUnderGlassGetIntoTheGlass)
{
    using Real = TypeParam;
    everywhere<Real>(
        1602,
        [](const Frame& frame) {
            auto scene = empty();
            addMesh(scene, box(V(-1), V(1), frame), glass);
            scene.planes.push_back(
                {.point = frame.point({0, -1, 0}), .normal = frame.direction({0, -1, 0}), .material = opaque});
            return scene;
        },
        [](const auto& scene, const Frame& frame, Random& random) {
            const auto from = frame.point(random.vector(-0.5, 0.5));
            Ray<Real> ray{.O = Vec3<Real>(from), .D = unit(Vec3<Real>(frame.direction({0.3, -1, 0.2})))};
            const auto bottom = scene.intersect(ray);
            ray = ray.spawn(transmitted, bottom->I, ray.D);
            const auto floor = scene.intersect(ray);
            ASSERT_TRUE(floor && scene.primitiveName(floor->I.on) == "plane0");
            ray = ray.spawn(reflected, floor->I, ray.D - 2 * dot(ray.D, floor->N) * floor->N);
            EXPECT_TRUE(scene.occluded({ray.O, ray.from}, ray.D, std::numeric_limits<Real>::min()));
            const auto again = scene.intersect(ray);
            ASSERT_TRUE(again);
            EXPECT_FALSE(again->inside);
            EXPECT_EQ(scene.primitiveName(again->I.on).substr(0, 5), "mesh0");
            // And what the bottom reflects stays within.
            ray = ray.spawn(reflected, again->I, -ray.D);
            const auto back = scene.intersect(ray);
            EXPECT_TRUE(back && scene.primitiveName(back->I.on) == "plane0");
        });
}

TYPED_TEST(Coincident, BoxesSideBySideAreLeftBeforeTheNextIsEntered)
{
    everywhere<TypeParam>(
        1603,
        [](const Frame& frame) {
            auto scene = empty();
            // Of different size, so that no corners are common.
            addMesh(scene, box(V(0, -1.3, -1.7), V(1, 1.2, 1.1), frame), glass);
            addMesh(scene, box(V(-1), V(0, 1, 1), frame), glass);
            return scene;
        },
        [](const auto& scene, const Frame& frame, Random& random) {
            const V left(-3, random.in(-0.5, 0.5), random.in(-0.5, 0.5)), right(3, random.in(-0.5, 0.5), 0.1);
            EXPECT_EQ(met(scene, frame, left, right), "mesh1 mesh1< mesh0 mesh0< ");
            EXPECT_EQ(met(scene, frame, right, left), "mesh0 mesh0< mesh1 mesh1< ");
        });
}

TYPED_TEST(Coincident, PlanesAlikeAreOne)
{
    everywhere<TypeParam>(
        1604,
        [](const Frame& frame) {
            auto scene = empty();
            for (const double height : {0.3, -2.0, 0.7}) // the same plane, by other points of it
                scene.planes.push_back({.point = frame.point({height, 0, 2 * height}),
                                        .normal = frame.direction({0, height, 0}),
                                        .material = height < 0 ? opaque : paint});
            return scene;
        },
        downAndUp("plane0 ", "plane0< "));
}

TYPED_TEST(Coincident, HalfSpacesOfGlassHaveAGap)
{
    everywhere<TypeParam>(
        1605,
        [](const Frame& frame) {
            auto scene = empty();
            for (const double up : {1.0, -1.0})
                scene.planes.push_back(
                    {.point = frame.point({up, 0, 3}), .normal = frame.direction({0, up, 0}), .material = glass});
            scene.planes.push_back({.point = frame.point({0, 0, 0}), .normal = frame.direction({0, 1, 0})});
            return scene;
        },
        downAndUp("plane1< plane2 plane0 ", "plane0< plane2< plane1 "));
}

TYPED_TEST(Coincident, ATriangleIsSeenOnItsPlane)
{
    everywhere<TypeParam>(
        1606,
        [](const Frame& frame) {
            auto scene = empty();
            scene.planes.push_back({.point = frame.point({5, 0, 7}), .normal = frame.direction({0, 1, 0})});
            scene.triangles.push_back(
                {{frame.point({-1, 0, -1}), frame.point({2, 0, -1}), frame.point({-1, 0, 2})}, paint});
            scene.triangles.push_back(
                {{frame.point({-1, 0, 2}), frame.point({2, 0, -1}), frame.point({-1, 0, -1})}, paint});
            return scene;
        },
        [](const auto& scene, const Frame& frame, Random& random) {
            const V on(random.in(-0.7, 0.3), 0, random.in(-0.7, 0.3)), beside = on + V(2, 0, 2);
            const V away(random.in(-2, 2), random.in(0.5, 2), 0);
            for (const double side : {1.0, -1.0})
            {
                EXPECT_EQ(met(scene, frame, on + side * away, on).substr(0, 9), "triangle0") << side;
                EXPECT_EQ(met(scene, frame, beside + side * away, beside), side > 0 ? "plane0 " : "plane0< ");
                EXPECT_EQ(met(scene, frame, on + side * away, on).find(' '),
                          met(scene, frame, on + side * away, on).size() - 1);
            }
        });
}

TYPED_TEST(Coincident, EqualSpheresAreOne)
{
    everywhere<TypeParam>(
        1607,
        [](const Frame& frame) {
            auto scene = empty();
            for (const int material : {glass, opaque, glass})
                scene.spheres.push_back({frame.point({0.1, 0.2, 0.3}), 0.7, material});
            return scene;
        },
        [](const auto& scene, const Frame& frame, Random& random) {
            EXPECT_EQ(met(scene, frame, 3.0 * random.direction(), random.vector(0, 0.2)), "sphere0 sphere0< ");
        });
}

TEST(Coincidence, IsWhatTheFileSaysAndNoMore)
{
    const auto sheetsWith = [](const std::array<V, 3>& triangle) {
        auto scene = empty();
        scene.planes.push_back({.point = {0, 1e6, 0}});
        scene.triangles.push_back({{V(0, 1e6, 0), V(1, 1e6, 0), V(1, 1e6, 1)}, opaque});
        scene.triangles.push_back({triangle, glass});
        const auto sheets = CoincidentSurfaces(scene).sheets();
        EXPECT_EQ(sheets.size(), 1u);
        return sheets.empty() ? 0 : sheets[0].triangles.size();
    };
    EXPECT_EQ(sheetsWith({V(5, 1e6, 0), V(6, 1e6, 0), V(5, 1e6, 1)}), 2u);
    const double next = std::nextafter(1e6, 2e6); // a pane may be as thin as that
    EXPECT_EQ(sheetsWith({V(5, next, 0), V(6, next, 0), V(5, next, 1)}), 1u);

    auto scene = empty();
    scene.triangles.push_back({{V(0, 0, 0), V(1, 0, 0), V(1, 0, 1)}, opaque});
    scene.triangles.push_back({{V(0, 0, 0), V(1, 0, 1), V(0, 0, 1)}, opaque}); // side by side
    EXPECT_TRUE(CoincidentSurfaces(scene).sheets().empty());
    scene.triangles.push_back({{V(0.1, 0, 0.2), V(0.9, 0, 0.2), V(0, 0, 3)}, opaque});
    EXPECT_EQ(CoincidentSurfaces(scene).sheets().size(), 1u);
    EXPECT_EQ(CoincidentSurfaces(scene).sheets()[0].triangles.size(), 3u);
}

/// Those of each pair of objects, put together: what all of them at once must give.
std::size_t sheetsByPairs(const SceneDescription& scene)
{
    std::vector<std::size_t> first{0}; // triangle of each mesh
    for (const auto& mesh : scene.meshes) first.push_back(first.back() + mesh.triangles->size());
    std::vector<int> group(first.back());
    std::iota(group.begin(), group.end(), 0);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
        {
            auto pair = empty();
            pair.meshes = {scene.meshes[k], scene.meshes[i]};
            const auto all = [&](int triangle) {
                const auto its = std::size_t(triangle), count = pair.meshes[0].triangles->size();
                return its < count ? first[k] + its : first[i] + its - count;
            };
            for (const auto& sheet : CoincidentSurfaces(pair).sheets())
                for (const int triangle : sheet.triangles)
                {
                    const int from = group[all(triangle)], to = group[all(sheet.triangles[0])];
                    std::replace(group.begin(), group.end(), from, to);
                }
        }
    std::map<int, int> size;
    for (const int one : group) ++size[one];
    return std::size_t(std::ranges::count_if(size, [](const auto& one) { return one.second > 1; }));
}

TEST(Coincidence, OfManyObjectsIsThatOfTheirPairs)
{
    Random random(1608);
    for (const auto& frame : frames(random))
    {
        auto scene = empty();
        const auto grid = [&] { return std::round(random.in(-4, 4)); }; // so that many faces share a plane
        for (int i = 0; i < 40; ++i)
        {
            const V low(grid(), grid(), grid());
            addMesh(scene, box(low, low + V(1 + std::abs(grid()), 1, 1 + std::abs(grid())), frame), i % 2);
        }
        const auto sheets = CoincidentSurfaces(scene).sheets();
        EXPECT_EQ(sheets.size(), sheetsByPairs(scene)) << "at " << frame.at.x << ", turned to " << frame.y.x;
        EXPECT_GT(sheets.size(), 5u);
    }
}

TEST(Coincidence, IsFoundAmongManyTrianglesOfOnePlane)
{
    // 80,000 of them, in two nets over one another: their pairs are 10^9 and more, those that meet few.
    auto scene = empty();
    for (const double shift : {0.0, 0.5})
    {
        Triangles net;
        for (int x = 0; x < 141; ++x)
            for (int z = 0; z < 141; ++z)
            {
                const V at(x + shift, 0, z + 0.6 * shift); // not along the diagonals: all hang together
                net.push_back({at, at + V(1, 0, 0), at + V(1, 0, 1)});
                net.push_back({at, at + V(1, 0, 1), at + V(0, 0, 1)});
            }
        addMesh(scene, net, opaque);
    }
    addMesh(scene, box(V(200, -1, 200), V(201, 0, 201), {}), glass); // beside both
    addMesh(scene, box(V(100.2, 0, 100.2), V(100.4, 1, 100.4), {}), glass);
    const auto sheets = CoincidentSurfaces(scene).sheets();
    ASSERT_EQ(sheets.size(), 1u);
    EXPECT_EQ(sheets[0].triangles.size(), 2u * 2 * 141 * 141 + 2);
}

} // namespace

} // namespace rt::numerics
