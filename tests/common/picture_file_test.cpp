// What files of pictures say about their pixels beside the pixels: place, orientation, names, exposure.
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/base/image.h"
#include "common/files/picture_file.h"

namespace rt
{

namespace
{

namespace fs = std::filesystem;

class PictureFile : public testing::Test
{
protected:
    fs::path folder = fs::temp_directory_path() / fmt::format("raytree_picture_file_{}", getpid());
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string file(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return (folder / name).string();
    }

    std::string refusal(const std::string& path) const
    {
        try
        {
            readImage(path);
            return "no error";
        }
        catch (const std::runtime_error& error)
        {
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), message.npos) << message;
            EXPECT_TRUE(message.starts_with(path + ": ")) << message;
            return message.substr(std::min(message.size(), path.size() + 2));
        }
    }
};

/// A Radiance file of 3x2 or, turned, 2x3 pixels, stored one after the other: red is 1, 2, 3 and so on.
std::string radiance(const std::string& resolution, const std::string& header = "")
{
    std::string bytes = "#?RADIANCE\n" + header + "FORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n";
    for (int value = 1; value <= 6; ++value) bytes += {char(value * 16), 0, 0, char(128 + 4)};
    return bytes;
}

std::vector<double> reds(const Image& image)
{
    std::vector<double> values;
    for (const auto& pixel : image.pixels) values.push_back(pixel.x);
    return values;
}

TEST_F(PictureFile, RadianceHasEightOrientations)
{
    struct Oriented
    {
        const char* resolution;
        int width;
        std::vector<double> reds; ///< row by row from the top left
    };
    for (const auto& [resolution, width, expected] : {
             Oriented{"-Y 2 +X 3", 3, {1, 2, 3, 4, 5, 6}},
             Oriented{"-Y 2 -X 3", 3, {3, 2, 1, 6, 5, 4}},
             Oriented{"+Y 2 -X 3", 3, {6, 5, 4, 3, 2, 1}},
             Oriented{"+Y 2 +X 3", 3, {4, 5, 6, 1, 2, 3}},
             Oriented{"+X 2 -Y 3", 2, {1, 4, 2, 5, 3, 6}},
             Oriented{"-X 2 -Y 3", 2, {4, 1, 5, 2, 6, 3}},
             Oriented{"-X 2 +Y 3", 2, {6, 3, 5, 2, 4, 1}},
             Oriented{"+X 2 +Y 3", 2, {3, 6, 2, 5, 1, 4}},
         })
    {
        const Image image = readImage(file("a.hdr", radiance(resolution)));
        EXPECT_EQ(image.width, width) << resolution;
        EXPECT_EQ(reds(image), expected) << resolution;
    }
}

TEST_F(PictureFile, RadianceIsDividedByItsExposures)
{
    EXPECT_EQ(readImage(file("a.hdr", radiance("-Y 2 +X 3", "EXPOSURE=2.0\n"))).at(2, 1).x, 3);
    EXPECT_EQ(readImage(file("a.hdr", radiance("-Y 2 +X 3", "EXPOSURE= 2\nEXPOSURE=0.5\n"))).at(2, 1).x, 6);
    EXPECT_EQ(readImage(file("a.hdr", radiance("-Y 2 +X 3", "COLORCORR=4 1 1\n"))).at(2, 1).x, 1.5);
    EXPECT_EQ(refusal(file("a.hdr", radiance("-Y 2 +X 3", "EXPOSURE=0\n"))),
              "'EXPOSURE=0' in its header, expected numbers greater than 0");
}

/// An OpenEXR file without compression. `channels` in the order of the alphabet, each with a value all over; windows are
/// x and y of the first and of the last pixel.
std::string exr(const std::vector<std::pair<std::string, float>>& channels, const std::array<int, 4>& data,
                const std::array<int, 4>& display)
{
    std::string bytes;
    const auto put = [&](auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    const auto attribute = [&](const char* name, const char* type, int size) {
        bytes.append(name).append(1, '\0').append(type).append(1, '\0');
        put(size);
    };
    put(20000630);
    put(2);
    int size = 1;
    for (const auto& channel : channels) size += int(channel.first.size()) + 17;
    attribute("channels", "chlist", size);
    for (const auto& channel : channels)
    {
        bytes.append(channel.first).append(1, '\0');
        for (const int word : {2, 0, 1, 1}) put(word); // float
    }
    bytes += '\0';
    attribute("compression", "compression", 1);
    bytes += '\0';
    for (const auto& [name, window] : {std::pair("dataWindow", data), std::pair("displayWindow", display)})
    {
        attribute(name, "box2i", 16);
        for (const int word : window) put(word);
    }
    attribute("lineOrder", "lineOrder", 1);
    bytes += '\0';
    attribute("pixelAspectRatio", "float", 4);
    put(1.0f);
    attribute("screenWindowCenter", "v2f", 8);
    put(0.0f);
    put(0.0f);
    attribute("screenWindowWidth", "float", 4);
    put(1.0f);
    bytes += '\0';
    const int width = data[2] - data[0] + 1, rows = data[3] - data[1] + 1;
    const int row = int(channels.size()) * width * 4;
    const auto first = bytes.size() + std::size_t(rows) * 8;
    for (int y = 0; y < rows; ++y) put(std::uint64_t(first + std::size_t(y) * std::size_t(row + 8)));
    for (int y = 0; y < rows; ++y)
    {
        put(data[1] + y);
        put(row);
        for (const auto& channel : channels)
            for (int x = 0; x < width; ++x) put(channel.second);
    }
    return bytes;
}

TEST_F(PictureFile, ChannelsGoByTheirNames)
{
    const std::array<int, 4> window{0, 0, 1, 0};
    const auto first = [&](const std::vector<std::pair<std::string, float>>& channels) {
        return readImage(file("a.exr", exr(channels, window, window))).at(0, 0);
    };
    using C = Vec3<double>;
    EXPECT_EQ(first({{"B", 3}, {"G", 2}, {"R", 1}}), C(1, 2, 3));
    EXPECT_EQ(first({{"A", 9}, {"B", 3}, {"G", 2}, {"R", 1}, {"Z", 7}}), C(1, 2, 3));
    EXPECT_EQ(
        first({{"Depth.Z", 7}, {"ViewLayer.Combined.B", 3}, {"ViewLayer.Combined.G", 2}, {"ViewLayer.Combined.R", 1}}),
        C(1, 2, 3));
    EXPECT_EQ(first({{"B", 3}, {"G", 2}, {"R", 1}, {"beauty.B", 6}, {"beauty.G", 5}, {"beauty.R", 4}}), C(1, 2, 3));
    EXPECT_EQ(first({{"A", 9}, {"Y", 4}}), C(4, 4, 4));
    EXPECT_EQ(refusal(file("a.exr", exr({{"Z", 7}, {"id", 1}}, window, window))),
              "there are no colours among its channels Z, id, expected R, G and B");
    EXPECT_EQ(refusal(file("a.exr", exr({{"a.B", 1}, {"a.G", 1}, {"a.R", 1}, {"b.B", 1}, {"b.G", 1}, {"b.R", 1}},
                                        window, window))),
              "several layers have colours, a, b, expected one, or channels R, G and B outside of layers");
}

TEST_F(PictureFile, PixelsLieWhereTheDataWindowSays)
{
    const auto image = readImage(file("a.exr", exr({{"B", 1}, {"G", 1}, {"R", 1}}, {1, 0, 2, 0}, {0, 0, 3, 1})));
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(reds(image), (std::vector<double>{0, 1, 1, 0, 0, 0, 0, 0}));
    const auto overscan = readImage(file("a.exr", exr({{"B", 1}, {"G", 1}, {"R", 1}}, {-3, -2, 3, 0}, {-1, 0, 1, 1})));
    EXPECT_EQ(overscan.width, 3);
    EXPECT_EQ(reds(overscan), (std::vector<double>{1, 1, 1, 0, 0, 0}));
}

} // namespace

} // namespace rt
