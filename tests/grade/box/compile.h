// From a student's exercise.h to a static program, in a box that sees the compiler, the kit and that one file.
#pragma once

#include <string>
#include <vector>

#include "tests/grade/box/box.h"

namespace rt::grade
{

struct Compiled
{
    bool ok = false;
    std::string reason; ///< one sentence without a full stop, if not ok; foreign text may stand in it
    std::vector<std::string>
        errors; ///< the first 20, each of one or more lines, as "exercise.h:12:5: error: ...": foreign text
    double cpuSeconds = 0;
    std::string program;              ///< its path
    std::vector<std::string> remarks; ///< "glm::reflect is used"
};

/// What variables hold that nobody has set.
enum class Fill
{
    pattern, ///< bytes 0xFE: huge numbers, wild pointers
    zero
};

/// What of the core the student's code is compiled with.
enum class Kit
{
    ofLesson, ///< without the formulas that the lesson's exercises ask for
    whole     ///< all of it: for one's own code, which nobody grades
};

/// Compiles the text of a lesson's exercise.h, 0 to 8, with the kit of the build, and writes the program into `folder`, which
/// exists, as exerciseNN or, filled with zeros, exerciseNN_zero. Throws std::runtime_error if not the text is at fault.
Compiled compileSubmission(const Box& box, int lesson, const std::string& exerciseText, const std::string& folder,
                           Fill fill = Fill::pattern, Kit kit = Kit::ofLesson);

} // namespace rt::grade
