// What `learn` says.
#pragma once

#include <string>

#include "tests/learn/session.h"

namespace rt::grade
{

struct Look
{
    bool color = false;    ///< ANSI colours
    bool pictures = false; ///< half blocks in 24-bit colours
};

/// "[####......] 12 of 73 points, 4 of 27 exercises"
std::string progressLine(const Session& session);

/// Each exercise with its state.
std::string progressList(const Session& session, const Look& look);

/// The exercise: title, slide, where its TODO is.
std::string exerciseText(const Session& session, const Exercise& exercise, const Look& look);

/// What to do after this exercise, which is right.
std::string nextText(const Session& session, const Exercise& exercise);

/// What came of it: compiler errors, or the first case that fails. Writes the picture triple, if there is one, below out/learn/.
std::string resultText(const Session& session, const Exercise& exercise, const LessonRun& run, const Look& look);

} // namespace rt::grade
