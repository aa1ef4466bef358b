// The one include of an exercise: what a lesson has, and a recorder that may be off.
#pragma once

#include "common/scene/lesson.h"
#include "common/tree/tree_recorder.h"
