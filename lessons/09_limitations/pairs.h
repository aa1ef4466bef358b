// The five pairs of pictures: lesson 08 on the left, the reference on the right, and nothing else different.
#pragma once

#include <span>

#include "common/program/lesson_entry.h"

namespace rt::lesson09
{

struct Limitation
{
    const char* name;   ///< of --limitation
    const char* scene;  ///< its own scene, relative to the project
    const char* left;   ///< what to see in lesson 08's picture
    const char* right;  ///< and in the reference
    const char* method; ///< what brings it, in the literature
    double lightRadius; ///< scene units, suits its own scene
    int spp;
    int bounces = 0;          ///< as in Beyond
    bool lobes = false;       ///< as in Beyond
    bool onlySamples = false; ///< the reference is lesson 08 with more samples per pixel
};

/// In the order of the lesson's page.
std::span<const Limitation> limitations();

/// The limitation of that name; null if there is none.
const Limitation* findLimitation(const std::string& name);

/// Lesson 08's picture: with the samples of the reference, so that edges look alike, or with one where samples are the point.
Image lessonPicture(const SceneDescription& scene, const Limitation& limitation, const RenderOptions& options);

/// The brute-force picture; the same bits for any number of threads.
Image referencePicture(const SceneDescription& scene, const Limitation& limitation, double lightRadius,
                       const RenderOptions& options);

/// Left, a white gap of four pixels, right. Both have the same height.
Image sideBySide(const Image& left, const Image& right);

/// The program. Returns its exit code.
int limitationsMain(int argc, char** argv);

} // namespace rt::lesson09
