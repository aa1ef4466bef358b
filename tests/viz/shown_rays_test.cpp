#include "viz/drawing/shown_rays.h"

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"

namespace rt::viz
{

namespace
{

Session session(int lesson)
{
    Session chosen;
    chosen.scene = loadScene(projectFile(findLesson(lesson)->scene));
    chosen.source = lessonSource(*findLesson(lesson), Precision::doubled);
    chosen.source.render = nullptr; // only the trees count here
    chosen.probe = chosen.scene.pixel();
    return chosen;
}

struct DrawnRays
{
    Controller controller;
    Extent objects;
    RayDrawing all;

    explicit DrawnRays(Session chosen)
        : controller(std::move(chosen)), objects(objectExtent(controller.scene())),
          all(drawRays(controller.tree(), controller.scene(), objects))
    {
    }

    RayDrawing shown() const { return shownPart(all, controller); }
    int count(RayRole role) const
    {
        const auto part = shown();
        return int(std::count_if(part.segments.begin(), part.segments.end(),
                                 [role](const auto& segment) { return segment.role == role; }));
    }
};

TEST(ShownRays, AreAllOfThemAtFirst)
{
    const DrawnRays drawn(session(6));
    EXPECT_EQ(drawn.shown().segments.size(), drawn.all.segments.size());
    EXPECT_EQ(drawn.shown().blockers.size(), drawn.all.blockers.size());
    EXPECT_EQ(drawn.shown().nodes, drawn.all.nodes);
}

TEST(ShownRays, NothingHasBeenTracedBeforeTheFirstStep)
{
    DrawnRays drawn(session(6));
    drawn.controller.stepTo(0);
    EXPECT_TRUE(drawn.shown().segments.empty());
    EXPECT_TRUE(drawn.shown().blockers.empty());
}

TEST(ShownRays, EachStepShowsNoLessThanTheOneBefore)
{
    DrawnRays drawn(session(6));
    std::size_t before = 0;
    for (int step = 0; step <= drawn.controller.lastStep(); ++step)
    {
        drawn.controller.stepTo(step);
        const auto part = drawn.shown();
        EXPECT_GE(part.segments.size(), before);
        before = part.segments.size();
        for (const auto& segment : part.segments) EXPECT_TRUE(drawn.controller.isReached(segment.node));
    }
    EXPECT_EQ(before, drawn.all.segments.size());
}

TEST(ShownRays, AKindThatIsHiddenIsNotDrawn)
{
    DrawnRays drawn(session(6));
    const std::pair<Kind, RayRole> pairs[] = {{Kind::camera, RayRole::camera},
                                              {Kind::reflected, RayRole::reflected},
                                              {Kind::transmitted, RayRole::transmitted},
                                              {Kind::lit, RayRole::reaches},
                                              {Kind::blocked, RayRole::blocked}};
    for (const auto& [kind, role] : pairs)
    {
        if (drawn.count(role) == 0) continue;
        drawn.controller.toggle(kind);
        EXPECT_EQ(drawn.count(role), 0) << name(kind);
        if (kind == Kind::blocked)
        {
            EXPECT_EQ(drawn.count(RayRole::beyond), 0);
            EXPECT_TRUE(drawn.shown().blockers.empty());
        }
        drawn.controller.toggle(kind);
        EXPECT_GT(drawn.count(role), 0) << name(kind);
    }
    EXPECT_GT(drawn.count(RayRole::transmitted), 0);
}

TEST(ShownRays, WhatIsTooWeakIsHiddenWithItsShadowRays)
{
    DrawnRays drawn(session(6));
    drawn.controller.setWeakest(0.5);
    const auto part = drawn.shown();
    EXPECT_LT(part.nodes, drawn.all.nodes);
    EXPECT_GT(part.nodes, 0);
    for (const auto& segment : part.segments)
        EXPECT_GE(largestChannel(drawn.controller.tree().nodes[std::size_t(segment.node)].throughput), 0.5);
}

TEST(OtherRays, AreNoneWhereTheTreesAgree)
{
    Session same = session(6);
    same.other = same.source;
    const DrawnRays drawn(std::move(same));
    EXPECT_TRUE(otherRays(drawn.controller, drawn.objects).empty());
}

/// Glass whose two indices are swapped bends rays the other way.
TreeSource swappedIndices(TreeSource source)
{
    return with(std::move(source), "swapped", [](SceneDescription& scene) {
        for (auto& material : scene.materials)
            if (material.ior > 0) std::swap(material.ior, material.iorOutside);
    });
}

TEST(OtherRays, StandWhereTheOtherTracerWentAnotherWay)
{
    Session two = session(6);
    two.other = swappedIndices(two.source);
    const DrawnRays drawn(std::move(two));
    ASSERT_TRUE(drawn.controller.comparison() && drawn.controller.comparison()->first);
    EXPECT_EQ(drawn.controller.comparison()->first->field, "n1");
    const auto rays = otherRays(drawn.controller, drawn.objects);
    ASSERT_FALSE(rays.empty());
    for (const auto& ray : rays)
    {
        EXPECT_EQ(ray.role, RayRole::other);
        EXPECT_TRUE(ray.name.ends_with("′")) << ray.name;
        EXPECT_LT(std::size_t(ray.node), drawn.controller.tree().nodes.size());
    }
}

} // namespace

} // namespace rt::viz
