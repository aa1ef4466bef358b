#include "common/base/image.h"
#include "common/files/picture_file.h"
#include "common/files/text_file.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

namespace rt
{

namespace
{

namespace fs = std::filesystem;

class ImageFile : public testing::Test
{
protected:
    fs::path folder = fs::temp_directory_path() / ("raytree_image_test_" + std::to_string(getpid()));
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::size_t files() const { return std::size_t(std::distance(fs::directory_iterator(folder), {})); }
};

Image gradient()
{
    Image image(5, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) image.at(x, y) = {x / 4.0, y / 2.0, 0.25};
    image.at(4, 2) = {100, 0.01, 2};
    return image;
}

TEST_F(ImageFile, ExrKeepsLinearValuesAboveOne)
{
    const auto path = (folder / "a.exr").string();
    writeImage(gradient(), path);
    EXPECT_TRUE(compare(readImage(path), gradient(), 0, 1e-7).equal());
}

TEST_F(ImageFile, HdrKeepsLinearValuesToOnePercent)
{
    const auto path = (folder / "a.hdr").string();
    writeImage(gradient(), path);
    const Image read = readImage(path);
    EXPECT_TRUE(compare(read, gradient(), 0.5, 0).equal()) << "shared exponent: 1/256 of the largest channel";
    EXPECT_NEAR(read.at(4, 2).x, 100, 1);
}

TEST_F(ImageFile, OfLinearValuesShowsNoInfinityWhereThereIsNone)
{
    Image image = gradient();
    const auto reasonOf = [&](const char* name) -> std::string {
        try
        {
            writeImage(image, (folder / name).string());
            return "";
        }
        catch (const std::runtime_error& error)
        {
            return std::string(error.what()).substr(folder.string().size() + 1);
        }
    };
    image.at(3, 1).y = 1e38;
    EXPECT_EQ(reasonOf("a.exr"), "");
    EXPECT_EQ(reasonOf("a.hdr"), "");
    EXPECT_NEAR(readImage((folder / "a.hdr").string()).at(3, 1).y, 1e38, 1e36);
    image.at(3, 1).y = 2e38;
    EXPECT_EQ(reasonOf("a.exr"), "");
    EXPECT_EQ(
        reasonOf("b.hdr"),
        "b.hdr: cannot be written: pixel (3, 1) has a channel of 2e+38, expected at most 1.69e+38 in such a file");
    image.at(3, 1).y = 5e59;
    EXPECT_EQ(reasonOf("b.exr"),
              "b.exr: cannot be written: pixel (3, 1) has a channel of 5e+59, expected at most 3.4e+38 in such a file");
    EXPECT_EQ(files(), 2u);
}

TEST_F(ImageFile, PngIsSrgbAndClamped)
{
    const auto path = (folder / "a.PNG").string();
    writeImage(gradient(), path);
    const Image read = readImage(path);
    EXPECT_NEAR(read.at(2, 0).x, 0.5, 0.005);
    EXPECT_EQ(read.at(4, 2).x, 1);
    EXPECT_EQ(read.at(4, 2).z, 1);
}

TEST_F(ImageFile, PpmHasThePixelsOfPng)
{
    const auto png = (folder / "a.png").string(), ppm = (folder / "a.PPM").string();
    writeImage(gradient(), png);
    writeImage(gradient(), ppm);
    EXPECT_EQ(readImage(ppm).pixels, readImage(png).pixels);
    EXPECT_THROW(writeImage(Image(), ppm), std::runtime_error) << "no pixels";
}

TEST_F(ImageFile, PngInMemoryIsThatOnDisk)
{
    const auto path = (folder / "a.png").string();
    writeTextFile(path, pngBytes(gradient()));
    const Image read = readImage(path);
    writeImage(gradient(), path);
    EXPECT_EQ(read.pixels, readImage(path).pixels);
    EXPECT_TRUE(pngBytes(gradient()) == readTextFile(path)) << "the same bytes";
    EXPECT_EQ(files(), 1U) << "nothing may be left beside it";
    EXPECT_THROW(pngBytes(Image()), std::runtime_error) << "no pixels";
}

TEST(Srgb, HasTheValuesOfTheStandard)
{
    EXPECT_EQ(toSrgb8(0), 0);
    EXPECT_EQ(toSrgb8(0.0031308), 10);
    EXPECT_EQ(toSrgb8(0.2140411), 127);
    EXPECT_EQ(toSrgb8(0.2158605), 128);
    EXPECT_EQ(toSrgb8(0.5), 188);
    EXPECT_EQ(toSrgb8(1), 255);
    EXPECT_EQ(toSrgb8(1e30), 255);
    EXPECT_EQ(toSrgb8(-1), 0);
    EXPECT_EQ(toSrgb8(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST_F(ImageFile, IsWrittenWholeOrNotAtAll)
{
    std::ofstream(folder / "a.png") << "old";
    EXPECT_THROW(writeImage(gradient(), (folder / "missing" / "a.png").string()), std::runtime_error);
    EXPECT_THROW(writeImage(gradient(), (folder / "a.jpeg").string()), std::runtime_error);
    EXPECT_THROW(writeImage(Image(), (folder / "a.png").string()), std::runtime_error) << "no pixels";
    EXPECT_EQ(files(), 1U) << "nothing but the old file may be left";
    EXPECT_EQ(readTextFile((folder / "a.png").string()), "old");
    writeImage(gradient(), (folder / "a.png").string());
    EXPECT_EQ(files(), 1U);
    EXPECT_EQ(readImage((folder / "a.png").string()).width, 5);
}

TEST_F(ImageFile, ThatIsNoPictureIsRefusedByName)
{
    std::ofstream(folder / "a.png") << "not a picture";
    for (const char* name : {"a.png", "none.exr"}) try
        {
            readImage((folder / name).string());
            ADD_FAILURE() << name << " was read";
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
}

TEST(Compare, CountsWhatIsOutsideTolerance)
{
    Image other = gradient();
    EXPECT_TRUE(compare(other, gradient(), 0, 0).equal());
    other.at(3, 1).y += 0.01;
    const auto result = compare(other, gradient(), 0.001, 0);
    EXPECT_EQ(result.wrong, 1);
    EXPECT_EQ(result.x, 3);
    EXPECT_EQ(result.y, 1);
    EXPECT_NEAR(result.worst, 0.01, 1e-12);
    EXPECT_TRUE(compare(other, gradient(), 0.02, 0).equal());
}

TEST(Compare, RefusesNanAndAnotherSize)
{
    Image nan = gradient();
    for (auto& pixel : nan.pixels) pixel = Vec3<double>(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(compare(nan, nan, 1, 1).equal());
    EXPECT_FALSE(compare(Image(4, 3), gradient(), 1e9, 0).equal());
}

TEST_F(ImageFile, OfTextMayBeEmptyButNoFolder)
{
    const auto file = (folder / "empty.json").string();
    writeTextFile(file, "");
    EXPECT_EQ(readTextFile(file), "");
    EXPECT_THROW(readTextFile(folder.string()), std::runtime_error);
    EXPECT_THROW(readTextFile(file + ".none"), std::runtime_error);
}

} // namespace

} // namespace rt
