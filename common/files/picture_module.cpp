#include "common/files/picture_module.h"

#include <filesystem>
#include <stdexcept>

#include <dlfcn.h>
#include <fmt/format.h>

namespace rt
{

namespace
{

const PictureModule& load(const std::string& picture)
{
    const char* const file = RAYTREE_PICTURE_MODULE;
    if (!std::filesystem::exists(file)) throw NeedsOpenImageIO(picture);
    void* const module = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    const auto symbol = module ? dlsym(module, "raytreePictureModule") : nullptr;
    if (!symbol) throw std::runtime_error(fmt::format("{}: cannot be loaded: {}", file, dlerror()));
    return *static_cast<const PictureModule*>(symbol);
}

} // namespace

NeedsOpenImageIO::NeedsOpenImageIO(const std::string& picture)
    : sentence(fmt::format(
          "{}: to read a picture, or write .exr or .hdr, OpenImageIO is needed, and raytree was built without "
          "(RAYTREE_PICTURES in CMake); .png and .ppm can be written all the same",
          picture))
{
}

const PictureModule& pictureModule(const std::string& picture)
{
    static const PictureModule& loaded = load(picture); // what throws is tried again
    return loaded;
}

} // namespace rt
