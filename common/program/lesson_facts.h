// What is known of a lesson without its code.
#pragma once

#include "common/scene/features.h"

namespace rt
{

struct LessonFacts
{
    int number;
    const char* slug; ///< folder below lessons/
    const char* title;
    const char* slides; ///< headings of the lecture
    const char* source; ///< file, relative to the project, whose lines the trees name
    const char* scene;  ///< file, relative to the project: its first scene
    FeatureSet models;
};

} // namespace rt
