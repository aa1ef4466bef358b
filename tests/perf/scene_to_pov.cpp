// A scene as POV-Ray 3.7 reads it, for comparisons of pictures and speed.
#include <iostream>

#include "bench_common.h"
#include "common/files/text_file.h"
#include "common/program/guarded_main.h"
#include "pov.h"

namespace
{

int run(int argc, char** argv)
{
    rt::CommandLine app("Writes a scene in the language of POV-Ray 3.7.", "scene_to_pov");
    rt::perf::SceneOptions options;
    std::string out;
    addSceneOptions(app, options);
    app.option("--out", out, "file to write; default: standard output").type("FILE.pov");
    app.footer("Its picture, linear, on one thread:\n"
               "  povray +Iscene.pov +Oscene.png +FN16 File_Gamma=1.0 +W1024 +H768 -A -D +WT1");
    return rt::runMain(app, argc, argv, [&] {
        const std::string text = rt::perf::povScene(chosenScene(options));
        if (out.empty())
            std::cout << text;
        else
            rt::writeTextFile(out, text);
        return int(rt::exitDone);
    });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
