#include "viz/state/refine.h"

#include <future>
#include <numeric>

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/state/controller.h"

namespace rt::viz
{

namespace
{

using namespace std::chrono_literals;

/// Sides that no stride divides.
SceneDescription oddScene(int lesson)
{
    SceneDescription scene = loadScene(projectFile(findLesson(lesson)->scene));
    scene.camera.width = 61;
    scene.camera.height = 45;
    return scene;
}

int stridesIn(int size, int every)
{
    return (size + every - 1) / every;
}

std::atomic<int> traced;

/// Counts its rays, and paints what is no background.
template <class Real>
struct Counting
{
    const Scene<Real>& scene;

    Vec3<Real> trace(const Ray<Real>&)
    {
        ++traced;
        return Vec3<Real>(1);
    }
};

TEST(Passes, TraceEachPixelOnceAndThoseOfTheirGridOnly)
{
    const Scene<double> scene{SceneDescription()};
    for (const int threads : {1, 2})
    {
        traced = 0;
        std::vector<int> strides;
        RenderOptions options{.threads = threads};
        options.coarsest = 64; // wider than a tile
        options.passed = [&](const Image& image, int every) {
            strides.push_back(every);
            EXPECT_EQ(traced, stridesIn(150, every) * stridesIn(70, every));
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    ASSERT_EQ(image.at(x, y).x, x % every == 0 && y % every == 0) << x << ' ' << y << ' ' << every;
        };
        const Image image = render<Counting<double>>(scene, 150, 70, options);
        EXPECT_EQ(strides, (std::vector{64, 32, 16, 8, 4, 2}));
        EXPECT_EQ(traced, 150 * 70);
        for (const auto& pixel : image.pixels) ASSERT_EQ(pixel.x, 1);
    }
}

TEST(Passes, ProgressGrowsToTheWholeByTheSharesOfThePixels)
{
    const Scene<double> scene{SceneDescription()};
    std::vector<double> shares;
    RenderOptions options{.threads = 1};
    options.coarsest = 4;
    options.progress = [&](double share) { shares.push_back(share); };
    render<Counting<double>>(scene, 64, 32, options);
    EXPECT_EQ(shares, (std::vector{1 / 32.0, 1 / 16.0, 5 / 32.0, 1 / 4.0, 5 / 8.0, 1.0}));
}

TEST(Passes, AnInterruptionLeavesNoFurtherPassAndTracesNoFurtherPixel)
{
    const Scene<double> scene{SceneDescription()};
    std::atomic<bool> stop = false;
    int passes = 0;
    RenderOptions options{.threads = 2, .stop = &stop};
    options.coarsest = 8;
    options.passed = [&](const Image&, int) {
        ++passes;
        stop = true;
    };
    traced = 0;
    render<Counting<double>>(scene, 64, 64, options);
    EXPECT_EQ(passes, 1);
    EXPECT_EQ(traced, 64);
}

TEST(Refine, EndsWithThePlainPictureBitForBit)
{
    for (const int lesson : {2, 6, 8})
        for (const int spp : {1, 3})
        {
            const auto scene = oddScene(lesson);
            const auto source = lessonSource(*findLesson(lesson), Precision::doubled);
            const Image plain = source.render(scene, {.spp = spp, .threads = 1});
            CoarsePictures pictures;
            pictures.goOn();
            EXPECT_EQ(paintInPasses(source, scene, {.spp = spp, .threads = 2}, pictures).pixels, plain.pixels)
                << lesson;
            const auto last = pictures.take(0ms);
            ASSERT_TRUE(last);
            ASSERT_EQ(last->every, 2);
            for (int y = 0; y < 45; y += 2)
                for (int x = 0; x < 61; x += 2) ASSERT_EQ(last->image.at(x, y), plain.at(x, y));
        }
}

TEST(Refine, BlocksLieAroundTheirPixelsAndFillThePicture)
{
    Image image(13, 6);
    for (const int y : {0, 4})
        for (const int x : {0, 4, 8, 12}) image.at(x, y) = Vec3<double>(1 + x + 100 * y);
    const Image blocks = inBlocks(image, 4);
    const std::vector xs{0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12}, ys{0, 0, 4, 4, 4, 4};
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 13; ++x)
            EXPECT_EQ(blocks.at(x, y).x, 1 + xs[std::size_t(x)] + 100 * ys[std::size_t(y)]) << x << ' ' << y;
    // Beyond the last pixel that has been traced there is no other to be near to.
    EXPECT_EQ(inBlocks(Image(16, 1), 16).pixels.size(), 16U);
}

TEST(Refine, BeginsWithFewPixelsWhateverTheSize)
{
    EXPECT_EQ(coarsestFor(1, 1), 8);
    EXPECT_EQ(coarsestFor(640, 480), 8);
    EXPECT_EQ(coarsestFor(1920, 1080), 16);
    EXPECT_EQ(coarsestFor(100000, 100000), 2048);
}

TEST(CoarsePictures, HandOverTheNewestOnce)
{
    CoarsePictures pictures;
    EXPECT_FALSE(pictures.take(1ms));
    pictures.put({Image(1, 1), 8});
    pictures.put({Image(1, 1), 4});
    const auto newest = pictures.take(1h);
    ASSERT_TRUE(newest);
    EXPECT_EQ(newest->every, 4);
    EXPECT_FALSE(pictures.take(0ms));
    const auto later = std::async(std::launch::async, [&] { pictures.put({Image(1, 1), 2}); });
    EXPECT_TRUE(pictures.take(1h));
}

TEST(CoarsePictures, APainterThatWaitsToGoOnIsStopped)
{
    CoarsePictures pictures;
    std::atomic<bool> stop = false;
    auto waiting = std::async(std::launch::async, [&] { pictures.awaitGoOn(&stop); });
    EXPECT_EQ(waiting.wait_for(20ms), std::future_status::timeout) << "nobody said that it may go on";
    stop = true;
    EXPECT_EQ(waiting.wait_for(600s), std::future_status::ready);
    pictures.goOn(); // so that a failure ends, too
}

/// Lesson 2, small; what is painted with a cap of n is n all over, after as many passes as `paint` makes of it.
Session paintedSession(std::function<void(const Image&, const RenderOptions&)> paint)
{
    Session session;
    session.scene = oddScene(2);
    session.source = lessonSource(*findLesson(2), Precision::doubled);
    session.source.render = [paint](const SceneDescription& scene, const RenderOptions& options) {
        Image image(scene.camera.width, scene.camera.height);
        for (auto& pixel : image.pixels) pixel = Vec3<double>(scene.trace.maxDepth);
        if (options.passed) paint(image, options); // not at the start
        return image;
    };
    session.probe = std::array{30, 25};
    session.patience = 1h;
    return session;
}

void waitForStop(const RenderOptions& options)
{
    while (!*options.stop) std::this_thread::sleep_for(1ms);
}

TEST(Refining, TheFirstCoarsePictureIsShownBeforeAllElse)
{
    Controller controller(paintedSession([](const Image& image, const RenderOptions& options) {
        options.passed(image, 8);
        waitForStop(options);
    }));
    std::vector<unsigned> told;
    controller.changed = [&](unsigned changes) { told.push_back(changes); };
    EXPECT_FALSE(controller.isRefining());
    controller.setMaxDepth(1);
    EXPECT_EQ(told, (std::vector<unsigned>{changedPass, changedTree | changedNode | changedStep}));
    EXPECT_EQ(controller.picture().at(3, 3).x, 1);
    EXPECT_EQ(controller.tree().maxDepth, 1);
    EXPECT_TRUE(controller.isRefining());
}

TEST(Refining, LeavesTheProcessorToTheWindowUntilTheChangeIsDrawn)
{
    const auto passed = std::make_shared<std::atomic<int>>(0);
    Controller controller(paintedSession([=](const Image& image, const RenderOptions& options) {
        for (const int every : {8, 4, 2})
        {
            options.passed(image, every);
            ++*passed;
        }
    }));
    int drawn = 0;
    controller.changed = [&](unsigned changes) {
        if (!(changes & (changedPass | changedTree))) return;
        std::this_thread::sleep_for(20ms);
        EXPECT_EQ(*passed, 0);
        ++drawn;
    };
    controller.setMaxDepth(1);
    EXPECT_EQ(drawn, 2);
    controller.changed = nullptr;
    controller.wait();
    EXPECT_EQ(*passed, 3);
}

TEST(Refining, ASlowFirstPictureHoldsNobodyUp)
{
    Session session = paintedSession([](const Image&, const RenderOptions& options) { waitForStop(options); });
    session.patience = 1ms;
    Controller controller(std::move(session));
    const double before = controller.picture().at(3, 3).x;
    controller.setMaxDepth(1);
    EXPECT_EQ(controller.tree().maxDepth, 1);
    EXPECT_EQ(controller.picture().at(3, 3).x, before);
    EXPECT_TRUE(controller.poll());
}

TEST(Refining, NothingOfAnEarlierDepthIsShownAfterAChange)
{
    Controller controller(paintedSession([](const Image& image, const RenderOptions& options) {
        options.passed(image, 8);
        waitForStop(options);
        options.passed(image, 4); // too late
    }));
    int shown = 0;
    controller.changed = [&](unsigned changes) {
        if (!(changes & (changedPicture | changedPass))) return;
        ++shown;
        for (const auto& pixel : controller.picture().pixels) ASSERT_EQ(pixel.x, controller.maxDepth());
    };
    for (int depth = 0; depth < 7; ++depth)
    {
        controller.setMaxDepth(depth);
        for (int i = 0; i < 5; ++i)
        {
            std::this_thread::sleep_for(1ms);
            controller.poll();
        }
    }
    EXPECT_EQ(shown, 7);
}

TEST(Refining, AChangeDoesNotWaitForWhatIsPaintedUntilThen)
{
    auto release = std::make_shared<std::promise<void>>();
    const auto released = release->get_future().share();
    const auto late = std::make_shared<std::atomic<int>>(0);
    Session session = paintedSession([=](const Image& image, const RenderOptions& options) {
        if (image.at(0, 0).x == 1 && released.wait_for(1min) != std::future_status::ready) ++*late;
        options.passed(image, 8);
    });
    session.patience = 1ms;
    Controller controller(std::move(session));
    controller.setMaxDepth(1);
    controller.setMaxDepth(2);
    controller.setMaxDepth(3);
    release->set_value(); // would come too late if a change waited
    controller.wait();
    EXPECT_EQ(*late, 0);
    EXPECT_EQ(controller.picture().at(0, 0).x, 3);
}

TEST(Refining, ASliderDraggedThroughTenValuesEndsAtThePictureOfTheLast)
{
    Session session;
    session.scene = oddScene(7);
    session.source = lessonSource(*findLesson(7), Precision::doubled);
    const auto plain = [session](int depth) {
        SceneDescription scene = session.scene;
        scene.trace.maxDepth = depth;
        return session.source.render(scene, {});
    };
    Controller controller(session);
    for (int round = 0; round < 20; ++round)
    {
        for (int depth = 0; depth < 10; ++depth)
        {
            controller.setMaxDepth(depth);
            if (depth % 3 == round % 3) controller.poll();
        }
        controller.wait();
        ASSERT_FALSE(controller.isRefining());
        ASSERT_EQ(controller.picture().pixels, plain(9).pixels) << round;
    }
    EXPECT_NE(plain(8).pixels, plain(9).pixels); // or the test would not see an older one
}

TEST(Refining, AFailureLeavesTheLastPictureAndOneSentence)
{
    Controller controller(paintedSession([](const Image& image, const RenderOptions& options) {
        options.passed(image, 8);
        throw std::runtime_error("no more paint");
    }));
    controller.setMaxDepth(1);
    controller.wait();
    EXPECT_EQ(controller.message(), "no more paint");
    EXPECT_FALSE(controller.isRefining());
}

TEST(Refining, LeavingInTheMiddleEndsThePainting)
{
    const auto ended = std::make_shared<std::atomic<int>>(0);
    {
        Controller controller(paintedSession([=](const Image& image, const RenderOptions& options) {
            options.passed(image, 8);
            waitForStop(options);
            ++*ended;
        }));
        controller.setMaxDepth(1);
        controller.setMaxDepth(2);
    }
    EXPECT_EQ(*ended, 2);
}

/// A window that would wait for it showed nothing for a minute.
TEST(Refining, TheFirstPictureOfAWindowIsPaintedWhenTheTreeIsThere)
{
    const auto released = std::make_shared<std::atomic<bool>>(false);
    Session session = paintedSession([=](const Image& image, const RenderOptions& options) {
        options.passed(image, 8);
        options.progress(0.25);
        while (!*released && !*options.stop) std::this_thread::sleep_for(1ms);
        EXPECT_TRUE(*released);
    });
    session.paintsLater = true;
    Controller controller(std::move(session));
    EXPECT_FALSE(controller.tree().nodes.empty());
    EXPECT_TRUE(controller.isRefining());
    EXPECT_EQ(controller.picture().at(3, 3).x, controller.maxDepth()) << "the coarse one";
    EXPECT_EQ(controller.painted(), 0);
    std::vector<unsigned> told;
    controller.changed = [&](unsigned changes) { told.push_back(changes); };
    while (told.empty()) controller.poll();
    EXPECT_EQ(told, std::vector<unsigned>{changedShare});
    EXPECT_EQ(controller.painted(), 0.25);
    *released = true;
    controller.wait();
    EXPECT_FALSE(controller.isRefining());
    EXPECT_EQ(controller.painted(), 1);
    EXPECT_EQ(told.back(), unsigned{changedPicture | changedMessage});
}

TEST(Refining, AFirstPictureIsLeftInTheMiddle)
{
    const auto ended = std::make_shared<std::atomic<bool>>(false);
    {
        Session session = paintedSession([=](const Image&, const RenderOptions& options) {
            waitForStop(options);
            *ended = true;
        });
        session.paintsLater = true;
        session.patience = 1ms;
        const Controller controller(std::move(session));
        EXPECT_EQ(controller.picture().width, 0);
        EXPECT_FALSE(controller.tree().nodes.empty());
        EXPECT_FALSE(*ended);
    }
}

TEST(Refining, AFirstPictureThatFailsIsSaid)
{
    Session session = paintedSession([](const Image&, const RenderOptions&) { throw std::runtime_error("no paint"); });
    session.paintsLater = true;
    session.patience = 1ms;
    Controller controller(std::move(session));
    controller.wait();
    EXPECT_EQ(controller.message(), "no paint");
    EXPECT_FALSE(controller.tree().nodes.empty());
}

} // namespace

} // namespace rt::viz
