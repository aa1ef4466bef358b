// The searches under Scene::intersect and occluded give, bit for bit, what a scan over all shapes gives.
#include <map>

#include "tests/common/random_world.h"

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
    std::vector<int> first;     ///< of equal spheres
    std::map<int, int> sheetOf; ///< of triangles that lie on others; none is of glass

    Scan(const Scene<Real>& its, const SceneDescription& description)
        : scene(its), first(firstOfEqualSpheres(description.spheres))
    {
        int count = 0;
        for (const auto& sheet : CoincidentSurfaces(description).sheets())
        {
            for (const int triangle : sheet.triangles) sheetOf[triangle + int(scene.spheres.size())] = count;
            ++count;
        }
    }

    bool areOneSheet(PrimitiveId a, PrimitiveId b) const
    {
        const auto one = sheetOf.find(a), other = sheetOf.find(b);
        return one != sheetOf.end() && other != sheetOf.end() && one->second == other->second;
    }

    template <class Visit>
    void visit(const Ray<Real>& ray, Visit&& visit) const
    {
        PrimitiveId id = 0;
        for (const auto& sphere : scene.spheres)
        {
            const auto t =
                id == ray.from ? Shapes<Real>::leaveSphere(ray, sphere) : Shapes<Real>::intersectSphere(ray, sphere);
            if (t && first[std::size_t(id)] == id) visit(id, *t);
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
            if (id != ray.from && !areOneSheet(id, ray.from))
            {
                const auto t =
                    ray.from < firstTriangle
                        ? Shapes<Real>::intersectTriangle(ray, triangle)
                        : leaveTriangle(ray, scene.triangles[std::size_t(ray.from - firstTriangle)], triangle);
                if (t) visit(id, *t);
            }
            ++id;
        }
    }

    static std::optional<Real> leaveTriangle(const Ray<Real>& ray, const Triangle<Real>& from, const Triangle<Real>& to)
    {
        const LeaveTriangle<Real> left(ray, from);
        if (left.startsWithin()) return left.meet(to);
        const auto t = left.fromWithin().meet(left.widened(to));
        return t ? std::optional(std::max(Real(*t), std::numeric_limits<Real>::denorm_min())) : std::nullopt;
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

/// The ray itself, a shadow ray of the same direction, and where the hit leads.
template <class Real>
void compare(Scene<Real>& scene, const SceneDescription& description, Ray<Real> ray, std::mt19937& engine, Tally& tally,
             int bounces = 3)
{
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    const Scan<Real> scan(scene, description);
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
        // Which of the triangles that lie on one another it is, is coincident_test's: the scan knows distances only.
        ASSERT_TRUE(hit->I.on == id || scan.areOneSheet(hit->I.on, id))
            << scene.primitiveName(hit->I.on) << " for " << scene.primitiveName(id);
        ASSERT_EQ(hit->t, t);
        expectSame(*hit, *baseline);
        const Vec3<Real> D(Real(in(-1, 1)), Real(in(-1, 1)), Real(in(-1, 1)));
        ray = ray.spawn(reflected, hit->I, bounces == 2 ? hit->N : D);
    }
}

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
            compare(scene, world.scene, world.ray(scene, power), world.engine, tally);
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
                compare(scene, world.scene, {.O = target - Real(distance) * D, .D = D}, world.engine, tally, 2);
            }
        }
    expectBoth(tally, 200);
}

TYPED_TEST(Search, OfTrianglesFindsWhatAScanFinds)
{
    expectBoth(compareMany<TypeParam>(0, 200, 0, 8, 300), 300);
}

TYPED_TEST(Search, OfTrianglesOfAllSizesFindsWhatAScanFinds)
{
    for (const double power : {2, 4, 8}) expectBoth(compareMany<TypeParam>(0, 100, power, 8, 200), 15);
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
            compare(scene, world.scene, ray, world.engine, tally, 1);
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
        compare(scene, world.scene, ray, world.engine, tally, 1);
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
        if (std::is_same_v<Real, double>) // squares and cubes have no range to spare there
        {
            EXPECT_THROW(Scene<Real>{world.scene}, std::range_error);
            continue;
        }
        Scene<Real> scene(world.scene);
        Tally tally;
        for (int i = 0; i < 2000; ++i)
        {
            auto ray = world.ray(unscaled, 0);
            ray.O *= Real(k);
            compare(scene, world.scene, ray, world.engine, tally, 1);
        }
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

} // namespace

} // namespace rt
