// The tracer of all lessons from its headers alone, for machines that have no TOML reader and no threads.
//
// usage: elsewhere SCENES [FILE LESSON TYPE OUT]   SCENES is what `bits_native --scenes SCENES` has written; see compared.h
#include <iterator>

#include "common/program/guarded_main.h"
#include "common/scene/pixel.h"
#include "common/tree/tree_recorder.h"
#include "lessons/list.h"
#include "lessons/traces.h"
#include "tests/bits/compared.h"

namespace
{

using namespace rt;

/// A picture takes the recorder that records nothing when it has no tree: each tracer is compiled once a type, not twice.
template <class Tracer, std::floating_point Real>
bits::Traced traceWith(const bits::Shipped& shipped, int lesson)
{
    const Scene<Real> scene(shipped.scene);
    RayTree tree;
    tree.lesson = lesson;
    tree.real = sizeof(Real) == sizeof(float) ? "float" : "double";
    tree.pixel = shipped.pixel;
    tree.maxDepth = shipped.scene.trace.maxDepth;
    Tracer tracer{scene, TreeRecorder<Real>(tree, scene)};
    tracer.trace(sampleRay(scene, shipped.pixel[0], shipped.pixel[1], 0));
    bits::Traced traced{.picture = "", .tree = bits::bytesOf(tree)};
    if (!shipped.isPicturedBy(lesson)) return traced;
    const Scene<Real> small(shipped.small());
    traced.picture = grade::encode(renderAlone<Tracer>(small, bits::pictureWidth, bits::pictureHeight));
    return traced;
}

template <std::floating_point Real>
bits::Traced trace(const bits::Shipped& shipped, int lesson, Real)
{
    using Recorder = TreeRecorder<Real>;
    switch (lesson)
    {
#define RAYTREE_CASE(number, NN)                                                                                       \
    case number:                                                                                                       \
        return traceWith<lesson##NN::Tracer<Real, Recorder>, Real>(shipped, lesson);
        RAYTREE_FOR_EACH_LESSON(RAYTREE_CASE)
#undef RAYTREE_CASE
    default:
        std::cerr << "there is no lesson " << lesson << '\n';
        std::exit(2);
    }
}

int run(int argc, char** argv)
{
    if (argc != 2 && argc != 6)
    {
        std::cerr << "usage: elsewhere SCENES [FILE LESSON TYPE OUT]\n";
        return 2;
    }
    std::ifstream in(argv[1], std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    if (!in)
    {
        std::cerr << argv[1] << ": cannot be read\n";
        return 2;
    }
    const auto scenes = grade::decode<std::vector<bits::Shipped>>(bytes);
    return bits::run(scenes, {argv + 2, argv + argc},
                     [](const auto& shipped, int lesson, auto zero) { return trace(shipped, lesson, zero); });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
