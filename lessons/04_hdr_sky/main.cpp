#include "common/files/picture_file.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/lesson_main.h"
#include "make_sky.h"

namespace
{

int run(int argc, char** argv)
{
    const rt::ExtraOption makeSky{"--make-sky", "FILE", "write a HDR sky (.hdr, .exr) for [sky] image, and stop",
                                  [](const std::string& file) { rt::writeImage(rt::makeSky(128), file); }};
    return rt::lessonMain(rt::lesson04::entry, argc, argv, {makeSky});
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
