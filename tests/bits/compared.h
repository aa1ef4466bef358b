// What is compared between machines: of each shipped scene, lesson and type the chosen pixel's ray tree, and the picture by the
// first and the last lesson that traces it (an emulated processor is slow).
// The core's headers and the standard library only, so that it builds for all of them.
#pragma once

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "common/scene/sky.h"
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

    bool isPicturedBy(int lesson) const { return lesson == lessons.front() || lesson == lessons.back(); }

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

/// The tree as bytes, without the lines of the source: these are no results, and a comment above them moves them.
inline std::string bytesOf(RayTree tree)
{
    tree.scene = tree.source = "";
    for (auto& node : tree.nodes) node.line = node.returnLine = 0;
    for (auto& shadow : tree.shadows) shadow.line = 0;
    for (auto& capped : tree.capped) capped.line = 0;
    return grade::encode(tree);
}

/// Picture (empty: not compared) and tree as bytes: every number of them.
struct Traced
{
    std::string picture, tree;
};

/// The functions that are not exact in IEEE 754, at random places, and the one mapping of skies that no scene has.
/// check_bits.py knows their order.
template <std::floating_point Real>
std::string functionValues()
{
    grade::Writer values;
    std::uint64_t state = 1;
    const auto random = [&] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return Real(double(state >> 11) * 0x1p-53);
    };
    for (int i = 0; i < 4000; ++i)
    {
        const Real x = random(), y = random(), side = 2 * y - 1;
        const auto [u, v] = SkyFormulas<Real>::angularMap(unit(Vec3<Real>(2 * x - 1, side, 2 * random() - 1)));
        for (const Real value : {portable::pow(i % 2 ? x : 1 - x * x / 10, 1000 * y), portable::atan2(x, side),
                                 portable::acos(side), portable::hypot(x, y), portable::sin(x), portable::tan(x), u, v})
            values.plain(double(value));
    }
    return std::move(values.bytes);
}

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
/// into OUT.picture and OUT.tree, or of "functions 0 TYPE OUT" into OUT.values. `trace` takes a Shipped, the lesson's number and
/// float() or double().
template <class Trace>
int run(const std::vector<Shipped>& scenes, const std::vector<std::string>& words, const Trace& trace)
{
    bool found = words.empty();
    const auto typeName = [](auto zero) { return sizeof zero == sizeof(float) ? "float" : "double"; };
    const auto one = [&](const Shipped& shipped, int lesson, auto zero) {
        const std::string type = typeName(zero);
        if (!words.empty() && (words[0] != shipped.file || words[1] != std::to_string(lesson) || words[2] != type))
            return;
        const Traced traced = trace(shipped, lesson, zero);
        found = true;
        if (!words.empty())
        {
            writeBytes(words[3] + ".picture", traced.picture);
            writeBytes(words[3] + ".tree", traced.tree);
            return;
        }
        std::printf("%s lesson %d %s:", shipped.file.c_str(), lesson, type.c_str());
        if (!traced.picture.empty()) std::printf(" picture %016" PRIx64, hash(traced.picture));
        std::printf(" tree %016" PRIx64 "\n", hash(traced.tree));
    };
    const auto functions = [&](auto zero) {
        const std::string type = typeName(zero);
        if (!words.empty() && (words[0] != "functions" || words[2] != type)) return;
        found = true;
        const std::string values = functionValues<decltype(zero)>();
        if (words.empty())
            std::printf("functions lesson 0 %s: values %016" PRIx64 "\n", type.c_str(), hash(values));
        else
            writeBytes(words[3] + ".values", values);
    };
    functions(float());
    functions(double());
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
