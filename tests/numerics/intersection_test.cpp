// Where rays meet shapes, far away, at a tangent, and on the way off a surface.
#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class Intersection : public testing::Test
{
};
TYPED_TEST_SUITE(Intersection, Precisions);

/// The textbook's formula, all in Real: (-b - sqrt(b² - 4ac)) / 2a. Infinite on a miss.
template <class Real>
Real naiveSphere(const Ray<Real>& ray, const Sphere<Real>& sphere)
{
    const Vec3<Real> oc = ray.O - sphere.C;
    const Real b = 2 * dot(oc, ray.D), c = dot(oc, oc) - sphere.r * sphere.r, a = dot(ray.D, ray.D);
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return infinity<Real>;
    const Real t = (-b - std::sqrt(discriminant)) / (2 * a);
    return t > 0 ? t : (-b + std::sqrt(discriminant)) / (2 * a);
}

TYPED_TEST(Intersection, TheSphereFormulaIsExactAtEveryDistance)
{
    using Real = TypeParam;
    // Pythagorean triples: across² + half² = r², so the ray meets the sphere at distance - half and distance + half.
    const double triples[][3] = {{0.75, 1, 1.25}, {0.625, 1.5, 1.625}, {0, 1, 1}, {1.875, 1, 2.125}};
    for (const auto& [across, half, r] : triples)
        for (int decade = 0; decade <= 8; ++decade)
            for (int axis = 0; axis < 3; ++axis)
                for (const double sign : {-1.0, 1.0})
                {
                    const double away = std::round(std::pow(10.0, decade)) * 4; // exact in float, or rounded once
                    Ray<Real> ray;
                    ray.D[axis] = Real(-sign);
                    ray.O[axis] = Real(sign) * Real(away);
                    ray.O[(axis + 1) % 3] = Real(across);
                    const Sphere<Real> sphere{.r = Real(r)};
                    const auto t = Shapes<Real>::intersectSphere(ray, sphere);
                    ASSERT_TRUE(t) << away;
                    EXPECT_TRUE(near(*t, (long double)Real(away) - half, 8)) << away;
                }
}

TYPED_TEST(Intersection, TheTextbookFormulaIsNot)
{
    using Real = TypeParam;
    // At 2 / sqrt(eps) radii the sphere's own size is lost in b² - 4ac.
    const Real away = std::ceil(2 / std::sqrt(eps<Real>));
    const Ray<Real> ray{.O = {Real(0.75), 0, away}, .D = {0, 0, -1}};
    const Sphere<Real> sphere{.r = Real(1.25)};
    EXPECT_TRUE(near(*Shapes<Real>::intersectSphere(ray, sphere), (long double)away - 1, 1));
    EXPECT_GT(std::abs(naiveSphere(ray, sphere) - (away - 1)) / (away * eps<Real>), 64) << "in ulp";
}

TYPED_TEST(Intersection, HitAndMissAreToldApartAtTenThousandRadii)
{
    using Real = TypeParam;
    using Reference = Shapes<long double>;
    Random random(2);
    constexpr int rays = 10000;
    int wrong = 0, naiveWrong = 0, hits = 0;
    for (int i = 0; i < rays; ++i)
    {
        // A ray that passes the centre at a distance of 0 to 2 radii.
        const V D = random.direction(), side = glm::normalize(cross(D, random.direction()));
        const Ray<Real> ray{.O = Vec3<Real>(-1e4 * D + random.in(0, 2) * side), .D = unit(Vec3<Real>(D))};
        const Ray<long double> same{.O = Vec3<long double>(ray.O), .D = unit(Vec3<long double>(ray.D))};
        // How near to the edge the answer is anybody's: a direction's length is only 1 up to eps.
        const auto inner = Reference::intersectSphere(same, {.r = 1 - 4 * eps<Real>});
        const auto outer = Reference::intersectSphere(same, {.r = 1 + 4 * eps<Real>});
        if (bool(inner) != bool(outer)) continue;
        const bool hit = bool(Shapes<Real>::intersectSphere(ray, {}));
        hits += hit;
        wrong += hit != bool(inner);
        naiveWrong += std::isfinite(naiveSphere<Real>(ray, {})) != bool(inner);
    }
    EXPECT_GT(hits, rays / 3);
    EXPECT_EQ(wrong, 0);
    if (eps < Real >> 1e-10)
    {
        EXPECT_GT(naiveWrong, rays / 10) << "the textbook's formula in float";
        note("naive_wrong_percent", naiveWrong * 100.0 / rays);
    }
}

TYPED_TEST(Intersection, ATangentIsAHitAndOneUlpBesideItIsAMiss)
{
    using Real = TypeParam;
    const auto meet = [](Real x) { return Shapes<Real>::intersectSphere({.O = {x, 0, 5}, .D = {0, 0, -1}}, {}); };
    ASSERT_TRUE(meet(1));
    EXPECT_EQ(*meet(1), 5);
    ASSERT_TRUE(meet(std::nextafter(Real(1), Real(0))));
    EXPECT_FALSE(meet(std::nextafter(Real(1), Real(2))));
    // A mirror and a glass ball at their rims: the ray goes on as it came, and nothing of it is lost.
    for (const Material<double>& material : {mirrorOf(1), glassOf(1.5)})
    {
        const Scene<Real> scene(Build().material(material).sphere({0, 0, 0}, 1).sky(V(1)).scene);
        EXPECT_EQ(colorOf<Real>(scene, {.O = {1, 0, 5}, .D = {0, 0, -1}}), Vec3<Real>(1));
        const auto path = pathOf<Real>(scene, {.O = {1, 0, 5}, .D = {0, 0, -1}});
        EXPECT_EQ(path.size(), 2U);
        EXPECT_EQ(path.back().ray.D, Vec3<Real>(0, 0, -1));
    }
}

TYPED_TEST(Intersection, GrazingRaysMeetAPlaneDownToTwoToTheMinus60)
{
    using Real = TypeParam;
    const Scene<Real> scene(Build().material(mirrorOf(0.5)).floor().sky(V(4)).scene);
    for (int k = 0; k <= 60; ++k)
    {
        const Real slope = std::ldexp(Real(1), -k);
        const auto path = pathOf<Real>(scene, {.O = {0, 1, 0}, .D = unit(Vec3<Real>(1, -slope, 0))});
        ASSERT_EQ(path.size(), 2U) << k << ": down to the floor, up to the sky";
        EXPECT_TRUE(near(path[0].I.x, 1 / (long double)slope, 4)) << k;
        EXPECT_EQ(path[0].I.y, 0) << k << ": the point is on the plane";
        EXPECT_TRUE(near(path[1].ray.D.y, slope / std::sqrt(1 + (long double)slope * slope), 4)) << k;
        EXPECT_EQ(colorOf<Real>(scene, path[0].ray).x, 2);
    }
}

TYPED_TEST(Intersection, GrazingLightIsAsWeakAsItsCosine)
{
    using Real = TypeParam;
    for (int k = 0; k <= 60; ++k)
    {
        const long double slope = std::ldexp(1.0L, -k);
        const Scene<Real> scene(Build().floor().light({1, double(slope), 0}, 1).scene);
        EXPECT_TRUE(near(colorOf<Real>(scene, {.O = {0, 1, 0}, .D = {0, -1, 0}}).x,
                         slope / std::pow(1 + slope * slope, 1.5L), 64))
            << k;
    }
}

TYPED_TEST(Intersection, ShortChordsAreMetDownToTwoToTheMinus60)
{
    using Real = TypeParam;
    const Sphere<Real> ball;
    for (int k = 0; k <= 60; ++k)
    {
        const Real slope = std::ldexp(Real(1), -k);
        const Vec3<Real> in = unit(Vec3<Real>(1, -slope, 0)), out = unit(Vec3<Real>(1, slope, 0));
        const auto chord = Shapes<Real>::leaveSphere({.O = {0, 1, 0}, .D = in}, ball);
        ASSERT_TRUE(chord) << k;
        EXPECT_TRUE(near(*chord, 2 * slope / std::sqrt(1 + (long double)slope * slope), 4)) << k;
        EXPECT_FALSE(Shapes<Real>::leaveSphere({.O = {0, 1, 0}, .D = out}, ball)) << k;
    }
}

TYPED_TEST(Intersection, AHitPointLiesOnItsSurfaceHoweverFarTheRayCame)
{
    using Real = TypeParam;
    Random random(10);
    for (int decade = 0; decade <= 9; ++decade)
        for (int i = 0; i < 20; ++i)
        {
            const double away = std::pow(10.0, decade) * 4;
            const Scene<Real> ball(Build().sphere({0, 0, 0}, 1).scene);
            const auto hit =
                ball.intersect({.O = Vec3<Real>(V(random.in(-0.7, 0.7), random.in(-0.7, 0.7), away)), .D = {0, 0, -1}});
            ASSERT_TRUE(hit);
            EXPECT_TRUE(near(length(Vec3<Real>(hit->I)), 1, 4));

            const V P = random.vector(-1, 1), N = random.direction();
            V side(0);
            side[std::abs(N.x) < 0.5 ? 0 : 1] = 3;
            const V U = cross(N, side), W = cross(U, N); // the triangle's corners are in the plane up to rounding
            for (const auto& scene :
                 {Build().plane(P, N).scene, Build().triangle(P + U - W, P - U - W, P + 2.0 * W).scene})
            {
                const Scene<Real> flat(scene);
                const Ray<Real> ray{.O = Vec3<Real>(P + away * N + random.in(-0.5, 0.5) * U),
                                    .D = unit(-Vec3<Real>(N))};
                const auto met = flat.intersect(ray);
                if (!met) continue; // from afar, float's direction may miss the triangle
                const Vec3<Real> normal = met->outwardNormal(),
                                 on = scene.planes.empty() ? flat.triangles[0].a : flat.planes[0].P;
                const Real size = 1 + largestChannel(abs(on)) + largestChannel(abs(Vec3<Real>(met->I)));
                EXPECT_LE(std::abs(dot(met->I - on, normal)), 4 * eps<Real> * (size + eps<Real> * Real(away)))
                    << "from " << away;
            }
        }
}

TYPED_TEST(Intersection, ARayLeavesASphereAndComesBackOnlyAtItsFarSide)
{
    using Real = TypeParam;
    Random random(3);
    int outwards = 0, inwards = 0, resolved = 0;
    for (int i = 0; i < 300; ++i)
    {
        // Radius and place are independent: spheres of 1e-8 at 1e8 are there, where C + rN is C.
        const double r = random.power10(-8, 8), reach = i % 3 ? random.power10(-8, 8) : r * random.in(0, 10);
        const Scene<Real> scene(Build().sphere(random.vector(-1, 1) * reach, r).scene);
        const auto& sphere = scene.spheres[0];
        const auto hit = scene.intersect({.O = sphere.C, .D = unit(Vec3<Real>(random.direction()))});
        ASSERT_TRUE(hit) << "from its centre, a sphere was missed";
        // How far the rounding of C + rN turns the normal.
        const Real doubt = 8 * eps<Real> * (1 + largestChannel(abs(sphere.C)) / sphere.r);
        const Vec3<Real> N = hit->outwardNormal();
        resolved += doubt < Real(0.01);
        for (int k = 0; k < 1000; ++k)
        {
            const Vec3<Real> D = unit(Vec3<Real>(random.vector(-1, 1)));
            const auto next = scene.intersect(Ray<Real>{.O = hit->I, .D = D, .from = hit->I.on});
            if (dot(D, N) > doubt)
            {
                EXPECT_FALSE(next) << "leaving, it was met again at " << double(next->t) << "; r = " << r;
                ++outwards;
            }
            else if (dot(D, N) < -doubt)
            {
                ASSERT_TRUE(next) << "going in, the far side was lost; r = " << r;
                EXPECT_TRUE(next->inside);
                EXPECT_LE(std::abs(next->t / sphere.r + 2 * dot(D, N)), 2 * doubt);
                ++inwards;
            }
            else
                EXPECT_TRUE(!next || next->t <= 4 * doubt * sphere.r);
        }
    }
    EXPECT_GT(resolved, 100);
    EXPECT_GT(outwards, 50000);
    EXPECT_GT(inwards, 50000);
}

TYPED_TEST(Intersection, ARayNeverMeetsAgainThePlaneThatItLeaves)
{
    using Real = TypeParam;
    Random random(4);
    int left = 0;
    for (int i = 0; i < 200; ++i)
    {
        const double scale = random.power10(-8, 8);
        const V P = random.vector(-1, 1) * scale, N = random.direction(), O = P + N * scale * random.in(0.1, 10);
        const Scene<Real> scene(Build().plane(P, N).scene);
        const auto hit = scene.intersect({.O = Vec3<Real>(O), .D = unit(Vec3<Real>(random.direction() - N))});
        if (!hit) continue;
        for (int k = 0; k < 1000; ++k, ++left)
            EXPECT_FALSE(
                scene.intersect({.O = hit->I, .D = unit(Vec3<Real>(random.vector(-1, 1))), .from = hit->I.on}));
    }
    EXPECT_GT(left, 100000);
}

TYPED_TEST(Intersection, RaysLeaveAClosedMeshAndNeverLeakOutOfIt)
{
    using Real = TypeParam;
    Random random(5);
    int outwards = 0, inwards = 0;
    for (int i = 0; i < 24; ++i)
    {
        const double r = random.power10(-8, 8);
        const V C = random.vector(-1, 1) * r * (i % 4 ? 2.0 : 100.0);
        SceneDescription description;
        description.materials.push_back({});
        description.meshes.push_back(ballMesh(C, r, 1));
        const Scene<Real> scene(description);
        for (int j = 0; j < 20; ++j)
        {
            const auto hit = scene.intersect({.O = Vec3<Real>(C), .D = unit(Vec3<Real>(random.direction()))});
            ASSERT_TRUE(hit) << "a ray slipped out; r = " << r;
            const Vec3<Real> N = -hit->N; // out of the mesh, whichever way its triangles turn
            // Close to an edge and along the surface, a point that is rounded may lie in front of the neighbour.
            const Real doubt = 64 * eps<Real> * (1 + largestChannel(abs(Vec3<Real>(C))) / Real(r));
            for (int k = 0; k < 100; ++k)
            {
                const Vec3<Real> D = unit(Vec3<Real>(random.vector(-1, 1)));
                const auto next = scene.intersect({.O = hit->I, .D = D, .from = hit->I.on});
                if (dot(D, N) > doubt)
                {
                    EXPECT_FALSE(next) << "r = " << r;
                    ++outwards;
                }
                else if (dot(D, N) < -doubt)
                {
                    EXPECT_TRUE(next) << "r = " << r;
                    ++inwards;
                }
            }
        }
    }
    EXPECT_GT(outwards, 10000);
    EXPECT_GT(inwards, 10000);
}

TYPED_TEST(Intersection, ACoplanarNeighbourIsNotMetEither)
{
    using Real = TypeParam;
    Random random(6);
    int left = 0;
    for (int i = 0; i < 100; ++i)
    {
        // A flat grid, turned and moved: its vertices are rounded, so it is flat only up to that.
        const double scale = random.power10(-8, 8);
        const V P = random.vector(-1, 1) * scale * 10.0, U = random.direction() * scale;
        const V W = cross(U, random.direction());
        SceneDescription description;
        description.materials.push_back({});
        const auto vertex = [&](int x, int y) { return P + double(x) * U + double(y) * W; };
        for (int x = 0; x < 4; ++x)
            for (int y = 0; y < 4; ++y)
            {
                description.triangles.push_back({{vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)}, 0});
                description.triangles.push_back({{vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)}, 0});
            }
        const Scene<Real> scene(description);
        for (int j = 0; j < 10; ++j)
        {
            const V target = P + random.in(0.01, 3.99) * U + random.in(0.01, 3.99) * W;
            const V O = target + random.direction() * length(U) * random.power10(-1, 3);
            const auto hit = scene.intersect({.O = Vec3<Real>(O), .D = unit(Vec3<Real>(target - O))});
            if (!hit) continue;
            ++left;
            // Corners are rounded, to double at most: at slopes that this cannot tell from 0 the grid is not flat, and
            // what lies in front is met.
            for (int k = 0; k < std::min(std::numeric_limits<Real>::digits, 48) - 8; ++k)
            {
                // Along the grid and off it by less and less: such rays would meet what is only rounded to lie in front.
                const Vec3<Real> along = unit(Vec3<Real>(random.in(-1, 1) * U + random.in(-1, 1) * W));
                const Real off = std::ldexp(Real(random.chance(0.5) ? 1 : -1), -k);
                const auto next = scene.intersect({.O = hit->I, .D = unit(along + off * hit->N), .from = hit->I.on});
                EXPECT_FALSE(next) << "scale " << scale << ", slope 2^-" << k;
            }
        }
    }
    EXPECT_GT(left, 400);
}

} // namespace

} // namespace rt::numerics
