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

/// The way to the answers, in lines of text: tutorial_steps.cpp. The lesson's program shows it, the exercise's has none of it.
struct Steps
{
    std::string (*slope)(const Lines& lines);
    std::string (*verify)(const SlopeIntercept& line, double x, const std::string& y);
    std::string (*implicitForm)(const Lines& lines);
    std::string (*distance)(const Implicit& line);
    std::string (*onPaper)(const Lines& lines);
    std::string (*segmentLength)(const Lines& lines);
    std::string (*normals3)(const Lines& lines);
};

/// The lesson's.
const Steps& tutorialSteps();

/// The answers, each with a check, and the way to them if there are steps.
std::string tutorialText(const Functions& functions, const Lines& lines, const Steps* steps);

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
/// In the middle of a formula: a negative number in brackets.
std::string operand(double x);
std::string vector(const V2& v);
std::string vector(const V3& v);

/// "2x - 5y + 6": terms that are zero are left out.
std::string sum(const std::vector<std::pair<double, std::string>>& terms);

/// "2x - 5y + 6 = 0"
std::string equation(const Implicit& line);

/// The command line of both programs, the lesson's with steps; returns the exit code: 0 done, 2 bad input or usage.
int geometryMain(const Functions& functions, const std::string& program, const Steps* steps, int argc, char** argv);

} // namespace rt::lesson00
