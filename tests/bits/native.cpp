// The product's own numbers: its libraries, its TOML reader, its threads, its instruction sets. See README.md.
#include <algorithm>
#include <filesystem>

#include "common/files/scene_file.h"
#include "common/files/text_file.h"
#include "common/program/cli.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/registry.h"
#include "tests/bits/compared.h"

namespace
{

using namespace rt;

/// Names of folders tell where a clone lies: only those below lessons/ are told.
std::vector<bits::Shipped> shippedScenes()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(projectFile("lessons")))
        if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() == "scenes")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<bits::Shipped> scenes;
    for (const auto& file : files)
    {
        bits::Shipped shipped;
        shipped.file = file.parent_path().parent_path().filename().string() + "/" + file.filename().string();
        shipped.scene = loadScene(file.string());
        shipped.pixel = shipped.scene.pixel();
        const auto needed = required(shipped.scene);
        for (const auto* lesson : lessons())
            if (missing(needed, lesson->models).empty()) shipped.lessons.push_back(lesson->number);
        scenes.push_back(std::move(shipped));
    }
    return scenes;
}

bits::Traced trace(const bits::Shipped& shipped, int number, Precision precision)
{
    const auto* lesson = findLesson(number);
    bits::Traced traced{.picture = "", .tree = bits::bytesOf(lesson->inspect(shipped.scene, precision, shipped.pixel))};
    if (shipped.isPicturedBy(number)) traced.picture = grade::encode(lesson->render(shipped.small(), precision, {}));
    return traced;
}

int run(int argc, char** argv)
{
    CommandLine app(
        "Prints a line of hashes for each shipped scene, lesson and type: of its picture's and its ray tree's bits",
        "bits_native");
    std::string scenesFile, tree;
    std::vector<std::string> words;
    app.option("--scenes", scenesFile, "write the scenes as data that the program for other machines reads");
    app.option("--json", tree, "print the tree of these bytes as JSON");
    app.option("one", words, "FILE LESSON TYPE OUT: write the bytes behind one line to OUT.picture and OUT.tree")
        .count(4);
    return runMain(app, argc, argv, [&] {
        if (!tree.empty())
        {
            std::cout << toJson(grade::decode<RayTree>(readTextFile(tree)));
            return 0;
        }
        const auto scenes = shippedScenes();
        if (!scenesFile.empty())
        {
            writeTextFile(scenesFile, grade::encode(scenes));
            return 0;
        }
        return bits::run(scenes, words, [](const auto& shipped, int lesson, auto zero) {
            return trace(shipped, lesson, sizeof zero == sizeof(float) ? Precision::floating : Precision::doubled);
        });
    });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
