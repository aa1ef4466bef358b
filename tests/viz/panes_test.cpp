#include "viz/base/layout.h"
#include "viz/base/screen.h"
#include "viz/base/slider.h"
#include "viz/drawing/picture_view.h"

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

TEST(Layout, IsTheSameOnADenserScreen)
{
    for (const auto& [width, height] : {std::pair{1600, 900}, {1280, 720}, {900, 520}, {800, 500}})
        for (const int scale : {2, 3, 4})
        {
            const Layout usual = layoutFor(width, height);
            const Layout dense = layoutFor(scale * width, scale * height, {.scale = double(scale)});
            EXPECT_DOUBLE_EQ(dense.scale, scale * usual.scale);
            for (int pane = 0; pane < panesInAll; ++pane)
            {
                const Rect &a = usual.panes[pane], &b = dense.panes[pane];
                EXPECT_EQ(a.isEmpty(), b.isEmpty()) << pane;
                for (const auto& [small, large] :
                     {std::pair{a.x, b.x}, {a.y, b.y}, {a.width, b.width}, {a.height, b.height}})
                    EXPECT_NEAR(large, scale * small, 2 * scale) << pane; // each edge is rounded to a pixel
            }
        }
}

TEST(Layout, HalfTheScaleHasRoomForAllPanesInASmallWindow)
{
    EXPECT_TRUE(layoutFor(640, 400)[PaneId::code].isEmpty());
    EXPECT_FALSE(layoutFor(640, 400, {.scale = 0.5})[PaneId::code].isEmpty());
}

TEST(Screen, WindowsLieOnTheMonitorOfThePointerAndBesidePanels)
{
    const Area screen{0, 0, 3200, 1200}, left{0, 0, 1600, 1200}, right{1600, 100, 1600, 900};
    const auto expect = [](const Area& got, const Area& expected) {
        EXPECT_EQ((std::array{got.x, got.y, got.width, got.height}),
                  (std::array{expected.x, expected.y, expected.width, expected.height}));
    };
    expect(areaFor(screen, {}, 5, 5, {}), screen);
    expect(areaFor(screen, {left, right}, 5, 5, {}), left);
    expect(areaFor(screen, {left, right}, 1600, 500, {}), right);
    expect(areaFor(screen, {left, right}, 1600, 50, {}), left); // on none: the first
    expect(areaFor(screen, {left, right}, 5, 5, {0, 30, 3200, 1100}), {0, 30, 1600, 1100});
    expect(areaFor(screen, {left, right}, 2000, 500, {0, 30, 3200, 1100}), right);
    expect(areaFor(screen, {left, right}, 2000, 500, {0, 0, 1600, 1100}), right); // a panel cannot cover all of it
    expect(areaFor(screen, {{0, 0, 1920, 1080}, {0, 0, 1024, 768}}, 5, 5, {}), {0, 0, 1024, 768}); // a projector
    expect(areaFor({0, 0, 800, 600}, {{0, 0, 1600, 1200}}, 0, 0, {}), {0, 0, 800, 600});
}

RC_GTEST_PROP(Screen, NoPartOfAWindowIsBesideIt, ())
{
    const auto side = [](int least, int most) { return *rc::gen::inRange(least, most); };
    const Area area{side(-2000, 2000), side(-2000, 2000), side(100, 5000), side(100, 5000)};
    const Frame frame{side(0, 20), side(0, 20), side(0, 40), side(0, 20)};
    const int width = side(1, 9000), height = side(1, 9000);
    const auto place = placeWindow(width, height, area, frame);
    RC_ASSERT(place.x >= area.x && place.y >= area.y);
    RC_ASSERT(place.x + frame.left + place.width + frame.right <= area.x + area.width);
    RC_ASSERT(place.y + frame.top + place.height + frame.bottom <= area.y + area.height);
    RC_ASSERT(place.width == std::min(width, area.width - frame.left - frame.right));
    RC_ASSERT(place.height == std::min(height, area.height - frame.top - frame.bottom));
}

TEST(Screen, TheLargestWishForAScaleCounts)
{
    EXPECT_EQ(wishedScale(nullptr, nullptr, nullptr), 1);
    EXPECT_EQ(wishedScale("96", nullptr, nullptr), 1);
    EXPECT_EQ(wishedScale("192", nullptr, nullptr), 2);
    EXPECT_EQ(wishedScale("144", nullptr, nullptr), 1.5);
    EXPECT_EQ(wishedScale("72", nullptr, nullptr), 0.75);
    EXPECT_EQ(wishedScale("192", "1", "1.25"), 2);
    EXPECT_EQ(wishedScale("96", "2", nullptr), 2);
    EXPECT_EQ(wishedScale(nullptr, nullptr, "1.5"), 1.5);
    EXPECT_EQ(wishedScale("9600", nullptr, nullptr), 4);
    EXPECT_EQ(wishedScale("1", nullptr, nullptr), 0.5);
    for (const char* nonsense : {"", "0", "-96", "nan", "inf", "1e999", "two", "192 dpi"})
        EXPECT_EQ(wishedScale(nonsense, nonsense, nonsense), 1) << nonsense;
}

TEST(Screen, TheScaleOfADesktopLeavesRoomForAllPanes)
{
    EXPECT_EQ(fittingScale(2, {0, 0, 3840, 2160}, {}), 2);
    EXPECT_EQ(fittingScale(2, {0, 0, 1800, 1040}, {}), 2);
    EXPECT_EQ(fittingScale(2, {0, 0, 1350, 2000}, {}), 1.5);
    EXPECT_EQ(fittingScale(2, {0, 0, 1366, 20 + 780}, {0, 0, 20, 0}), 1.5);
    EXPECT_EQ(fittingScale(2, {0, 0, 640, 480}, {}), 1);
    EXPECT_EQ(fittingScale(0.75, {0, 0, 640, 480}, {}), 0.75);
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
