// What the command line's words for tracers mean.
#pragma once

#include "viz/controller.h"

namespace rt::viz
{

/// For --compare: "exercise" (the lesson's own), "exact", "schlick", "float", "double", "long-double", "depth=N",
/// "lesson=N", a .json file, or a program. Sets session.other; session.source must trace `lesson` in
/// `precision`. Throws std::runtime_error with one sentence.
void compareWith(Session& session, const std::string& what, const LessonEntry& lesson, Precision precision);

/// Why the viewer has no tracer of a lesson; a study is told from a number that does not exist. One sentence.
std::string whyNoLesson(int number);

} // namespace rt::viz
