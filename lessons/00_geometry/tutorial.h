// What the program of lesson 00 says: the tutorial's answers with their numbers, and the figures.
#pragma once

#include <string>
#include <vector>

#include "lessons/00_geometry/functions.h"

namespace rt::lesson00
{

/// The lines of exercises 1 and 3; first those of the tutorial.
struct Lines
{
    V2 P2{-3, 0}, Q2{2, 2};
    V3 P3{-4, 1, 1}, Q3{2, 2, 5};
};

/// The answers, each with a check. `steps` shows the way to them too: the lesson's program does, the exercise's does not.
std::string tutorialText(const Functions& functions, const Lines& lines, bool steps);

struct Figure
{
    std::string name; ///< of the file
    std::string svg;  ///< empty: not drawn
    std::string why;  ///< why it was not drawn
};

/// The figures of exercises 1, 2a, 2b and 3. One whose functions are not written yet, or return nonsense, is not drawn.
std::vector<Figure> figures(const Functions& functions, const Lines& lines);

/// A number with six digits; no minus before a zero.
std::string number(double x);
std::string vector(const V2& v);
std::string vector(const V3& v);

/// "2x - 5y + 6": terms that are zero are left out.
std::string sum(const std::vector<std::pair<double, std::string>>& terms);

/// "2x - 5y + 6 = 0"
std::string equation(const Implicit& line);

/// The command line of both programs; returns the exit code: 0 done, 2 bad input or usage.
int geometryMain(const Functions& functions, const std::string& program, bool steps, int argc, char** argv);

} // namespace rt::lesson00
