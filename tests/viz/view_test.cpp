#include "viz/drawing/view.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/drawing/labels.h"

namespace rt::viz
{

namespace
{

vec3 anyPoint()
{
    const auto coordinate = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
    return {coordinate(), coordinate(), coordinate()};
}

RC_GTEST_PROP(FitView, ShowsEveryPointWithinTheMargins, ())
{
    std::vector<vec3> points;
    for (int i = *rc::gen::inRange(1, 12); i > 0; --i) points.push_back(anyPoint());
    const vec3 towards = unit(anyPoint() + vec3(0, 0, 0.003));
    const int width = 1000, height = *rc::gen::inRange(300, 1500);
    const View view = fitView(points, towards, {0, 1, 0}, double(width) / height);
    const Projector projector(view, width, height);
    for (const auto& p : points)
    {
        const auto at = projector(p);
        RC_ASSERT(at.has_value());
        RC_ASSERT((*at)[0] > 0.05 * width && (*at)[0] < 0.95 * width);
        RC_ASSERT((*at)[1] > 0.08 * height && (*at)[1] < 0.95 * height);
    }
}

TEST(FitView, UsesTheRoomThatThereIs)
{
    const View view = fitView({{-1, 0, 0}, {1, 0, 0}}, {0, 0, 1}, {0, 1, 0}, 2);
    const Projector projector(view, 1000, 500);
    EXPECT_NEAR((*projector({-1, 0, 0}))[0], 70, 1);
    EXPECT_NEAR((*projector({1, 0, 0}))[0], 930, 1);
}

TEST(FitView, LivesWithNoPointsOrOne)
{
    for (const auto& points : {std::vector<vec3>{}, {{1, 2, 3}}, {{infinity<double>, 0, 0}}})
    {
        const View view = fitView(points, {0, 0, 1}, {0, 1, 0}, 1.5);
        EXPECT_TRUE(isFinite(view.position) && isFinite(view.focal));
        EXPECT_GT(length(view.position - view.focal), 0);
    }
}

TEST(Projector, PutsRightToTheRightAndUpToTheTop)
{
    const Projector projector({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30}, 200, 100);
    const auto middle = *projector({0, 0, 0});
    EXPECT_NEAR(middle[0], 100, 1e-9);
    EXPECT_NEAR(middle[1], 50, 1e-9);
    EXPECT_GT((*projector({1, 0, 0}))[0], middle[0]);
    EXPECT_GT((*projector({0, 1, 0}))[1], middle[1]);
    EXPECT_FALSE(projector({0, 0, 6}));
}

TEST(Projector, CutsSegmentsThatPassTheViewer)
{
    const Projector projector({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30}, 200, 100);
    EXPECT_FALSE(projector.segment({1, 0, 6}, {1, 0, 9}));
    const auto line = projector.segment({1, 0, 0}, {1, 0, 9});
    ASSERT_TRUE(line);
    EXPECT_EQ((*line)[0], *projector({1, 0, 0}));
    EXPECT_GT((*line)[1][0], 1000) << "towards the viewer's own plane it runs off to the right";
}

RayDrawing cross()
{
    RayDrawing drawing;
    drawing.segments = {{.role = RayRole::camera, .node = 0, .from = {-1, 0, 0}, .to = {1, 0, 0}},
                        {.role = RayRole::reflected, .node = 1, .from = {0, -1, 0}, .to = {0, 1, 0}}};
    return drawing;
}

TEST(PickSegment, FindsTheNearestWithinReach)
{
    const Projector projector({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40}, 400, 400);
    const auto beside = [&](const vec3& p, double dx, double dy) {
        const auto at = *projector(p);
        return pickSegment(cross(), projector, {at[0] + dx, at[1] + dy}, 8);
    };
    EXPECT_EQ(beside({0.6, 0, 0}, 0, 5), 0);
    EXPECT_EQ(beside({0, 0.6, 0}, -5, 0), 1);
    EXPECT_EQ(beside({0.6, 0.6, 0}, 0, 0), -1);
    EXPECT_EQ(pickSegment({}, projector, {200, 200}, 8), -1);
}

TEST(BestDirection, LooksFromAboveTheFloorAndNotThroughTheEye)
{
    for (const char* file :
         {"lessons/01_direct_illumination/scenes/diffuse_spheres.toml",
          "lessons/01_direct_illumination/scenes/behind.toml", "lessons/02_mirrors/scenes/pure_specular.toml",
          "lessons/02_mirrors/scenes/facing_mirrors.toml"})
    {
        const auto scene = loadScene(projectFile(file));
        const auto tree = smallestLesson(scene)->inspect(scene, Precision::doubled, scene.pixel());
        const vec3 towards = bestDirection(drawRays(tree, scene, objectExtent(scene)), scene);
        EXPECT_NEAR(length(towards), 1, 1e-9) << file;
        EXPECT_GT(towards.y, 0.1) << file;
        EXPECT_LT(std::abs(dot(towards, unit(scene.camera.eye - scene.camera.target))), 0.9) << file;
    }
}

TEST(BestDirection, LooksAcrossASingleRay)
{
    SceneDescription scene;
    scene.camera.eye = {0, 0, 5};
    scene.camera.target = {0, 0, 0};
    RayDrawing drawing;
    drawing.segments = {{.role = RayRole::camera, .from = {0, 0, 5}, .to = {0, 0, 0}}};
    EXPECT_LT(std::abs(dot(bestDirection(drawing, scene), vec3(0, 0, 1))), 0.75);
    EXPECT_TRUE(isFinite(bestDirection({}, scene)));
}

TEST(PlaceLabels, NeverCoverOneAnotherNorWhatIsTaken)
{
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 60; ++i)
        requests.push_back({.anchors = {{100.0 + 7 * (i % 10), 100.0 + 5 * (i / 10)}}, .width = 40, .height = 16});
    const std::vector<Box> taken{{60, 100, 50, 50}};
    const auto places = placeLabels(requests, 300, 300, {}, taken);
    std::vector<Box> boxes = taken;
    for (const auto& place : places)
        if (place) boxes.push_back(*place);
    EXPECT_GT(boxes.size(), 5U);
    EXPECT_LT(boxes.size(), 50U) << "there is no room for all of them";
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        EXPECT_TRUE(boxes[i].x >= 0 && boxes[i].y >= 0 && boxes[i].x + boxes[i].width <= 300 &&
                    boxes[i].y + boxes[i].height <= 300);
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes[i].overlaps(boxes[j], 0));
    }
}

TEST(PlaceLabels, TheImportantOnesChooseFirst)
{
    const LabelRequest request{.anchors = {{50, 50}}, .width = 90, .height = 90};
    auto important = request;
    important.priority = 5;
    const auto places = placeLabels({request, important}, 110, 200, {}, {});
    EXPECT_FALSE(places[0]);
    EXPECT_TRUE(places[1]);
}

TEST(PlaceLabels, StandBesideLinesButOnTheirOwn)
{
    const std::vector<std::array<vec2, 2>> lines{{{{0, 100}, {200, 100}}}};
    LabelRequest request{.anchors = {{100, 100}}, .width = 30, .height = 14, .gap = 6};
    const auto beside = placeLabels({request}, 200, 200, lines, {})[0];
    ASSERT_TRUE(beside);
    EXPECT_TRUE(beside->y > 100 || beside->y + beside->height < 100);
    request.line = 0;
    const auto on = placeLabels({request}, 200, 200, lines, {})[0];
    ASSERT_TRUE(on);
    EXPECT_NEAR(on->y + on->height / 2, 100, 1e-9);
}

TEST(Labels, StayWhereTheyWere)
{
    LabelRequest request{.anchors = {{100, 100}}, .width = 30, .height = 12, .kept = Box{20, 20, 30, 12}};
    LabelRequest first{.anchors = {{35, 26}}, .width = 30, .height = 12, .priority = 9};
    const auto places = placeLabels({request, first}, 200, 200, {}, {});
    EXPECT_EQ(places[0]->x, 20);
    ASSERT_TRUE(places[1]);
    EXPECT_FALSE(places[1]->overlaps(*places[0], 3));
    // Unless something is there.
    EXPECT_NE(placeLabels({request}, 200, 200, {}, {{10, 10, 50, 50}})[0]->x, 20);
}

} // namespace

} // namespace rt::viz
