// Lesson 01. Scenes are of triangles where the exercises about spheres and planes are not meant: their mistakes do not count
// twice.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

Question askSphere(const V& origin, const V& direction, const V& center, double radius)
{
    const auto ask = [=](const Candidate& c) {
        return Answer{{c.tracer.toSphere(origin, direction, center, radius)}, {}};
    };
    return {fmt::format("t from {} along {} to the sphere of radius {:.6g} at {}", text(origin), text(direction),
                        radius, text(center)),
            Shape::distance,
            forValues,
            ask,
            {}};
}

/// A ray from `origin` that passes the sphere's centre at `aside` radii.
Question askBeside(Random& random, const V& origin, const V& center, double radius, double aside, double sign = 1)
{
    const V towards = glm::normalize(center - origin);
    return askSphere(origin, sign * (center + aside * radius * random.across(towards) - origin), center, radius);
}

Question fromOutside(Random& random, int)
{
    const V center = random.vector(-4, 4);
    const double radius = random.in(0.5, 3);
    return askBeside(random, center + random.in(1.3, 6) * radius * random.direction(), center, radius,
                     random.in(0, 0.9) * 0.8);
}

Question fromInside(Random& random, int)
{
    const V center = random.vector(-4, 4);
    const double radius = random.in(0.5, 3);
    return askSphere(center + random.in(0.05, 0.9) * radius * random.direction(), random.direction(), center, radius);
}

Question besideTheSphere(Random& random, int index)
{
    const V center = random.vector(-4, 4), towards = random.direction();
    const double radius = random.in(0.5, 3);
    // Parallel rays: what counts is the distance of the line from the centre.
    const double aside = index % 2 ? random.in(1.03, 1.2) : random.in(0.85, 0.97);
    return askSphere(center - random.in(2, 6) * radius * towards + aside * radius * random.across(towards), towards,
                     center, radius);
}

Question behindTheRay(Random& random, int index)
{
    const V center = random.vector(-4, 4);
    const double radius = random.in(0.5, 3);
    return askBeside(random, center + random.in(1.3, 6) * radius * random.direction(), center, radius,
                     random.in(0, 0.7), index % 2 ? -1 : 1);
}

Question farAway(Random& random, int index)
{
    const double radius = random.in(1, 3);
    // 100 radii: also the textbook's quadratic, which loses four digits there, stays within the tolerance.
    return askBeside(random, random.in(30, 100) * radius * random.direction(), V(0), radius,
                     index % 4 ? random.in(0, 0.8) : random.in(1.1, 1.5));
}

Question askPlane(const V& origin, const V& direction, const V& point, const V& normal)
{
    const auto ask = [=](const Candidate& c) {
        return Answer{{c.tracer.toPlane(origin, direction, point, normal)}, {}};
    };
    return {fmt::format("t from {} along {} to the plane through {} with normal {}", text(origin), text(direction),
                        text(point), text(normal)),
            Shape::distance,
            forValues,
            ask,
            {}};
}

/// `side`: of the normal, where the ray starts; it goes towards the plane, or away from it.
Question planeFrom(Random& random, double side, bool towards)
{
    const V normal = random.direction(), point = random.vector(-4, 4), across = random.across(normal);
    const double cosine = random.in(0.15, 1), height = random.in(0.3, 6);
    const V origin = point + side * height * normal + random.in(-3, 3) * across;
    return askPlane(origin,
                    (towards ? -side : side) * cosine * normal + std::sqrt(1 - cosine * cosine) * random.across(normal),
                    point, normal);
}

Question alongThePlane(Random& random, int index)
{
    // Along an axis, where D.N is zero for whoever computes it; and nearly so, where it is not.
    V normal(0), D = random.direction();
    const int axis = random.whole(0, 2);
    normal[axis] = random.sign();
    D[axis] = 0;
    D = glm::normalize(D);
    const V point = random.vector(-4, 4);
    V origin = random.vector(-4, 4);
    const double height = random.in(0.3, 2) * random.sign();
    origin[axis] = point[axis] + height;
    if (index % 2) D[axis] = -std::copysign(random.in(0.05, 0.15), height);
    return askPlane(origin, D, point, normal);
}

/// Two large triangles that share the point `at` in their middle, with this normal.
Build& wall(Build& build, const V& at, const V& normal, Random& random, double size = 20)
{
    const V u = random.across(normal), v = cross(normal, u);
    return build.triangle(at - size * u - size * v, at + size * u - size * v, at + size * v * 1.5);
}

struct Spot
{
    Build build;
    V point, normal; ///< the normal on the side of the eye
    V eye;
};

/// A place on a wall of some colour, and an eye that sees it.
Spot spot(Random& random, bool coloured = false)
{
    Spot s;
    s.point = random.vector(-2, 2);
    s.normal = random.direction();
    s.build.material({.name = "wall", .color = coloured ? random.color() : V(random.in(0.4, 1))});
    wall(s.build, s.point + random.in(-2, 2) * random.across(s.normal), s.normal * random.sign(), random);
    s.eye = s.point + random.in(2, 6) * glm::normalize(s.normal + random.in(0, 1) * random.across(s.normal));
    return s;
}

/// On this side of the wall, at a distance, at a cosine of at least 0.2.
V lampAt(Random& random, const Spot& s, double side = 1, double near = 1, double far = 5)
{
    const double cosine = random.in(0.2, 0.95);
    return s.point +
           random.in(near, far) * (side * cosine * s.normal + std::sqrt(1 - cosine * cosine) * random.across(s.normal));
}

Question seen(const char* what, const Spot& s)
{
    return askColor(what, s.build.scene, s.eye, s.point - s.eye);
}

Question oneLamp(Random& random, int)
{
    auto s = spot(random);
    s.build.light(lampAt(random, s), random.in(5, 30));
    return seen("one lamp", s);
}

Question falloff(Random& random, int)
{
    auto s = spot(random);
    s.build.light(lampAt(random, s, 1, 0.3, 12), random.in(5, 30));
    return seen("one lamp, near or far", s);
}

Question severalLamps(Random& random, int)
{
    auto s = spot(random);
    for (int i = random.whole(2, 4); i > 0; --i) s.build.light(lampAt(random, s), random.in(5, 20));
    return seen("several lamps", s);
}

Question colours(Random& random, int)
{
    auto s = spot(random, true);
    for (int i = random.whole(1, 2); i > 0; --i) s.build.light(lampAt(random, s), 20.0 * random.color());
    return seen("coloured lamps on a coloured wall", s);
}

/// No shadow ray leaves its own triangle, so nothing but the cosine tells that the second lamp is behind.
Question behindTheSurface(Random& random, int index)
{
    auto s = spot(random);
    s.build.light(lampAt(random, s, index % 4 ? -1 : 1), random.in(5, 20)).light(lampAt(random, s), random.in(5, 20));
    return seen("a lamp before and a lamp behind the wall", s);
}

Question onThePoint(Random& random, int)
{
    // A floor at height 0 seen straight from above: the point that is hit has the lamp's numbers, bit for bit.
    auto build = Build().material({.name = "floor", .color = random.color()});
    build.triangle({-16, 0, -16}, {16, 0, -16}, {0, 0, 32});
    const V at(random.whole(-8, 8) / 4.0, 0, random.whole(-8, 8) / 4.0);
    build.light(at, random.in(5, 20))
        .light(at + V(random.in(-1, 1), random.in(1, 3), random.in(-1, 1)), random.in(5, 20));
    auto question = askColor("a lamp on the very point, and one above", build.scene, at + V(0, 2, 0), {0, -1, 0});
    question.safe = {}; // beside it the lamp is near and blinding
    return question;
}

/// A small triangle across the way from the point to the lamp, at this share of it.
void block(Random& random, Spot& s, const V& lamp, double share)
{
    const V way = lamp - s.point, towards = glm::normalize(way);
    const V u = random.across(towards), v = cross(towards, u), at = s.point + share * way;
    const double size = random.in(0.1, 0.25);
    s.build.triangle(at - size * u - size * v, at + size * u - size * v, at + 2 * size * v);
}

Question inTheShadow(Random& random, int)
{
    auto s = spot(random, true);
    for (int i = 0; i < 3; ++i)
    {
        const V lamp = lampAt(random, s, 1, 3, 6);
        s.build.light(lamp, random.in(10, 30));
        if (i == 0) block(random, s, lamp, random.in(0.3, 0.7));
    }
    return seen("three lamps, one of them in the shadow", s);
}

/// Only whether the lamps are visible: what is made of it is another exercise.
Question visible(Random& random, int index, double blocked, double free)
{
    auto s = spot(random);
    for (int i = 0; i < 2; ++i)
    {
        const V lamp = lampAt(random, s, 1, 3, 6);
        s.build.light(lamp, 20);
        const double share = (index + i) % 2 ? blocked : free;
        if (share > 0) block(random, s, lamp, share);
    }
    auto question = seen("two lamps", s);
    const auto scene = s.build.scene;
    const V origin = s.eye, direction = s.point - s.eye;
    question.what =
        fmt::format("is lamp 0, is lamp 1 visible where the ray from {} along {} ends?", text(origin), text(direction));
    question.ask = [=](const Candidate& candidate) {
        const auto tree = candidate.tracer.tree(scene, origin, direction);
        Answer answer;
        for (const auto& shadow : tree.shadows)
        {
            answer.values.push_back(shadow.visible);
            answer.names.push_back(fmt::format("lamp {} visible", shadow.light));
        }
        return answer;
    };
    return question;
}

} // namespace

std::vector<Criterion> directCriteria()
{
    return {
        {"01-sphere", "from outside", fromOutside},
        {"01-sphere", "from inside", fromInside},
        {"01-sphere", "just hit, just missed", besideTheSphere},
        {"01-sphere", "before and behind the ray", behindTheRay},
        {"01-sphere", "far away", farAway},
        {"01-plane", "from its normal's side", [](Random& r, int) { return planeFrom(r, 1, true); }},
        {"01-plane", "from the other side", [](Random& r, int) { return planeFrom(r, -1, true); }},
        {"01-plane", "before and behind the ray", [](Random& r, int i) { return planeFrom(r, r.sign(), i % 2 == 0); }},
        {"01-plane", "along it and nearly so", alongThePlane},
        {"01-direct", "one lamp", oneLamp},
        {"01-direct", "near and far lamps", falloff},
        {"01-direct", "several lamps", severalLamps},
        {"01-direct", "colours", colours},
        {"01-direct", "a lamp behind the surface", behindTheSurface},
        {"01-direct", "a lamp on the point", onThePoint},
        {"01-direct", "in the shadow", inTheShadow},
        {"01-visible", "something in the way or not",
         [](Random& r, int i) { return visible(r, i, r.in(0.3, 0.7), 0); }},
        {"01-visible", "something before or behind the lamp",
         [](Random& r, int i) { return visible(r, i, r.in(0.3, 0.7), r.in(1.2, 1.8)); }},
    };
}

} // namespace rt::grade
