// What OpenImageIO does for us, in a module of its own (openimageio.cpp) that is loaded when it is first asked for. OpenImageIO
// needs some 240 packages and loads as many libraries, and most runs only write a .png: these neither install nor load it.
#pragma once

#include <exception>
#include <string>

namespace rt
{

struct Image;

/// Both throw std::runtime_error: `writeLinear` with a reason only, `read` with one sentence.
struct PictureModule
{
    void (*writeLinear)(const Image&, const std::string& path); ///< .exr or .hdr
    Image (*read)(const std::string& path);
};

/// Loads the module, once. Throws NeedsOpenImageIO, naming the picture that it is wanted for, if it was not built, and
/// std::runtime_error if it cannot be loaded.
const PictureModule& pictureModule(const std::string& picture);

/// Not a std::runtime_error: it is not the file that is wrong, and programs end with a code of their own.
class NeedsOpenImageIO : public std::exception
{
public:
    explicit NeedsOpenImageIO(const std::string& picture);
    const char* what() const noexcept override { return sentence.c_str(); }

private:
    std::string sentence;
};

} // namespace rt
