#include "viz/drawing/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/scene/scene.h"
#include "viz/drawing/mesh.h"

namespace rt::viz
{

namespace
{

using std::numbers::pi;

struct Basis
{
    vec3 right, up, back;
};

Basis basisOf(const vec3& towards, const vec3& up)
{
    vec3 right = cross(up, towards);
    if (!(dot(right, right) > 1e-12)) right = across(towards)[0];
    right = unit(right);
    return {right, cross(towards, right), towards};
}

/// Does the sphere hide `point` from a viewer far away in the direction `towards`?
bool hides(const SphereDescription& sphere, const vec3& point, const vec3& towards)
{
    const vec3 oc = point - sphere.center;
    const double b = dot(oc, towards), c = dot(oc, oc) - sphere.radius * sphere.radius;
    if (c < 1e-6 * sphere.radius * sphere.radius) return b < 0; // the point lies on it: hidden if on its far side
    return b < 0 && b * b - c > 0;
}

bool isOpaque(const Material<double>& material)
{
    return !material.isDielectric();
}

/// The triangles that hide what is behind them, those of meshes too, and nothing else.
SceneDescription opaqueTriangles(const SceneDescription& scene)
{
    SceneDescription walls;
    walls.materials = scene.materials;
    forEachTriangle(scene, [&](const std::array<vec3, 3>& corners, int material) {
        if (isOpaque(scene.materials[std::size_t(material)])) walls.triangles.push_back({corners, material});
    });
    return walls;
}

class Judge
{
public:
    vec3 up, forward;

    Judge(const RayDrawing& drawing, const SceneDescription& described)
        : up(unit(described.camera.up)), forward(unit(described.camera.target - described.camera.eye)),
          scene(described), size(drawing.size), walls(opaqueTriangles(described))
    {
        for (const auto& segment : drawing.segments)
            if (segment.role != RayRole::normal && segment.role != RayRole::beyond && sampled.size() < mostSampled)
                sampled.push_back(&segment);
        for (const auto* before : sampled)
            for (const auto* after : sampled)
                if (before != after && isRay(before->role) &&
                    glm::length(after->from - before->to) < 1e-9 * drawing.size)
                    bends.emplace_back(before, after);
    }

    /// The part of the rays' length that nothing hides.
    double visible(const vec3& towards) const
    {
        double seen = 0, all = 0;
        for (const auto& segment : sampled)
            for (const double t : {0.08, 0.35, 0.65, 0.92})
            {
                const vec3 point = segment->from + t * (segment->to - segment->from);
                const auto blocks = [&](const SphereDescription& sphere) {
                    return isOpaque(scene.materials[std::size_t(sphere.material)]) && hides(sphere, point, towards);
                };
                const double weight = importance(*segment);
                all += weight;
                // From a little before the point, which may itself be a hit point on a triangle.
                const Ray<double> out{.O = Point<double>(point + 1e-6 * size * towards), .D = towards};
                if (std::none_of(scene.spheres.begin(), scene.spheres.end(), blocks) && !walls.intersect(out))
                    seen += weight;
            }
        return all > 0 ? seen / all : 1;
    }

    /// How little the rays are foreshortened, and how little they cover one another.
    double spread(const vec3& towards) const
    {
        double across = 0, all = 0;
        for (const auto& segment : sampled)
        {
            const vec3 d = segment->to - segment->from;
            const double length = glm::length(d), weight = importance(*segment);
            across += weight * glm::length(flattened(d, towards)) / length;
            all += weight;
        }
        return all > 0 ? across / all : 1;
    }

    /// How well a ray and the one that follows it can be told apart: the angle between them on the screen.
    double parting(const vec3& towards) const
    {
        double sum = 0;
        for (const auto& [before, after] : bends)
        {
            const vec3 a = flattened(before->from - before->to, towards),
                       b = flattened(after->to - after->from, towards);
            const double angle = std::acos(std::clamp(dot(unit(a), unit(b)), -1.0, 1.0));
            sum += std::min(1.0, angle / (35 * pi / 180));
        }
        return bends.empty() ? 1 : sum / double(bends.size());
    }

    double score(const vec3& towards) const
    {
        // Walls that turn their back to the viewer would stand before the scene.
        double behindWalls = 0;
        for (const auto& plane : scene.planes)
        {
            const vec3 N = unit(plane.normal);
            const double side = dot(scene.camera.eye - plane.point, N) < 0 ? -1 : 1;
            if (dot(N, towards) * side < 0.05) behindWalls += 1;
        }
        // The picture on the image plane is seen as the camera sees it, neither from its edge nor from its back; but the
        // view is not the camera's own.
        const double behindCamera = -dot(towards, forward);
        const double edgeOn = std::max(0.0, 0.35 - behindCamera), sameView = std::max(0.0, behindCamera - 0.7);
        return 2.0 * visible(towards) + 1.2 * spread(towards) + 1.0 * parting(towards) - 0.9 * edgeOn - 1.5 * sameView -
               0.3 * behindWalls;
    }

private:
    static constexpr std::size_t mostSampled = 60;

    const SceneDescription& scene;
    double size;
    Scene<double> walls;
    std::vector<const Segment*> sampled;
    std::vector<std::pair<const Segment*, const Segment*>> bends;

    static vec3 flattened(const vec3& d, const vec3& towards) { return d - dot(d, towards) * towards; }

    static double importance(const Segment& segment)
    {
        return segment.role == RayRole::reaches || segment.role == RayRole::blocked ? 0.4 : 1;
    }
};

} // namespace

View fitView(const std::vector<vec3>& points, const vec3& towards, const vec3& up, double aspect,
             const Margins& margins)
{
    View view;
    const auto [right, above, back] = basisOf(towards, up);
    const double tanY = std::tan(view.angle * pi / 360), tanX = tanY * aspect;
    // The free part of the pane is not in its middle: tangents of its four sides.
    const double left = tanX * (1 - 2 * margins.side);
    const double high = tanY * (1 - 2 * margins.top), low = tanY * (1 - 2 * margins.bottom);

    // A point p is shown if its offsets from the viewer are within the tangents times its depth; each side bounds the
    // viewer's place by one plane, so the nearest place on each axis follows from the extremes.
    double maxRight = -infinity<double>, maxLeft = maxRight, maxUp = maxRight, maxDown = maxRight, maxBack = maxRight;
    vec3 middle(0), lowest(infinity<double>), highest(-infinity<double>);
    int count = 0;
    for (const auto& p : points)
    {
        if (!isFinite(p)) continue;
        const double x = dot(p, right), y = dot(p, above), z = dot(p, back);
        maxRight = std::max(maxRight, x + left * z);
        maxLeft = std::max(maxLeft, -x + left * z);
        maxUp = std::max(maxUp, y + high * z);
        maxDown = std::max(maxDown, -y + low * z);
        maxBack = std::max(maxBack, z);
        middle += p;
        lowest = min(lowest, p);
        highest = max(highest, p);
        ++count;
    }
    view.up = above;
    if (count == 0)
    {
        view.position = 5.0 * towards;
        return view;
    }
    middle /= count;
    double z = std::max((maxRight + maxLeft) / (2 * left), (maxUp + maxDown) / (high + low));
    // Never inside what is looked at, and at some distance even from a single point.
    const double span = length(highest - lowest), size = span > 0 ? span : 1;
    z = std::max(z, maxBack + 1e-3 * size);
    const double x = (maxRight - maxLeft) / 2, y = (maxUp - high * z + low * z - maxDown) / 2;
    view.position = x * right + y * above + z * back;
    view.focal = view.position - std::max(1e-3 * size, z - dot(middle, back)) * back;
    return view;
}

vec3 bestDirection(const RayDrawing& drawing, const SceneDescription& scene)
{
    const Judge judge{drawing, scene};
    const vec3 up = judge.up;
    vec3 ahead = judge.forward - dot(judge.forward, up) * up;
    ahead = dot(ahead, ahead) > 1e-9 ? unit(ahead) : across(up)[0];
    const vec3 side = cross(ahead, up);

    vec3 best = side;
    double highest = -infinity<double>;
    for (const double elevation : {14.0, 22.0, 32.0, 44.0})
        for (int azimuth = -180; azimuth < 180; azimuth += 10)
        {
            const double e = elevation * pi / 180, a = azimuth * pi / 180;
            const vec3 towards = std::cos(e) * (std::cos(a) * side - std::sin(a) * ahead) + std::sin(e) * up;
            const double score = judge.score(towards) - 0.15 * std::abs(elevation - 22) / 22;
            if (score > highest + 1e-9)
            {
                highest = score;
                best = towards;
            }
        }
    return best;
}

Projector::Projector(const View& view, int width, int height)
    : position(view.position), scale(height / (2 * std::tan(view.angle * pi / 360))), middleX(width / 2.0),
      middleY(height / 2.0)
{
    const vec3 towards = unit(view.position - view.focal);
    const auto basis = basisOf(towards, view.up);
    right = basis.right;
    up = basis.up;
    back = basis.back;
    nearest = 1e-4 * glm::length(view.position - view.focal);
}

vec2 Projector::onScreen(const vec3& point) const
{
    const double d = depth(point);
    return {middleX + scale * dot(point - position, right) / d, middleY + scale * dot(point - position, up) / d};
}

std::optional<vec2> Projector::operator()(const vec3& point) const
{
    if (!(depth(point) > nearest)) return std::nullopt;
    return onScreen(point);
}

std::optional<std::array<vec2, 2>> Projector::segment(const vec3& from, const vec3& to) const
{
    const double a = depth(from) - nearest, b = depth(to) - nearest;
    if (!(a > 0 || b > 0)) return std::nullopt;
    vec3 p = from, q = to;
    // A little more than to the plane, so that rounding leaves the cut point before the viewer.
    if (a <= 0) p = to + (b / (b - a)) * 0.999 * (from - to);
    if (b <= 0) q = from + (a / (a - b)) * 0.999 * (to - from);
    return std::array{onScreen(p), onScreen(q)};
}

double Projector::pixelsPerUnit(const vec3& point) const
{
    return scale / std::max(depth(point), nearest);
}

double distanceTo(const std::array<vec2, 2>& segment, const vec2& point)
{
    const auto [a, b] = segment;
    const double dx = b[0] - a[0], dy = b[1] - a[1], squared = dx * dx + dy * dy;
    const double t =
        squared > 0 ? std::clamp(((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / squared, 0.0, 1.0) : 0;
    return std::hypot(a[0] + t * dx - point[0], a[1] + t * dy - point[1]);
}

int pickSegment(const RayDrawing& drawing, const Projector& projector, const vec2& at, double tolerance)
{
    int found = -1;
    double nearest = tolerance;
    for (std::size_t i = 0; i < drawing.segments.size(); ++i)
    {
        const auto& segment = drawing.segments[i];
        const auto line = projector.segment(segment.from, segment.to);
        if (!line) continue;
        const double distance = distanceTo(*line, at) + (isRay(segment.role) ? 0 : 0.25 * tolerance);
        if (distance < nearest)
        {
            nearest = distance;
            found = int(i);
        }
    }
    return found;
}

} // namespace rt::viz
