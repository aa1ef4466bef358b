// Records a ray tree while a lesson traces.
#pragma once

#include "common/scene/recorder.h"
#include "common/scene/scene.h"
#include "common/tree/ray_tree.h"

namespace rt
{

/// Total: whatever a lesson or a student's exercise tells it, in whatever order, gives a tree and never a crash. A ray
/// whose depth does not follow from an open node becomes an orphan. A recorder without a tree records nothing.
template <std::floating_point Real>
class TreeRecorder
{
public:
    TreeRecorder() = default;
    TreeRecorder(RayTree& recorded, const Scene<Real>& from) : tree(&recorded), scene(&from) {}

    void ray(const Ray<Real>& ray, const std::optional<Hit<Real>>& hit, SourceLine where = SourceLine::current())
    {
        if (!tree) return;
        closeDownTo(ray.depth);
        RayTree::Node node;
        node.id = int(tree->nodes.size());
        node.kind = ray.kind;
        node.depth = std::clamp(ray.depth, 0, 1 << 20);
        node.origin = Vec3<double>(ray.O);
        node.direction = Vec3<double>(ray.D);
        node.weight = double(ray.weight);
        node.line = int(where.line());
        node.step = ++steps;
        if (const auto* parent = openNode(); parent && parent->depth == node.depth - 1)
        {
            node.parent = parent->id;
            node.throughput = passedOn(*parent, ray.weight);
        }
        else
            node.orphan = node.id != 0 || node.depth != 0;
        if (hit)
        {
            node.hit = {double(hit->t),
                        Vec3<double>(hit->I),
                        Vec3<double>(hit->outwardNormal()),
                        scene->primitiveName(hit->I.on),
                        hit->mat.name,
                        hit->inside,
                        Vec3<double>(hit->mat.color)};
            if (hit->mat.isDielectric())
            {
                node.n1 = double(hit->n1);
                node.n2 = double(hit->n2);
            }
            node.end = largestChannel(node.hit->color) == 0 ? End::black : End::absorbed;
            // The policy at_cap = "direct" looks one ray further than MAXDEPTH, but does not go on from there.
            if (ray.depth > tree->maxDepth) node.end = End::cap;
        }
        else
        {
            node.end = End::miss;
            node.returnLine = node.line;
            node.returnStep = ++steps;
        }
        if (auto* parent = openNode(); parent && node.parent == parent->id)
        {
            parent->end = End::none;
            noteTotalReflection(*parent, ray);
        }
        tree->nodes.push_back(node);
        open.push_back({node.id, ray.weight});
    }

    void shadow(const Light<Real>& light, const Point<Real>& I, const Vec3<Real>& L, Real distance, bool visible,
                SourceLine where = SourceLine::current())
    {
        if (!tree || open.empty()) return;
        RayTree::Shadow shadow;
        shadow.node = open.back().node;
        while (shadow.light < int(scene->lights.size()) && &scene->lights[std::size_t(shadow.light)] != &light)
            ++shadow.light;
        shadow.direction = Vec3<double>(L);
        shadow.distance = double(distance);
        shadow.visible = visible;
        if (visible) shadow.tint = Vec3<double>(scene->shadowTint(I, L, distance));
        shadow.line = int(where.line());
        shadow.step = ++steps;
        if (!visible)
        {
            uncountRay();
            if (const auto hit = scene->intersect(Ray<Real>{.O = I, .D = L, .from = I.on}))
                shadow.blocker = {scene->primitiveName(hit->I.on), Vec3<double>(hit->I)};
        }
        tree->shadows.push_back(shadow);
    }

    void own(const Vec3<Real>& color)
    {
        if (!tree || open.empty()) return;
        open.back().hasOwn = true;
        auto& node = tree->nodes[std::size_t(open.back().node)];
        setOwn(node, color);
        if (!node.hit) close(color); // the sky is all that a miss returns
    }

    void fresnel(Real Fr)
    {
        if (tree && !open.empty()) tree->nodes[std::size_t(open.back().node)].fresnel = double(Fr);
    }

    void capped(const Ray<Real>& ray, SourceLine where = SourceLine::current()) { capped(ray, Vec3<Real>(0), where); }

    void capped(const Ray<Real>& ray, const Vec3<Real>& color, SourceLine where = SourceLine::current())
    {
        notFollowed(ray, color, End::cap, where);
    }

    void cutoff(const Ray<Real>& ray, SourceLine where = SourceLine::current())
    {
        notFollowed(ray, Vec3<Real>(0), End::cutoff, where);
    }

    void color(const Vec3<Real>& color, SourceLine where = SourceLine::current())
    {
        if (!tree) return;
        // A miss that returned black said nothing: this colour is its parent's.
        while (!open.empty() && !tree->nodes[std::size_t(open.back().node)].hit) open.pop_back();
        if (open.empty()) return;
        auto& node = tree->nodes[std::size_t(open.back().node)];
        node.returnLine = int(where.line());
        node.returnStep = ++steps;
        if (!open.back().hasOwn) setOwn(node, color - open.back().brought);
        close(color);
    }

private:
    struct Open
    {
        int node;
        Real weight;                 ///< its share of its parent
        Vec3<Real> brought{0, 0, 0}; ///< by its children so far
        bool hasOwn = false;         ///< the lesson has said what the point itself sends
    };

    RayTree* tree = nullptr;
    const Scene<Real>* scene = nullptr;
    std::vector<Open> open; // the nodes from the root to the current one
    int steps = 0;          // what has happened so far

    RayTree::Node* openNode() { return open.empty() ? nullptr : &tree->nodes[std::size_t(open.back().node)]; }

    /// A ray of this depth is about to begin: deeper and equally deep ones are over.
    void closeDownTo(int depth)
    {
        while (!open.empty() && openNode()->depth >= depth) open.pop_back();
    }

    static Vec3<double> passedOn(const RayTree::Node& node, Real weight)
    {
        return node.throughput * double(weight) * (node.hit ? node.hit->color : Vec3<double>(1));
    }

    static void setOwn(RayTree::Node& node, const Vec3<Real>& color)
    {
        node.own = Vec3<double>(color);
        node.contribution += node.throughput * node.own;
    }

    /// Adds what a child brought to the open node.
    void bring(Real weight, const Vec3<Real>& color)
    {
        if (open.empty()) return;
        const auto& node = *openNode();
        open.back().brought += weight * (node.hit ? Vec3<Real>(node.hit->color) * color : color);
    }

    /// The current node returns `color` to its parent.
    void close(const Vec3<Real>& color)
    {
        const Open last = open.back();
        open.pop_back();
        tree->nodes[std::size_t(last.node)].radiance = Vec3<double>(color);
        if (tree->nodes[std::size_t(last.node)].parent >= 0) bring(last.weight, color);
    }

    void notFollowed(const Ray<Real>& ray, const Vec3<Real>& color, End reason, SourceLine where)
    {
        if (!tree) return;
        closeDownTo(ray.depth);
        auto* parent = openNode();
        if (!parent) return;
        if (parent->end != End::none) parent->end = reason;
        noteTotalReflection(*parent, ray);
        tree->capped.push_back({parent->id, ray.kind, Vec3<double>(ray.D), double(ray.weight), Vec3<double>(color),
                                reason, int(where.line()), ++steps});
        parent->contribution += passedOn(*parent, ray.weight) * Vec3<double>(color);
        bring(ray.weight, color);
    }

    /// A dielectric that reflects all of a ray on its way into the thinner medium.
    static void noteTotalReflection(RayTree::Node& parent, const Ray<Real>& child)
    {
        if (child.kind == RayKind::reflected && child.weight == 1 && parent.n1 && *parent.n1 > *parent.n2)
            parent.tir = true;
    }
};

} // namespace rt
