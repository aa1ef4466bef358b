#include "viz/state/controller.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/state/node_text.h"

namespace rt::viz
{

namespace
{

Session mirrorSession()
{
    Session session;
    session.scene = loadScene(projectFile("lessons/02_mirrors/scenes/pure_specular.toml"));
    session.scene.camera.width = 64;
    session.scene.camera.height = 48;
    session.source = lessonSource(*findLesson(2), Precision::doubled);
    session.probe = std::array{36, 25};
    return session;
}

/// A controller, and what it has told its views.
struct Watched
{
    Controller controller{mirrorSession()};
    std::vector<unsigned> told;

    Watched()
    {
        controller.changed = [this](unsigned changes) { told.push_back(changes); };
    }
};

TEST(Controller, BeginsWithThePictureAndTheTreeOfItsPixel)
{
    const Controller controller(mirrorSession());
    ASSERT_EQ(controller.picture().width, 64);
    ASSERT_FALSE(controller.tree().nodes.empty());
    EXPECT_EQ(controller.tree().nodes[0].radiance, controller.picture().at(36, 25));
    EXPECT_EQ(controller.selected(), 0);
    EXPECT_EQ(controller.pixel(), (std::array{36, 25}));
}

TEST(Controller, TracesTheTreeOfTheChosenPixel)
{
    Watched watched;
    watched.controller.choosePixel(5, 40);
    EXPECT_EQ(watched.controller.pixel(), (std::array{5, 40}));
    EXPECT_EQ(watched.controller.tree().nodes.at(0).radiance, watched.controller.picture().at(5, 40));
    EXPECT_EQ(watched.told, std::vector<unsigned>{changedTree | changedNode | changedStep});
}

TEST(Controller, SaysNothingWhenNothingChanges)
{
    Watched watched;
    watched.controller.choosePixel(36, 25);
    watched.controller.selectNode(0);
    watched.controller.selectNode(-1);
    watched.controller.selectNode(1000);
    watched.controller.parentNode();
    watched.controller.setMaxDepth(watched.controller.maxDepth());
    EXPECT_TRUE(watched.told.empty());
}

TEST(Controller, KeepsThePixelInsideThePicture)
{
    Controller controller(mirrorSession());
    controller.choosePixel(-7, 99);
    EXPECT_EQ(controller.pixel(), (std::array{0, 47}));
    controller.movePixel(-1, 1);
    EXPECT_EQ(controller.pixel(), (std::array{0, 47}));
    controller.movePixel(3, -2);
    EXPECT_EQ(controller.pixel(), (std::array{3, 45}));
}

TEST(Controller, WalksThroughTheNodesAndBackToTheParent)
{
    Controller controller(mirrorSession());
    const int last = int(controller.tree().nodes.size()) - 1;
    ASSERT_GE(last, 1);
    for (int i = 0; i < 100; ++i) controller.nextNode();
    EXPECT_EQ(controller.selected(), last);
    const int parent = controller.node()->parent;
    controller.parentNode();
    EXPECT_EQ(controller.selected(), parent);
    for (int i = 0; i < 100; ++i) controller.previousNode();
    EXPECT_EQ(controller.selected(), 0);
}

TEST(Controller, KeepsTheSelectionWhereTheNewTreeHasTheSameRay)
{
    Controller controller(mirrorSession());
    controller.selectNode(1);
    controller.movePixel(0, -1);
    ASSERT_GE(controller.tree().nodes.size(), 2U);
    EXPECT_EQ(controller.selected(), 1);
    controller.choosePixel(2, 2); // the wall: a single ray
    ASSERT_EQ(controller.tree().nodes.size(), 1U);
    EXPECT_EQ(controller.selected(), 0);
}

TEST(Controller, ALowerCapMakesAShallowerTreeAndAnotherPicture)
{
    Watched watched;
    ASSERT_GE(watched.controller.deepest(), 1);
    const Image before = watched.controller.picture();
    watched.controller.selectNode(1);
    watched.controller.setMaxDepth(0);
    EXPECT_EQ(watched.controller.deepest(), 0);
    EXPECT_EQ(watched.controller.selected(), 0);
    EXPECT_EQ(watched.told.back(), unsigned{changedTree | changedNode | changedStep});
    watched.controller.wait();
    EXPECT_EQ(watched.told.back(), unsigned{changedPicture | changedMessage});
    EXPECT_FALSE(compare(watched.controller.picture(), before, 0, 0).equal());
    EXPECT_EQ(watched.controller.tree().nodes.at(0).radiance, watched.controller.picture().at(36, 25));
    watched.controller.setMaxDepth(-3);
    EXPECT_EQ(watched.controller.maxDepth(), 0);
}

TEST(Controller, AGivenRayHasNoPixelUntilOneIsChosen)
{
    Session session = mirrorSession();
    session.probe = GivenRay{{0, 2, 0}, {0, -3, 0}};
    Controller controller(std::move(session));
    EXPECT_FALSE(controller.pixel());
    EXPECT_EQ(controller.tree().nodes.at(0).hit->primitive, "plane0");
    controller.movePixel(1, 0);
    EXPECT_TRUE(controller.pixel());
}

TEST(Controller, LivesWithAnEmptyTree)
{
    Session session = mirrorSession();
    // As an exercise that throws before it has traced anything.
    session.source.inspect = [](const auto&, const auto&, const auto&) { return RayTree(); };
    Controller controller(std::move(session));
    EXPECT_EQ(controller.node(), nullptr);
    EXPECT_EQ(controller.deepest(), 0);
    controller.nextNode();
    controller.parentNode();
    EXPECT_EQ(controller.selected(), 0);
    EXPECT_EQ(nodeText(controller, 80).size(), 1U);
    controller.stepBy(-1);
    controller.setPlaying(true);
    EXPECT_FALSE(controller.isPlaying());
    EXPECT_EQ(controller.current(), nullptr);
}

TEST(Controller, ShowsEverythingUntilItIsStepped)
{
    const Controller controller(mirrorSession());
    EXPECT_TRUE(controller.isComplete());
    EXPECT_EQ(controller.current(), nullptr);
    for (const auto& node : controller.tree().nodes)
    {
        EXPECT_TRUE(controller.isReached(node.id));
        EXPECT_TRUE(controller.hasReturned(node.id));
    }
}

TEST(Controller, StepsThroughTheEventsForwardsAndBackwards)
{
    Controller controller(mirrorSession());
    controller.stepTo(0);
    EXPECT_EQ(controller.current(), nullptr);
    EXPECT_FALSE(controller.isReached(0));
    controller.stepBy(1);
    ASSERT_NE(controller.current(), nullptr);
    EXPECT_EQ(controller.current()->kind, Event::Kind::follow);
    EXPECT_TRUE(controller.isReached(0));
    EXPECT_FALSE(controller.isReached(1));
    EXPECT_FALSE(controller.hasReturned(0));
    for (int step = 1; step <= controller.lastStep(); ++step)
    {
        controller.stepTo(step);
        EXPECT_EQ(controller.selected(), controller.current()->node) << step;
    }
    EXPECT_TRUE(controller.hasReturned(0));
    controller.stepBy(-1);
    EXPECT_FALSE(controller.hasReturned(0));
    controller.stepBy(1000);
    EXPECT_EQ(controller.step(), controller.lastStep());
    controller.stepBy(-1000);
    EXPECT_EQ(controller.step(), 0);
}

TEST(Controller, ANodeThatIsNotYetReachedIsSteppedTo)
{
    Controller controller(mirrorSession());
    controller.stepTo(1);
    ASSERT_FALSE(controller.isReached(1));
    controller.selectNode(1);
    EXPECT_TRUE(controller.isReached(1));
    EXPECT_EQ(controller.selected(), 1);
    EXPECT_FALSE(controller.isComplete());
    controller.selectNode(0); // already reached: time stands still
    const int step = controller.step();
    EXPECT_EQ(controller.selected(), 0);
    EXPECT_EQ(controller.step(), step);
}

TEST(Controller, PlaysFromTheBeginningToTheEndOnce)
{
    Controller controller(mirrorSession());
    controller.setPlaying(true);
    EXPECT_EQ(controller.step(), 0);
    int steps = 0;
    while (controller.isPlaying() && steps < 1000)
    {
        controller.playOn();
        ++steps;
    }
    EXPECT_EQ(steps, controller.lastStep());
    EXPECT_TRUE(controller.isComplete());
    controller.playOn();
    EXPECT_TRUE(controller.isComplete());
}

TEST(Controller, HidesKindsAndWeakRays)
{
    Controller controller(mirrorSession());
    ASSERT_EQ(controller.tree().nodes.at(1).kind, RayKind::reflected);
    EXPECT_TRUE(controller.isShown(1));
    controller.toggle(Kind::reflected);
    EXPECT_FALSE(controller.isShown(1));
    EXPECT_TRUE(controller.isShown(0));
    controller.toggle(Kind::reflected);
    const double throughput = largestChannel(controller.tree().nodes[1].throughput);
    ASSERT_GT(throughput, 0);
    ASSERT_LT(throughput, 1);
    controller.setWeakest(throughput);
    EXPECT_TRUE(controller.isShown(1));
    controller.setWeakest(std::nextafter(throughput, 1.0));
    EXPECT_FALSE(controller.isShown(1));
    EXPECT_TRUE(controller.isShown(0));
}

/// Glass, with Schlick's approximation in the other source.
Session glassSession()
{
    Session session = mirrorSession();
    session.scene = loadScene(projectFile(findLesson(6)->scene));
    session.source = lessonSource(*findLesson(6), Precision::doubled);
    session.source.render = nullptr; // only the trees count here
    session.probe = session.scene.pixel();
    return session;
}

TEST(Comparison, FindsNothingBetweenATreeAndItself)
{
    Session session = glassSession();
    session.other = session.source;
    const Controller controller(std::move(session));
    ASSERT_NE(controller.comparison(), nullptr);
    EXPECT_FALSE(controller.comparison()->first);
    const auto& differs = controller.comparison()->match.differs;
    EXPECT_EQ(std::count(differs.begin(), differs.end(), true), 0);
}

TEST(Comparison, NamesFresnelFirstWhereSchlickIsUsed)
{
    Session session = glassSession();
    session.other = with(session.source, "schlick", [](auto& scene) { scene.trace.fresnel = FresnelModel::schlick; });
    Controller controller(std::move(session));
    ASSERT_TRUE(controller.comparison() && controller.comparison()->first);
    EXPECT_EQ(controller.comparison()->first->field, "fresnel");
    controller.toggleComparison();
    EXPECT_EQ(controller.comparison(), nullptr);
    controller.toggleComparison();
    controller.choosePixel(1, 1);
    EXPECT_TRUE(controller.comparison());
}

/// As another program: asks in the background.
TEST(SlowSource, LeavesTheOldTreeAndOneSentenceWhenItFails)
{
    Session session = mirrorSession();
    session.source.isSlow = true;
    auto fails = std::make_shared<bool>(false);
    session.source.inspect = [fails, ask = session.source.inspect](const auto& scene, const auto& probe,
                                                                   const auto& stop) {
        if (*fails) throw std::runtime_error("the other program crashed");
        return ask(scene, probe, stop);
    };
    Controller controller(std::move(session));
    controller.wait();
    const auto nodes = controller.tree().nodes.size();
    ASSERT_GT(nodes, 0U);
    *fails = true;
    controller.choosePixel(2, 2);
    controller.wait();
    EXPECT_EQ(controller.message(), "the other program crashed");
    EXPECT_EQ(controller.tree().nodes.size(), nodes);
    *fails = false;
    controller.choosePixel(3, 2);
    controller.wait();
    EXPECT_EQ(controller.message(), "");
    EXPECT_EQ(controller.tree().pixel, (std::array{3, 2}));
}

TEST(SlowSource, TracesTheSamePixelAgain)
{
    Session session = mirrorSession();
    session.source.isSlow = true;
    auto asked = std::make_shared<int>(0);
    session.source.inspect = [asked, ask = session.source.inspect](const auto& scene, const auto& probe,
                                                                   const auto& stop) {
        ++*asked;
        return ask(scene, probe, stop);
    };
    Controller controller(std::move(session));
    controller.wait();
    controller.choosePixel(36, 25);
    EXPECT_EQ(controller.message().substr(0, 12), "waiting for ");
    EXPECT_EQ(controller.tone(), Tone::waiting);
    controller.wait();
    EXPECT_EQ(*asked, 2);
    EXPECT_EQ(controller.message(), "");
}

/// A session whose scene's file can be changed: `next` is what it then holds.
struct ChangingScene
{
    std::shared_ptr<std::optional<SceneDescription>> next = std::make_shared<std::optional<SceneDescription>>();

    Session session(bool isSlow)
    {
        Session made = mirrorSession();
        made.source.isSlow = isSlow;
        made.reread = [next = next]() { return std::exchange(*next, std::nullopt); };
        return made;
    }
};

TEST(Controller, TakesOverAChangedSceneAndTracesIt)
{
    for (const bool isSlow : {false, true})
    {
        ChangingScene file;
        Controller controller(file.session(isSlow));
        controller.wait();
        unsigned told = 0;
        controller.changed = [&](unsigned changes) { told |= changes; };
        controller.reread();
        EXPECT_EQ(told, 0U);
        controller.setMaxDepth(3);
        auto changed = mirrorSession().scene;
        changed.spheres.clear();
        changed.camera.width = 20;
        *file.next = changed;
        controller.reread();
        // No moment at which a tree of the old scene is shown with the new one.
        EXPECT_EQ(controller.tree().nodes.empty(), isSlow);
        controller.wait();
        EXPECT_TRUE(told & changedScene);
        EXPECT_TRUE(controller.scene().spheres.empty());
        EXPECT_EQ(controller.picture().width, 20);
        EXPECT_EQ(controller.pixel(), (std::array{19, 25}));
        EXPECT_EQ(controller.maxDepth(), 3); // as the user chose
        EXPECT_EQ(controller.tree().nodes.at(0).radiance, controller.picture().at(19, 25));

        changed.lights.clear();
        *file.next = changed;
        controller.choosePixel(19, 25); // the same pixel, of another scene
        controller.wait();
        EXPECT_TRUE(controller.tree().shadows.empty());
    }
}

TEST(Controller, KeepsTheSceneIfItsFileIsBad)
{
    Session session = mirrorSession();
    session.reread = []() -> std::optional<SceneDescription> { throw std::runtime_error("s.toml:2: no"); };
    Controller controller(std::move(session));
    const auto nodes = controller.tree().nodes.size();
    controller.reread();
    EXPECT_EQ(controller.message(), "s.toml:2: no");
    EXPECT_EQ(controller.tree().nodes.size(), nodes);
}

TEST(SlowSource, AFailureAtTheStartIsSaidNotThrown)
{
    Session session = mirrorSession();
    session.source.isSlow = true;
    session.source.render = [](const auto&, const auto&) -> Image { throw std::runtime_error("no picture"); };
    session.source.inspect = [](const auto&, const auto&, const auto&) -> RayTree {
        throw std::runtime_error("no tree");
    };
    Controller controller(std::move(session));
    controller.wait();
    EXPECT_EQ(controller.message(), "no tree");
    EXPECT_EQ(controller.node(), nullptr);
}

TEST(Controller, SaysThatThereAreTooManyRaysAndLivesOn)
{
    Session session = mirrorSession();
    session.source = lessonSource(*findLesson(6), Precision::doubled);
    session.scene = loadScene(projectFile("lessons/06_fresnel/scenes/half_and_glass.toml"));
    session.scene.camera.width = session.scene.camera.height = 2;
    session.scene.spheres.clear();
    session.scene.planes.clear();
    const auto& all = session.scene.materials;
    const auto glass = std::find_if(all.begin(), all.end(), [](const auto& mat) { return mat.isDielectric(); });
    for (int i = 1; i <= 6; ++i)
        session.scene.planes.push_back(
            {.point = {0, 0, -double(i)}, .normal = {0, 0, 1}, .material = int(glass - all.begin())});
    session.scene.camera.eye = {0, 0, 0};
    session.scene.camera.target = {0, 0, -1};
    session.scene.trace.maxDepth = 64;
    session.probe = std::array{1, 1};
    Controller controller(std::move(session));
    EXPECT_TRUE(controller.message().starts_with("pixel 1,1 leads to more than 1,000,000 rays"))
        << controller.message();
    EXPECT_EQ(controller.node(), nullptr);
    EXPECT_EQ(controller.picture().width, 0);
    controller.setMaxDepth(4);
    controller.wait();
    EXPECT_EQ(controller.message(), "");
    EXPECT_NE(controller.node(), nullptr);
    EXPECT_EQ(controller.picture().width, 2);
    controller.setMaxDepth(64);
    controller.wait();
    EXPECT_TRUE(controller.message().starts_with("pixel 1,1 leads to more than 1,000,000 rays"))
        << controller.message();
    EXPECT_EQ(controller.picture().width, 2) << "the last picture stays";
}

TEST(NodeText, NamesEachFormulaAndFitsTheColumns)
{
    Controller controller(mirrorSession());
    controller.selectNode(1);
    for (const std::size_t columns : {30U, 60U, 200U})
    {
        std::string all;
        for (const auto& line : nodeText(controller, columns))
        {
            EXPECT_LE(characters(line.text) + characters(line.besides), columns) << line.text;
            all += line.text + "\n";
        }
        EXPECT_NE(all.find("Intersection"), std::string::npos);
        EXPECT_NE(all.find("Contribution"), std::string::npos);
    }
}

TEST(NodeText, HeadingsTellWhereARayComesFrom)
{
    RayTree tree;
    tree.pixel = {1, 2};
    RayTree::Node node;
    EXPECT_EQ(nodeHeading(tree, node), "[0] camera ray, depth 0");
    node.id = 4;
    node.parent = 2;
    node.depth = 3;
    node.kind = RayKind::reflected;
    EXPECT_EQ(nodeHeading(tree, node), "[4] reflected ray, depth 3, from [2]");
    node.parent = -1;
    node.orphan = true;
    EXPECT_EQ(nodeHeading(tree, node), "[4] reflected ray, depth 3, orphan");
}

TEST(Wrap, KeepsVectorsTogetherWhereItCan)
{
    const auto lines = wrap("(1, 2, 3) + (4, 5, 6) = (7, 8, 9)", 16);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0], "(1, 2, 3) +");
    EXPECT_EQ(lines[1], "   (4, 5, 6) =");
    EXPECT_EQ(lines[2], "   (7, 8, 9)");
}

TEST(Wrap, BreaksWhatHasNoSpacesAndCountsCharacters)
{
    for (const auto& line : wrap(std::string(100, 'x'), 20)) EXPECT_LE(characters(line), 20U);
    EXPECT_EQ(wrap("θ₁θ₂θ₃θ₄", 8).size(), 1U);
    EXPECT_EQ(shorten("θ₁θ₂θ₃θ₄", 4), "θ₁θ…");
    EXPECT_EQ(shorten("short", 5), "short");
}

} // namespace

} // namespace rt::viz
