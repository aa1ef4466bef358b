// The searches under Scene::intersect and occluded give, bit for bit, what a scan over all shapes gives.
#include <algorithm>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "common/pixel.h"
#include "common/scene.h"
#include "tests/common/random_scene.h"

namespace rt
{

namespace
{

template <class Real>
class Search : public testing::Test
{
};
using Precisions = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(Search, Precisions);

/// The reference: every shape in the order of ids, by the formulas of shapes.h.
template <class Real>
struct Scan
{
    const Scene<Real>& scene;

    template <class Visit>
    void visit(const Ray<Real>& ray, Visit&& visit) const
    {
        PrimitiveId id = 0;
        for (const auto& sphere : scene.spheres)
        {
            const auto t =
                id == ray.from ? Shapes<Real>::leaveSphere(ray, sphere) : Shapes<Real>::intersectSphere(ray, sphere);
            if (t) visit(id, *t);
            ++id;
        }
        for (const auto& plane : scene.planes)
        {
            if (id != ray.from)
                if (const auto t = Shapes<Real>::intersectPlane(ray, plane)) visit(id, *t);
            ++id;
        }
        const auto firstTriangle = PrimitiveId(scene.spheres.size() + scene.planes.size());
        for (const auto& triangle : scene.triangles)
        {
            if (id != ray.from && !(ray.from >= firstTriangle && startsOn(ray, triangle)))
                if (const auto t = Shapes<Real>::intersectTriangle(ray, triangle)) visit(id, *t);
            ++id;
        }
    }

    static bool startsOn(const Ray<Real>& ray, const Triangle<Real>& triangle)
    {
        const Vec3<Real> a = abs(triangle.a), o = abs(ray.O);
        const Real bound = 16 * std::numeric_limits<Real>::epsilon() * (a.x + a.y + a.z + o.x + o.y + o.z);
        return std::abs(dot(ray.O - triangle.a, triangle.N)) <= bound;
    }

    std::pair<PrimitiveId, Real> nearest(const Ray<Real>& ray) const
    {
        std::pair<PrimitiveId, Real> best{noPrimitive, infinity<Real>};
        visit(ray, [&](PrimitiveId id, Real t) {
            if (t < best.second) best = {id, t};
        });
        return best;
    }

    bool occluded(const Point<Real>& I, const Vec3<Real>& L, Real distance) const
    {
        bool blocked = false;
        visit({.O = I, .D = L, .from = I.on}, [&](PrimitiveId, Real t) { blocked = blocked || t < distance; });
        return blocked;
    }
};

struct Tally
{
    int hits = 0, misses = 0, blocked = 0, free = 0;
};

/// All that a hit says, by the instructions of this processor and by the baseline's.
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

/// The ray itself, a shadow ray of the same direction, and where the hit leads.
template <class Real>
void compare(Scene<Real>& scene, Ray<Real> ray, std::mt19937& engine, Tally& tally, int bounces = 3)
{
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    const Scan<Real> scan{scene};
    for (; bounces > 0; --bounces)
    {
        const auto [id, t] = scan.nearest(ray);
        scene.instructions = Instructions::baseline;
        const auto baseline = scene.intersect(ray);
        scene.instructions = bestInstructions();
        const auto hit = scene.intersect(ray);
        ASSERT_EQ(bool(hit), bool(baseline));
        ASSERT_EQ(bool(hit), id != noPrimitive) << "the scan finds " << scene.primitiveName(id);
        const Real reach = id == noPrimitive ? Real(in(0, 9)) * length(ray.O) : t;
        for (const Real distance : {reach, reach * (1 + std::numeric_limits<Real>::epsilon()), reach * Real(in(0, 3))})
        {
            const Point<Real> I{ray.O, ray.from};
            const bool blocked = scan.occluded(I, ray.D, distance);
            if (distance * distance > std::numeric_limits<Real>::min()) // else a lamp is as good as on the point
            {
                ASSERT_EQ(scene.occluded(I, ray.D, distance), blocked);
                scene.instructions = Instructions::baseline;
                ASSERT_EQ(scene.occluded(I, ray.D, distance), blocked) << "baseline";
                scene.instructions = bestInstructions();
            }
            ++(blocked ? tally.blocked : tally.free);
        }
        ++(hit ? tally.hits : tally.misses);
        if (!hit) return;
        ASSERT_EQ(hit->I.on, id) << scene.primitiveName(hit->I.on) << " for " << scene.primitiveName(id);
        ASSERT_EQ(hit->t, t);
        expectSame(*hit, *baseline);
        const Vec3<Real> D(Real(in(-1, 1)), Real(in(-1, 1)), Real(in(-1, 1)));
        ray = ray.spawn(reflected, hit->I, bounces == 2 ? hit->N : D);
    }
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

template <class Real>
Tally compareMany(int spheres, int triangles, double power, int worlds, int rays)
{
    Tally tally;
    for (int w = 0; w < worlds && !testing::Test::HasFatalFailure(); ++w)
    {
        World world(unsigned(w + 1));
        world.spheres(spheres, power);
        world.triangles(triangles, power);
        Scene<Real> scene(world.scene);
        for (int i = 0; i < rays && !testing::Test::HasFatalFailure(); ++i)
            compare(scene, world.ray(scene, power), world.engine, tally);
    }
    return tally;
}

void expectBoth(const Tally& tally, int least)
{
    EXPECT_GT(tally.hits, least);
    EXPECT_GT(tally.misses, least);
    EXPECT_GT(tally.blocked, least);
    EXPECT_GT(tally.free, least);
}

TYPED_TEST(Search, OfManySpheresFindsWhatAScanFinds)
{
    expectBoth(compareMany<TypeParam>(200, 0, 0, 12, 500), 2000);
}

TYPED_TEST(Search, OfFewSpheresFindsWhatAScanFinds)
{
    for (const int count : {1, 2, 3, 4, 5, 7, 8, 11, 12, 13})
        expectBoth(compareMany<TypeParam>(count, 0, 0, 10, 100), 30);
}

TYPED_TEST(Search, OfSpheresOfAllSizesFindsWhatAScanFinds)
{
    for (const double power : {2, 4, 8}) expectBoth(compareMany<TypeParam>(100, 0, power, 20, 250), 50);
}

/// Everything moved away from the origin, and rays from further off: what is lost to rounding must be lost in both.
TYPED_TEST(Search, FromAfarFindsWhatAScanFinds)
{
    using Real = TypeParam;
    Tally tally;
    for (const double shift : {0.0, 1e2, 1e4, 1e6, 1e9})
        for (const double distance : {3.0, 1e2, 1e4, 1e7, 1e12})
        {
            World world(7);
            world.spheres(80, 0);
            world.triangles(80, 0);
            for (auto& sphere : world.scene.spheres) sphere.center += shift;
            for (auto& triangle : world.scene.triangles)
                for (auto& vertex : triangle.vertices) vertex += shift;
            Scene<Real> scene(world.scene);
            for (int i = 0; i < 60 && !testing::Test::HasFatalFailure(); ++i)
            {
                const auto& sphere = scene.spheres[std::size_t(world.below(80))];
                const Vec3<Real> target = sphere.C + sphere.r * Vec3<Real>(world.vector(1.5));
                const Vec3<Real> D = unit(Vec3<Real>(world.vector(1)));
                compare(scene, {.O = target - Real(distance) * D, .D = D}, world.engine, tally, 2);
            }
        }
    expectBoth(tally, 200);
}

TYPED_TEST(Search, OfTrianglesFindsWhatAScanFinds)
{
    expectBoth(compareMany<TypeParam>(0, 200, 0, 12, 500), 800);
}

TYPED_TEST(Search, OfTrianglesOfAllSizesFindsWhatAScanFinds)
{
    for (const double power : {2, 4, 8}) expectBoth(compareMany<TypeParam>(0, 100, power, 20, 250), 50);
}

TYPED_TEST(Search, OfBothFindsWhatAScanFinds)
{
    expectBoth(compareMany<TypeParam>(60, 60, 0, 10, 400), 400);
    expectBoth(compareMany<TypeParam>(60, 60, 5, 10, 400), 80);
}

TYPED_TEST(Search, OfCoincidentShapesFindsTheFirst)
{
    using Real = TypeParam;
    SceneDescription description;
    description.materials.push_back({});
    for (int i = 0; i < 300; ++i) description.spheres.push_back({{0, 0, -5}, 1, 0});
    for (int i = 0; i < 300; ++i)
        description.triangles.push_back({{Vec3<double>(-9, -9, -3), {9, -9, -3}, {0, 9, -3}}, 0});
    const Scene<Real> scene(description);
    EXPECT_EQ(scene.intersect({.D = {0, 0, -1}})->I.on, 300);
    EXPECT_EQ(scene.intersect({.O = {0, 0, -4}, .D = {0, 0, -1}, .from = 0})->I.on, 0)
        << "the far side of the one it leaves";
}

TYPED_TEST(Search, LivesWithNumbersThatAreNone)
{
    using Real = TypeParam;
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), huge = std::numeric_limits<Real>::max();
    World world(5);
    world.spheres(100, 0);
    world.triangles(100, 0);
    Scene<Real> scene(world.scene);
    Tally tally;
    for (const Real odd : {nan, infinity<Real>, -infinity<Real>, huge, -huge, Real(0)})
        for (int axis = 0; axis < 6; ++axis)
        {
            Ray<Real> ray{.O = {Real(0.1), Real(0.2), 2}, .D = {0, 0, -1}};
            (axis < 3 ? ray.O : ray.D)[axis % 3] = odd;
            compare(scene, ray, world.engine, tally, 1);
        }
    for (int i = 0; i < 6000;
         ++i) // Nobody said that D has length 1. Beside a sphere the formula then meets what is not there.
    {
        auto ray = world.ray(scene, 0);
        if (i % 2)
        {
            const auto& sphere = scene.spheres[std::size_t(world.below(int(scene.spheres.size())))];
            ray.O = sphere.C + Real(world.in(1, 1.5)) * sphere.r * unit(Vec3<Real>(world.vector(1)));
        }
        ray.D *= Real(world.in(0, 2));
        compare(scene, ray, world.engine, tally, 1);
    }
}

/// Scaled so that squares of radii vanish, or that distances overflow.
TYPED_TEST(Search, LivesAtTheEndsOfItsType)
{
    using Real = TypeParam;
    const double top = std::min(300.0, std::log10(double(std::numeric_limits<Real>::max() / 100)));
    for (const double power : {-top, -top / 2, top / 2, top})
    {
        World world(9);
        world.spheres(60, 0);
        world.triangles(60, 0);
        const Scene<Real> unscaled(world.scene);
        const double k = std::pow(10.0, power);
        for (auto& sphere : world.scene.spheres) sphere.center *= k, sphere.radius *= k;
        for (auto& triangle : world.scene.triangles)
            for (auto& vertex : triangle.vertices) vertex *= k;
        Scene<Real> scene(world.scene);
        Tally tally;
        for (int i = 0; i < 2000; ++i)
        {
            auto ray = world.ray(unscaled, 0);
            ray.O *= Real(k);
            compare(scene, ray, world.engine, tally, 1);
        }
    }
}

/// By the instructions of this processor and by the baseline's. Some scenes have planes, and nothing else.
TYPED_TEST(Search, AheadFindsWhatIntersectFinds)
{
    using Real = TypeParam;
    if (!looksAhead<Real>)
    {
        EXPECT_FALSE(Scene<Real>(SceneDescription{}).wantsLookAhead());
        return;
    }
    int hits = 0, misses = 0;
    for (int w = 0; w < 200; ++w)
    {
        World world(unsigned(w + 1));
        const double power = w % 4 == 0 ? 5 : 0;
        world.spheres(w % 17, power);
        for (int i = 0; i < w % 3; ++i) // coincident ones, too
            world.scene.planes.push_back({.point = {0, -1, 0}, .normal = i ? Vec3<double>(0, 1, 0) : world.vector(1)});
        Scene<Real> scene(world.scene);
        ASSERT_TRUE(scene.wantsLookAhead());
        for (const auto set : {Instructions::baseline, bestInstructions()})
        {
            scene.instructions = set;
            Ahead<Real> rays[64];
            for (auto& ahead : rays)
            {
                const auto ray = world.ray(scene, power);
                ahead.O = ray.O;
                ahead.D = ray.D;
                if (world.below(8) == 0) ahead.O[world.below(3)] = infinity<Real>;
                if (world.below(8) == 0) ahead.D[world.below(3)] = std::numeric_limits<Real>::quiet_NaN();
            }
            scene.lookAhead(rays, 64);
            for (const auto& ahead : rays)
            {
                const auto hit = scene.intersect({.O = ahead.O, .D = ahead.D});
                ASSERT_EQ(bool(hit), bool(ahead.hit));
                ++(hit ? hits : misses);
                if (hit && hit->t < infinity<Real>) expectSame(*hit, *ahead.hit);
            }
        }
    }
    EXPECT_GT(hits, 5000);
    EXPECT_GT(misses, 5000);
}

TEST(Search, AheadIsForgottenForAnotherRay)
{
    SceneDescription description;
    description.materials.push_back({});
    description.spheres.push_back({{0, 0, -5}, 1, 0});
    const Scene<double> scene(description);
    Ahead<double> rays[4];
    for (auto& ahead : rays) ahead.D = {0, 0, -1};
    scene.lookAhead(rays, 4);
    ASSERT_TRUE(rays[0].hit);
    rays[0].hit->t = 77; // to see who answers
    Ray<double> ray{.D = {0, 0, -1}, .ahead = rays};
    EXPECT_EQ(scene.intersect(ray)->t, 77);
    ray.D.x = -0.0;
    EXPECT_EQ(scene.intersect(ray)->t, 4);
    ray = {.O = {0, 0.5, 0}, .D = {0, 0, -1}, .ahead = rays};
    EXPECT_LT(scene.intersect(ray)->t, 5);
    EXPECT_EQ(ray.spawn(reflected, rays[0].hit->I, {0, 0, -1}).ahead, nullptr);
}

/// Sees where its rays arrive; some pixels are given up half-way.
struct Sight
{
    const Scene<double>& scene;
    int calls = 0;

    Vec3<double> trace(const Ray<double>& ray)
    {
        if (ray.D.x > 0.2 && ray.D.y < -0.1 && ++calls % 3 == 2 && calls > 0) throw NotAttempted("x");
        const auto hit = scene.intersect(ray);
        return hit ? Vec3<double>(hit->I) + 3.0 : ray.D;
    }
};

TEST(Search, AheadLeavesPixelsAsTheyAre)
{
    World world(3);
    world.spheres(16, 0);
    world.scene.planes.push_back({.point = {0, -1, 0}, .normal = {0, 1, 0}});
    world.scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}, .width = 75, .height = 41};
    const Scene<double> scene(world.scene);
    ASSERT_TRUE(scene.wantsLookAhead());
    for (const int spp : {1, 3, 7})
    {
        Image image(75, 41);
        for (int tile = 0; tile < tilesOf(image); ++tile) renderTile<Sight>(image, tile, scene, spp);
        int same = 0, givenUp = 0;
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 75; ++x)
            {
                Sight sight{scene, -1000000000};
                if (image.at(x, y) == magenta)
                    ++givenUp;
                else if (image.at(x, y) == renderPixel(scene, sight, x, y, spp))
                    ++same;
            }
        EXPECT_EQ(same + givenUp, 75 * 41) << spp;
        EXPECT_GT(givenUp, 20);
        EXPECT_GT(same, 1000);
    }
}

TEST(Search, OfManySpheresTakesLessThan200BytesEach)
{
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> in(-1, 1);
    std::vector<Sphere<double>> spheres;
    for (int i = 0; i < 100000; ++i) spheres.push_back({{in(engine), in(engine), in(engine)}, 0.001, 0});
    const SphereSearch<double> search(spheres);
    EXPECT_LT(double(search.bytes()) / double(spheres.size()) + sizeof(Sphere<double>), 200);
}

std::vector<Box<float>> randomBoxes(int count)
{
    std::mt19937 engine(2);
    std::uniform_real_distribution<float> in(-1, 1);
    std::vector<Box<float>> boxes(std::size_t(count), Box<float>{});
    for (auto& box : boxes)
    {
        box.add({in(engine), in(engine), in(engine)});
        box.add(box.low + 0.01F);
    }
    return boxes;
}

TEST(Hierarchy, IsTheSameWhetherPartsAreBuiltAtOnceOrOneByOne)
{
    const auto boxes = randomBoxes(30000);
    const auto alone = BvhBuilder{boxes, boxes.size()}.build();
    for (const std::size_t apartFrom : {10, 1000, 16384})
    {
        const auto tree = BvhBuilder{boxes, apartFrom}.build();
        ASSERT_EQ(tree.nodes.size(), alone.nodes.size());
        EXPECT_EQ(tree.leaves, alone.leaves);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        {
            const auto &a = tree.nodes[i], &b = alone.nodes[i];
            ASSERT_TRUE(std::ranges::equal(a.planes, b.planes) && std::ranges::equal(a.child, b.child) &&
                        a.children == b.children)
                << i;
        }
    }
}

TEST(Hierarchy, HoldsEachShapeOnce)
{
    const auto boxes = randomBoxes(20000);
    std::vector<int> times(boxes.size());
    const auto tree = BvhBuilder{boxes}.build();
    std::vector<std::int32_t> waiting{0};
    while (!waiting.empty())
    {
        const auto& node = tree.nodes.at(std::size_t(waiting.back()));
        waiting.pop_back();
        for (int k = 0; k < bvhWidth; ++k)
        {
            if (!(node.children >> k & 1)) continue;
            if (node.child[k] >= 0)
                waiting.push_back(node.child[k]);
            else
                for (const auto id : tree.leaves.at(std::size_t(~node.child[k])))
                    if (id >= 0) ++times.at(std::size_t(id));
        }
    }
    EXPECT_EQ(std::ranges::count(times, 1), std::ptrdiff_t(boxes.size()));
}

} // namespace

} // namespace rt
