#include "tests/grade/box/temporary_folder.h"

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

/// Makes the system's folder for temporary files one of its own, for a while.
class Elsewhere
{
public:
    Elsewhere() : before(std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp")
    {
        ::setenv("TMPDIR", folder.path.c_str(), 1);
    }
    ~Elsewhere() { ::setenv("TMPDIR", before.c_str(), 1); }
    TemporaryFolder folder;

private:
    std::string before;
};

void makeOlder(const std::string& path)
{
    const timespec hourAgo{std::time(nullptr) - 3600, 0}, both[] = {hourAgo, hourAgo};
    EXPECT_EQ(::utimensat(AT_FDCWD, path.c_str(), both, AT_SYMLINK_NOFOLLOW), 0);
}

TEST(TemporaryFolder, VanishesWithAllInIt)
{
    std::string path;
    {
        const TemporaryFolder folder;
        path = folder.path;
        fs::create_directories(path + "/a/b");
        std::ofstream(path + "/a/b/c") << "text";
        struct stat status;
        ASSERT_EQ(::stat(path.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, 0711U);
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(TemporaryFolder, OfAKilledProcessIsRemovedLater)
{
    const Elsewhere elsewhere;
    const std::string here = elsewhere.folder.path;
    const std::string left = here + "/raytree-box-killed";
    fs::create_directories(left + "/out");
    makeOlder(left);
    EXPECT_EQ(removeAbandonedFolders(), 1);
    EXPECT_FALSE(fs::exists(left));
    EXPECT_EQ(removeAbandonedFolders(), 0);
}

TEST(TemporaryFolder, OfTheLivingAndOfOthersStay)
{
    const Elsewhere elsewhere;
    const std::string here = elsewhere.folder.path;
    const TemporaryFolder held;
    makeOlder(held.path);
    fs::create_directories(here + "/raytree-box-young");
    fs::create_directories(here + "/other-box-old");
    makeOlder(here + "/other-box-old");
    fs::create_directory_symlink(here + "/other-box-old", here + "/raytree-box-link");
    makeOlder(here + "/raytree-box-link");
    std::ofstream(here + "/raytree-box-file") << "text";
    makeOlder(here + "/raytree-box-file");
    EXPECT_EQ(removeAbandonedFolders(), 0);
    for (const std::string& path : {held.path, here + "/raytree-box-young", here + "/other-box-old",
                                    here + "/raytree-box-link", here + "/raytree-box-file"})
        EXPECT_TRUE(fs::exists(path)) << path;
}

TEST(TemporaryFolder, OfAnotherUserStays)
{
    if (::geteuid() != 0) return; // only root can make one, so this is looked at when root runs the tests
    const Elsewhere elsewhere;
    const std::string path = elsewhere.folder.path + "/raytree-box-another";
    fs::create_directories(path);
    ASSERT_EQ(::chown(path.c_str(), 60'600, 60'600), 0);
    makeOlder(path);
    EXPECT_EQ(removeAbandonedFolders(), 0);
    EXPECT_TRUE(fs::exists(path));
}

} // namespace

} // namespace rt::grade
