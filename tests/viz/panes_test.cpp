#include "viz/layout.h"
#include "viz/picture_view.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rt::viz
{

namespace
{

TEST(Layout, PanesCoverTheWindowWithoutOverlapping)
{
    for (const auto& [width, height] :
         {std::pair{1600, 900}, {1280, 720}, {2560, 1440}, {640, 400}, {9, 9}, {300, 2000}})
    {
        const Layout layout = layoutFor(width, height);
        const Rect panes[] = {layout.title, layout.image, layout.numbers, layout.scene, layout.strip};
        for (int y = 0; y < height; y += 1 + height / 97)
            for (int x = 0; x < width; x += 1 + width / 97)
            {
                int covered = 0;
                for (const auto& pane : panes) covered += pane.contains(x, y);
                ASSERT_EQ(covered, 1) << x << ',' << y << " of " << width << 'x' << height;
            }
        for (const auto& pane : panes) EXPECT_TRUE(pane.width > 0 && pane.height > 0);
    }
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
