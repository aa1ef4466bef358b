// Pictures without OpenImageIO: compiled with image.cpp and a place of the module where there is none.
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "common/base/image.h"
#include "common/files/picture_file.h"
#include "common/files/picture_module.h"
#include "common/files/text_file.h"

namespace rt
{

namespace
{

namespace fs = std::filesystem;

class NoOpenImageIO : public testing::Test
{
public:
    fs::path folder = fs::temp_directory_path() / fmt::format("raytree_no_openimageio_{}", getpid());
    NoOpenImageIO() { fs::create_directory(folder); }
    ~NoOpenImageIO() override { fs::remove_all(folder); }

    std::string in(const char* name) const { return (folder / name).string(); }
};

template <class Work>
std::string refusal(const Work& work)
{
    try
    {
        work();
    }
    catch (const NeedsOpenImageIO& error)
    {
        return error.what();
    }
    return "no NeedsOpenImageIO";
}

TEST_F(NoOpenImageIO, WritesPngAndPpm)
{
    const Image image(3, 2);
    checkWritable(in("a.png"));
    writeImage(image, in("a.png"));
    EXPECT_TRUE(readTextFile(in("a.png")).starts_with("\x89PNG\r\n"));
    EXPECT_EQ(readTextFile(in("a.png")), pngBytes(image));
    writeImage(image, in("a.ppm"));
    EXPECT_EQ(readTextFile(in("a.ppm")), "P6\n3 2\n255\n" + std::string(18, '\0'));
}

TEST_F(NoOpenImageIO, RefusesTheRestAndLeavesNothing)
{
    for (const char* name : {"a.exr", "a.hdr"})
    {
        const auto path = in(name);
        EXPECT_TRUE(refusal([&] { checkWritable(path); }).starts_with(path + ": ")) << path;
        EXPECT_TRUE(refusal([&] { writeImage(Image(3, 2), path); }).starts_with(path + ": ")) << path;
    }
    writeImage(Image(3, 2), in("a.png"));
    EXPECT_TRUE(refusal([&] { readImage(in("a.png")); }).starts_with(in("a.png") + ": "));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

} // namespace

} // namespace rt
