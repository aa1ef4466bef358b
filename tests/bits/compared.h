// What is compared between machines: of each shipped scene, lesson and type the picture and the chosen pixel's ray tree.
// The core's headers and the standard library only, so that it builds for all of them.
#pragma once

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "tests/grade/wire/payload.h"

namespace rt::bits
{

inline constexpr int pictureWidth = 64, pictureHeight = 48;

/// A scene with what was decided where it could be read: which lessons trace it, and the pixel whose tree is compared.
struct Shipped
{
    std::string file;         ///< "08_phong/everything.toml"
    std::vector<int> lessons; ///< those that model all that the scene requires
    std::array<int, 2> pixel{};
    SceneDescription scene;

    /// The same scene with a small picture.
    SceneDescription small() const
    {
        SceneDescription smaller = scene;
        smaller.camera.width = pictureWidth;
        smaller.camera.height = pictureHeight;
        return smaller;
    }
};

template <class Wire>
void fields(Wire& wire, grade::Of<Wire, Shipped>& shipped)
{
    grade::all(wire, shipped.file, shipped.lessons, shipped.pixel, shipped.scene);
}

/// Picture and tree as bytes: every number of them.
struct Traced
{
    std::string picture, tree;
};

/// FNV-1a.
inline std::uint64_t hash(std::string_view bytes)
{
    std::uint64_t sum = 14695981039346656037ULL;
    for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    return sum;
}

inline void writeBytes(const std::string& path, const std::string& bytes)
{
    std::ofstream out(path, std::ios::binary);
    out << bytes << std::flush;
    if (!out)
    {
        std::cerr << path << ": cannot be written\n";
        std::exit(2);
    }
}

/// Without words: a line of hashes for each scene, lesson and type. With "FILE LESSON TYPE OUT": the bytes behind one line,
/// into OUT.picture and OUT.tree. `trace` takes a Shipped, the lesson's number and float() or double().
template <class Trace>
int run(const std::vector<Shipped>& scenes, const std::vector<std::string>& words, const Trace& trace)
{
    bool found = words.empty();
    const auto one = [&](const Shipped& shipped, int lesson, auto zero) {
        const std::string type = sizeof zero == sizeof(float) ? "float" : "double";
        if (!words.empty() && (words[0] != shipped.file || words[1] != std::to_string(lesson) || words[2] != type))
            return;
        const Traced traced = trace(shipped, lesson, zero);
        found = true;
        if (words.empty())
            std::printf("%s lesson %d %s: picture %016" PRIx64 " tree %016" PRIx64 "\n", shipped.file.c_str(), lesson,
                        type.c_str(), hash(traced.picture), hash(traced.tree));
        else
        {
            writeBytes(words[3] + ".picture", traced.picture);
            writeBytes(words[3] + ".tree", traced.tree);
        }
    };
    for (const auto& shipped : scenes)
        for (const int lesson : shipped.lessons)
        {
            one(shipped, lesson, float());
            one(shipped, lesson, double());
        }
    if (!found) std::cerr << words[0] << " is not traced by lesson " << words[1] << " in " << words[2] << "\n";
    return found ? 0 : 2;
}

} // namespace rt::bits
