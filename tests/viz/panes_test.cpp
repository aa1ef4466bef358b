#include "viz/layout.h"
#include "viz/picture_view.h"
#include "viz/slider.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rt::viz
{

namespace
{

/// Each pixel belongs to one pane.
void expectCovered(const Layout& layout, int width, int height)
{
    for (int y = 0; y < height; y += 1 + height / 97)
        for (int x = 0; x < width; x += 1 + width / 97)
        {
            int covered = 0;
            for (const auto& pane : layout.panes) covered += pane.contains(x, y);
            ASSERT_EQ(covered, 1) << x << ',' << y << " of " << width << 'x' << height;
        }
}

TEST(Layout, PanesCoverTheWindowWithoutOverlapping)
{
    for (const auto& [width, height] :
         {std::pair{1600, 900}, {1280, 720}, {2560, 1440}, {640, 400}, {9, 9}, {300, 2000}})
        for (int whole = 0; whole <= panesInAll; ++whole)
            expectCovered(layoutFor(width, height, {PaneId(whole), whole % 2 == 0}), width, height);
}

TEST(Layout, ShowsAllPanesWhereThereIsRoom)
{
    for (const auto& [width, height] : {std::pair{1600, 900}, {1280, 720}, {2560, 1440}, {900, 520}})
    {
        const Layout layout = layoutFor(width, height);
        for (int pane = 0; pane < panesInAll; ++pane)
            EXPECT_EQ(layout[PaneId(pane)].isEmpty(), PaneId(pane) == PaneId::help) << pane;
        const auto area = [&](PaneId pane) { return layout[pane].width * layout[pane].height; };
        for (const auto other : {PaneId::image, PaneId::numbers, PaneId::code, PaneId::tree, PaneId::chart})
            EXPECT_GT(area(PaneId::scene), area(other));
    }
}

TEST(Layout, KeepsTheMostImportantPanesInASmallWindow)
{
    const Layout layout = layoutFor(640, 400);
    for (const auto pane : {PaneId::title, PaneId::image, PaneId::numbers, PaneId::scene, PaneId::strip})
        EXPECT_FALSE(layout[pane].isEmpty()) << int(pane);
    EXPECT_TRUE(layout[PaneId::code].isEmpty());
    EXPECT_FALSE(layoutFor(640, 400, {PaneId::code})[PaneId::code].isEmpty());
}

TEST(Layout, APaneMayTakeAllTheRoom)
{
    const Layout usual = layoutFor(1600, 900), enlarged = layoutFor(1600, 900, {PaneId::tree});
    EXPECT_EQ(enlarged[PaneId::tree].width, 1600);
    EXPECT_TRUE(enlarged[PaneId::scene].isEmpty());
    EXPECT_EQ(enlarged[PaneId::strip].height, usual[PaneId::strip].height);
    EXPECT_EQ(enlarged[PaneId::title].y, usual[PaneId::title].y);
}

TEST(Slider, FindsTheNearestStop)
{
    const Slider slider{.left = 100, .right = 300, .stops = 4};
    EXPECT_EQ(slider.stopAt(100), 0);
    EXPECT_EQ(slider.stopAt(124), 0);
    EXPECT_EQ(slider.stopAt(126), 1);
    EXPECT_EQ(slider.stopAt(300), 4);
    EXPECT_EQ(slider.stopAt(-50), 0);
    EXPECT_EQ(slider.stopAt(5000), 4);
    EXPECT_EQ(slider.at(160), 0.25);
    for (int stop = 0; stop <= 4; ++stop) EXPECT_EQ(slider.stopAt(slider.x(stop / 4.0)), stop);
}

TEST(Slider, WithoutLengthIsNoDivisionByZero)
{
    const Slider slider{.left = 100, .right = 100, .stops = 3};
    EXPECT_EQ(slider.at(100), 0);
    EXPECT_EQ(slider.at(200), 1);
}

TEST(Slider, HidesNothingAtItsLeftEndAndAllAtItsRight)
{
    EXPECT_EQ(throughputAt(0), 0);
    EXPECT_EQ(throughputAt(1), 1);
    EXPECT_EQ(positionOf(0), 0);
    EXPECT_EQ(positionOf(1), 1);
    double before = 0;
    for (double position = 0.05; position <= 1; position += 0.05)
    {
        const double throughput = throughputAt(position);
        EXPECT_GT(throughput, before);
        EXPECT_NEAR(positionOf(throughput), position, 1e-12);
        before = throughput;
    }
    EXPECT_EQ(throughputAt(7), 1);
    EXPECT_GE(positionOf(1e-300), 0);
}

TEST(Slider, ShowsThroughputAsPercent)
{
    EXPECT_EQ(percent(0), "0 %");
    EXPECT_EQ(percent(0.0001), "0.01 %");
    EXPECT_EQ(percent(0.0253), "2.5 %");
    EXPECT_EQ(percent(0.999), "100 %");
    EXPECT_EQ(percent(1), "100 %");
}

Image numbered(int width, int height)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = {x / 255.0, y / 255.0, 0};
    return image;
}

TEST(Srgb, EveryValueComesBack)
{
    for (int value = 0; value < 256; ++value) EXPECT_EQ(toSrgb8(fromSrgb8(static_cast<unsigned char>(value))), value);
}

TEST(PictureView, ShowsTheWholePictureAtFirst)
{
    PictureView view;
    view.fit(64, 48, 200, 100, 10);
    EXPECT_NEAR(view.zoom(), 80.0 / 48, 1e-12);
    const auto topLeft = view.toPane(0, 0), bottomRight = view.toPane(64, 48);
    EXPECT_GE(topLeft[0], 10);
    EXPECT_LE(topLeft[1], 90);
    EXPECT_LE(bottomRight[0], 190);
    EXPECT_GE(bottomRight[1], 9.5);
}

RC_GTEST_PROP(PictureView, FindsThePixelThatItDraws, ())
{
    const int width = *rc::gen::inRange(1, 500), height = *rc::gen::inRange(1, 500);
    PictureView view;
    view.fit(width, height, *rc::gen::inRange(50, 800), *rc::gen::inRange(50, 800), 5);
    view.zoomAt(*rc::gen::inRange(1, 40) / 8.0, *rc::gen::inRange(0, 50), *rc::gen::inRange(0, 50));
    view.pan(*rc::gen::inRange(-30, 30), *rc::gen::inRange(-30, 30));
    const int x = *rc::gen::inRange(0, width), y = *rc::gen::inRange(0, height);
    const auto at = view.toPane(x + 0.5, y + 0.5);
    RC_ASSERT(view.pixelAt(at[0], at[1]) == (std::array{x, y}));
}

TEST(PictureView, ZoomsAboutThePointer)
{
    PictureView view;
    view.fit(64, 48, 200, 100, 10);
    const auto before = view.toPicture(120, 30);
    view.zoomAt(3, 120, 30);
    const auto after = view.toPicture(120, 30);
    EXPECT_NEAR(before[0], after[0], 1e-9);
    EXPECT_NEAR(before[1], after[1], 1e-9);
    EXPECT_NEAR(view.zoom(), 5, 1e-9);
}

TEST(PictureView, KeepsTheUsersZoomWhenThePaneChangesItsSize)
{
    PictureView view;
    view.fit(64, 48, 200, 100, 10);
    view.resize(64, 48, 400, 200, 10);
    EXPECT_NEAR(view.zoom(), 180.0 / 48, 1e-12);
    view.zoomAt(2, 100, 100);
    const double chosen = view.zoom();
    view.resize(64, 48, 200, 100, 10);
    EXPECT_EQ(view.zoom(), chosen);
}

TEST(PictureView, MagnifiesWithoutMixingPixels)
{
    const ScreenPicture picture(numbered(4, 4));
    PictureView view;
    view.fit(4, 4, 43, 43, 1);
    const auto shown = view.sample(picture);
    ASSERT_EQ(shown.size(), 43U * 43U);
    for (int y = 0; y < 43; ++y)
        for (int x = 0; x < 43; ++x)
        {
            const auto& color = shown[std::size_t(y * 43 + x)];
            if (const auto pixel = view.pixelAt(x + 0.5, y + 0.5))
                EXPECT_EQ(color, picture.at((*pixel)[0], (*pixel)[1]));
            else
                EXPECT_EQ(color.a, 0);
        }
}

TEST(PictureView, HasNoPixelBesideThePicture)
{
    PictureView view;
    view.fit(1, 1, 100, 100, 10);
    EXPECT_EQ(view.pixelAt(50, 50), (std::array{0, 0}));
    EXPECT_FALSE(view.pixelAt(5, 50));
    EXPECT_FALSE(view.pixelAt(50, 95));
}

TEST(ScreenPicture, ReducedKeepsTheShapeAndTheMean)
{
    Image image(200, 100);
    for (auto& p : image.pixels) p = Vec3<double>(0.25);
    const auto small = ScreenPicture(image).reduced(50);
    EXPECT_EQ(small.width, 50);
    EXPECT_EQ(small.height, 25);
    EXPECT_EQ(small.at(49, 24).r, toSrgb8(0.25));
    const auto same = ScreenPicture(image).reduced(400);
    EXPECT_EQ(same.width, 200);
}

} // namespace

} // namespace rt::viz
