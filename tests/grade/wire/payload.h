// The fields of what is sent, once for both directions.
#pragma once

#include "common/scene/scene_description.h"
#include "common/tree/ray_tree.h"
#include "lessons/00_geometry/functions.h"
#include "tests/grade/wire/bytes.h"

namespace rt::grade
{

/// T as `Wire` sees it: a Writer only reads it.
template <class Wire, class T>
using Of = std::conditional_t<Wire::reads, T, const T>;

// Checks are the reader's: leastBytes writes empty values, and what arrives is what counts.

template <class Wire, class... Values>
void all(Wire& wire, Values&... values)
{
    (carry(wire, values), ...);
}

// Scenes: what a Scene is made of, and no more. Titles and file names could tell what is being tested.

template <class Wire>
void fields(Wire& wire, Of<Wire, CameraDescription>& c)
{
    all(wire, c.eye, c.target, c.up, c.verticalFov, c.width, c.height);
    if constexpr (Wire::reads)
        if (c.width < 1 || c.height < 1 || c.width > largestPictureSide || c.height > largestPictureSide)
            throw FrameError("a camera's picture is " + std::to_string(c.width) + "x" + std::to_string(c.height) +
                             " pixels");
}

template <class Wire>
void fields(Wire& wire, Of<Wire, TraceSettings>& t)
{
    all(wire, t.maxDepth, t.cutoff);
    wire.choice(t.atCap, AtCap::direct);
    wire.choice(t.fresnel, FresnelModel::none);
    wire.choice(t.shadowThroughGlass, ShadowThroughGlass::tint);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, Sun>& sun)
{
    all(wire, sun.direction, sun.color, sun.size);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, Material<double>>& m)
{
    all(wire, m.name, m.color, m.mirror, m.ior, m.iorOutside, m.glossy, m.exponent);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, SphereDescription>& s)
{
    all(wire, s.center, s.radius, s.material);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, PlaneDescription>& p)
{
    all(wire, p.point, p.normal, p.material, p.hasChecker, p.checkerColor, p.checkerSize);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, TriangleDescription>& t)
{
    all(wire, t.vertices, t.material);
}

/// What a description shares, it owns alone after the wire; null comes back as null.
template <class T>
void shared(Writer& wire, const std::shared_ptr<const T>& value)
{
    wire.flag(value != nullptr);
    if (value) carry(wire, *value);
}

template <class T>
void shared(Reader& wire, std::shared_ptr<const T>& value)
{
    bool present = false;
    wire.flag(present);
    value.reset();
    if (!present) return;
    auto read = std::make_shared<T>();
    carry(wire, *read);
    value = std::move(read);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, MeshDescription>& m)
{
    all(wire, m.file, m.material);
    shared(wire, m.triangles);
    if constexpr (Wire::reads)
        if (!m.triangles) throw FrameError("a mesh has no triangles");
}

template <class Wire>
void fields(Wire& wire, Of<Wire, SkyDescription>& sky)
{
    all(wire, sky.present, sky.color, sky.zenith, sky.sun);
    wire.choice(sky.mapping, SkyMapping::angular);
    shared(wire, sky.image);
    if constexpr (Wire::reads)
        if (sky.image && sky.image->pixels.empty()) throw FrameError("the picture of the sky is empty");
}

template <class Wire>
void fields(Wire& wire, Of<Wire, Light<double>>& light)
{
    all(wire, light.position, light.color);
}

inline void checkMaterials(const SceneDescription& scene)
{
    const auto check = [&](const auto& objects) {
        for (const auto& object : objects)
            if (object.material < 0 || object.material >= int(scene.materials.size()))
                throw FrameError("there is no material " + std::to_string(object.material));
    };
    check(scene.spheres);
    check(scene.planes);
    check(scene.triangles);
    check(scene.meshes);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, SceneDescription>& scene)
{
    all(wire, scene.camera, scene.trace, scene.sky, scene.materials, scene.spheres, scene.planes, scene.triangles,
        scene.meshes, scene.lights);
    if constexpr (Wire::reads) checkMaterials(scene);
}

// Trees. Whoever reads one may follow its indices.

template <class Wire>
void fields(Wire& wire, Of<Wire, RayTree::Hit>& h)
{
    all(wire, h.t, h.point, h.normal, h.primitive, h.material, h.inside, h.color);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, RayTree::Node>& n)
{
    all(wire, n.id, n.parent);
    wire.choice(n.kind, RayKind::transmitted);
    all(wire, n.depth, n.origin, n.direction, n.hit, n.n1, n.n2, n.fresnel, n.weight, n.throughput, n.radiance, n.own,
        n.contribution);
    wire.choice(n.end, End::black);
    all(wire, n.tir, n.orphan, n.line, n.returnLine, n.step, n.returnStep);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, RayTree::Shadow::Blocker>& b)
{
    all(wire, b.primitive, b.point);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, RayTree::Shadow>& s)
{
    all(wire, s.node, s.light, s.direction, s.distance, s.visible, s.tint, s.blocker, s.line, s.step);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, RayTree::Capped>& c)
{
    carry(wire, c.node);
    wire.choice(c.kind, RayKind::transmitted);
    all(wire, c.direction, c.weight, c.radiance);
    wire.choice(c.reason, End::black);
    all(wire, c.line, c.step);
}

/// Nodes stand in preorder and number themselves; parents come first; nothing belongs to a node that is not there.
inline void checkIndices(const RayTree& tree)
{
    const int nodes = int(tree.nodes.size());
    for (int id = 0; id < nodes; ++id)
    {
        const auto& node = tree.nodes[std::size_t(id)];
        if (node.id != id) throw FrameError("node " + std::to_string(id) + " calls itself " + std::to_string(node.id));
        if (node.parent < -1 || node.parent >= id)
            throw FrameError("node " + std::to_string(id) + " has the parent " + std::to_string(node.parent));
        if (node.depth < 0 || node.depth > 1 << 20)
            throw FrameError("node " + std::to_string(id) + " has the depth " + std::to_string(node.depth));
        if (node.n1.has_value() != node.n2.has_value())
            throw FrameError("node " + std::to_string(id) + " has one index of refraction");
        if (node.line < 0 || node.returnLine < 0 || node.step < 0 || node.returnStep < 0)
            throw FrameError("node " + std::to_string(id) + " has a line or step below 0");
    }
    const auto check = [&](const auto& entries, const char* what) {
        for (const auto& entry : entries)
            if (entry.node < 0 || entry.node >= nodes || entry.line < 0 || entry.step < 0)
                throw FrameError(std::string(what) + " belongs to node " + std::to_string(entry.node) + " of " +
                                 std::to_string(nodes) + ", line " + std::to_string(entry.line));
    };
    check(tree.shadows, "a shadow ray");
    check(tree.capped, "a ray that was not followed");
    for (const auto& shadow : tree.shadows)
        if (shadow.light < 0) throw FrameError("a shadow ray has the light " + std::to_string(shadow.light));
}

template <class Wire>
void fields(Wire& wire, Of<Wire, RayTree>& tree)
{
    all(wire, tree.version, tree.lesson, tree.scene, tree.source, tree.real, tree.pixel, tree.maxDepth, tree.nodes,
        tree.shadows, tree.capped);
    if constexpr (Wire::reads) checkIndices(tree);
}

// Lesson 00.

template <class Wire>
void fields(Wire& wire, Of<Wire, lesson00::SlopeIntercept>& line)
{
    all(wire, line.a, line.b);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, lesson00::Implicit>& line)
{
    all(wire, line.A, line.B, line.C);
}

template <class Wire>
void fields(Wire& wire, Of<Wire, lesson00::Parametric>& line)
{
    all(wire, line.O, line.D);
}

/// The bytes of one value.
template <class T>
std::string encode(const T& value)
{
    Writer writer;
    carry(writer, value);
    return std::move(writer.bytes);
}

/// The value of these bytes, all of them. Throws FrameError.
template <class T>
T decode(std::string_view bytes)
{
    Reader reader(bytes);
    T value{};
    carry(reader, value);
    reader.end();
    return value;
}

} // namespace rt::grade
