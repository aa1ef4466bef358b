// What the widgets show, computed by the lessons themselves: build.py compiles this file to WebAssembly, the tests compile
// it natively, and both must give the same numbers. Directions lie in the plane of the picture (z = 0), angles are in
// degrees from +y, clockwise. Each function leaves its numbers in `results()`; widgets/*.js name them.
#include "lessons/00_geometry/geometry.h"
#include "lessons/01_direct_illumination/trace.h"
#include "lessons/02_mirrors/trace.h"
#include "lessons/04_hdr_sky/trace.h"
#include "lessons/05_refraction/trace.h"
#include "lessons/06_fresnel/trace.h"
#include "lessons/07_recursion_caps/trace.h"
#include "lessons/08_phong/trace.h"

namespace
{

using namespace rt;
using vec3 = Vec3<double>;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double none = -1; ///< stands for a number that does not exist
std::array<double, 16> numbers;

vec3 direction(double degrees)
{
    return {std::sin(degrees * degree), std::cos(degrees * degree), 0};
}

double angleBetween(const vec3& a, const vec3& b)
{
    return std::acos(std::clamp(dot(a, b), -1.0, 1.0)) / degree;
}

/// Where `beyond` turns from false to true between 0 and `end` degrees, to the last bit; none if it is false at the end.
template <class Beyond>
double firstAngle(double end, Beyond&& beyond)
{
    if (!beyond(end)) return none;
    double low = 0, high = end;
    for (int i = 0; i < 60; ++i)
    {
        const double middle = (low + high) / 2;
        (beyond(middle) ? high : low) = middle;
    }
    return high;
}

double criticalAngle(double n1, double n2)
{
    return firstAngle(
        90, [&](double angle) { return !lesson05::Tracer<double>::refract(-direction(angle), vec3(0, 1, 0), n1, n2); });
}

/// The amplitudes of both polarisations. Lesson 06 has them inside fresnel(); a test holds (rs² + rp²)/2 to its bits.
std::array<double, 2> amplitudes(double cos1, double n1, double n2)
{
    const double cos2 = std::sqrt(lesson06::Tracer<double>::cosSquared2(cos1, n1, n2));
    return {(n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2), (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1)};
}

/// A lamp above a floor, in the angle and at the distance from the point below.
double direct(double degrees, double distance)
{
    SceneDescription description;
    description.lights.push_back({distance * direction(degrees), vec3(1)});
    const Scene<double> scene(description);
    return lesson01::Tracer<double>{scene}.directIllumination({vec3(0)}, vec3(0, 1, 0)).x;
}

/// A floor that reflects the share s of a sky, beneath a white lamp at distance 1.
vec3 floorColor(double s, const vec3& paint, const vec3& lamp, const vec3& sky)
{
    SceneDescription description;
    description.sky.present = true;
    description.sky.color = sky;
    description.materials.push_back({.name = {}, .color = paint, .mirror = s});
    description.planes.push_back({});
    description.lights.push_back({vec3(0, 1, 0), lamp});
    const Scene<double> scene(description);
    return lesson04::Tracer<double>{scene}.trace({.O = vec3(0, 0.5, 0), .D = vec3(0, -1, 0)});
}

/// Counts the rays of a tree, and keeps what they say.
struct Counter : NoRecorder
{
    int rays = 0;
    double capped_energy = 0;
    void ray(const auto&, const auto&) { ++rays; }
    void capped(const auto& ray) { capped_energy = ray.energy; }
    void capped(const auto& ray, const auto&) { capped(ray); }
};

/// All rays of a tree in which each one that is followed sends two, as at glass.
int countFullTree(const Ray<double>& ray, int maxDepth)
{
    if (ray.depth > maxDepth) return 0;
    return 1 + countFullTree(ray.spawn(reflected, {vec3(0)}, ray.D), maxDepth) +
           countFullTree(ray.spawn(transmitted, {vec3(0)}, ray.D), maxDepth);
}

double shade(double exponent, double glossy, double lightAngle, double eyeAngle)
{
    const Material<double> mat{.name = {}, .glossy = glossy, .exponent = exponent};
    return lesson08::Tracer<double>::phong(direction(lightAngle), vec3(0, 1, 0), direction(eyeAngle), mat);
}

} // namespace

extern "C" {

double* results()
{
    return numbers.data();
}

// 00: a line through P and Q: A, B, C; distance; |n|; slope and intercept, if it has one.
void line(double px, double py, double qx, double qy)
{
    using Lesson = lesson00::Geometry<double>;
    const auto form = Lesson::implicitForm({px, py}, {qx, qy});
    const auto slope = Lesson::slopeIntercept({px, py}, {qx, qy});
    const bool isLine = px != qx || py != qy;
    numbers = {form.A,
               form.B,
               form.C,
               isLine ? Lesson::distanceToOrigin(form) : none,
               double(isLine),
               double(slope.has_value()),
               slope ? slope->a : 0,
               slope ? slope->b : 0,
               isLine ? Lesson::withUnitNormal(form).C : 0};
}

// 01: N.L, 1/dist², what arrives, L.
void cosine(double degrees, double distance)
{
    const vec3 L = direction(degrees);
    numbers = {direct(degrees, 1), direct(0, distance), direct(degrees, distance), L.x, L.y};
}

// 02: D, N, D.N, R, angles of D and R to N.
void reflect(double arrival, double tilt)
{
    const vec3 D = -direction(arrival), N = direction(tilt);
    const vec3 R = lesson02::Tracer<double>::reflect(D, N);
    numbers = {D.x, D.y, N.x, N.y, dot(D, N), R.x, R.y, angleBetween(-D, N), angleBetween(R, N)};
}

// 03: own share, reflected share, both together (RGB each); then the throughput after 1 .. 7 bounces.
void partial(double s)
{
    const vec3 paint(0.9, 0.5, 0.25), lamp(1), sky(0.3, 0.6, 1), black(0);
    const vec3 own = floorColor(s, paint, lamp, black), mirror = floorColor(s, paint, black, sky);
    const vec3 sum = floorColor(s, paint, lamp, sky);
    numbers = {own.x, own.y, own.z, mirror.x, mirror.y, mirror.z, sum.x, sum.y, sum.z};
    Ray<double> ray{.D = vec3(0, 1, 0)};
    for (int bounce = 0; bounce < 7; ++bounce)
    {
        ray = ray.spawn(reflected, {vec3(0)}, ray.D, s);
        numbers[9 + bounce] = ray.energy;
    }
}

// 04: what a mirror of this colour returns of a sun of this radiance; and if the sun is cut to 1 first, as 8 bit do.
void bowling(double color, double sun)
{
    numbers = {floorColor(1, vec3(color), vec3(0), vec3(sun)).x,
               floorColor(1, vec3(color), vec3(0), vec3(std::min(1.0, sun))).x};
}

// 05: k, whether T exists, T, its angle, critical angle, D, R, n1 sin1, n2 sin2.
void refract(double degrees, double n1, double n2)
{
    using Lesson = lesson05::Tracer<double>;
    const vec3 D = -direction(-degrees), N(0, 1, 0);
    const auto T = Lesson::refract(D, N, n1, n2);
    const vec3 R = Lesson::reflect(D, N);
    numbers = {Lesson::cosSquared2(-dot(N, D), n1, n2),
               double(T.has_value()),
               T ? T->x : 0,
               T ? T->y : 0,
               T ? angleBetween(*T, -N) : none,
               criticalAngle(n1, n2),
               D.x,
               D.y,
               R.x,
               R.y,
               n1 * D.x,
               T ? n2 * T->x : none};
}

// 06: Fr, Schlick's, s- and p-polarised, Ft, critical angle, Brewster's angle.
void fresnel(double degrees, double n1, double n2)
{
    using Lesson = lesson06::Tracer<double>;
    const double cos1 = std::cos(degrees * degree), Fr = Lesson::fresnel(cos1, n1, n2);
    const double critical = criticalAngle(n1, n2);
    std::array<double, 2> r = {1, 1};
    if (Lesson::cosSquared2(cos1, n1, n2) >= 0) r = amplitudes(cos1, n1, n2);
    // rp changes its sign at Brewster's angle; at the end it has its sign of grazing light.
    const double end = critical == none ? 90 : std::nextafter(critical, 0);
    const double brewster = n1 == n2 ? none : firstAngle(end, [&](double angle) {
        return (amplitudes(std::cos(angle * degree), n1, n2)[1] > 0) == (n1 < n2);
    });
    numbers = {Fr, Lesson::schlick(cos1, n1, n2), r[0] * r[0], r[1] * r[1], 1 - Fr, critical, brewster};
}

// 07: rays of a full tree, of a chain of mirrors; energy of the first ray not traced; the pixel, and what it lacks at most.
void cap(double maxDepth, double s, double lamp)
{
    SceneDescription description;
    description.trace.maxDepth = int(maxDepth);
    description.materials.push_back({.name = {}, .mirror = s});
    description.planes.push_back({.point = vec3(0, -1, 0), .normal = vec3(0, 1, 0)});
    description.planes.push_back({.point = vec3(0, 1, 0), .normal = vec3(0, -1, 0)});
    description.lights.push_back({vec3(0), vec3(lamp)}); // at distance 1 from where each ray arrives
    const Scene<double> scene(description);
    lesson07::Tracer<double, Counter> tracer{scene};
    const double pixel = tracer.trace({.O = vec3(0), .D = vec3(0, -1, 0)}).x;
    const double energy = tracer.rec.capped_energy;
    numbers = {double(countFullTree({.D = vec3(0, 1, 0)}, int(maxDepth))), double(tracer.rec.rays), energy, pixel,
               energy * lamp};
}

// 08: the surface, if it were diffuse, if it were glossy; where the highlight has half its strength; R's angle.
void phong(double exponent, double glossy, double lightAngle, double eyeAngle)
{
    const double half = firstAngle(90, [&](double angle) { return shade(exponent, 1, 0, angle) < 0.5; });
    numbers = {shade(exponent, glossy, lightAngle, eyeAngle), shade(exponent, 0, lightAngle, eyeAngle),
               shade(exponent, 1, lightAngle, eyeAngle), half, -lightAngle};
}
}
