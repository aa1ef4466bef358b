#include "viz/png.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace rt::viz
{

namespace
{

namespace fs = std::filesystem;

/// A folder of its own, gone when it is.
struct TemporaryFolder
{
    std::string path = (fs::temp_directory_path() / "raytree-XXXXXX").string();

    TemporaryFolder()
    {
        if (!mkdtemp(path.data()))
            throw std::runtime_error(path + ": the folder for a picture cannot be made, expected a place to write to");
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder()
    {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

} // namespace

std::string pngBytes(const Image& image)
{
    const TemporaryFolder folder;
    const std::string file = folder.path + "/picture.png";
    writeImage(image, file);
    return readTextFile(file);
}

} // namespace rt::viz
