// Questions: data and one function each, so that lessons, students and mutants are asked the same way.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/cases/scenes.h"
#include "tests/grade/candidate.h"
#include "tests/grade/questions/in_float.h"
#include "tests/grade/questions/random.h"

namespace rt::grade
{

using cases::Build;
using V = Vec3<double>;

/// A value is wrong if it is not finite or !(|a - b| <= absolute + relative * |b|), b being the lesson's.
struct Tolerance
{
    double absolute, relative;
};

/// Answers of one function. A student may compute in float (2^-24 = 6e-8) or with another formula; questions keep away from
/// where these lose more than two digits. The smallest known mistake is a hundred times as large.
inline constexpr Tolerance forValues{2e-5, 2e-5};
/// Colours and trees: several such functions in a row, through at most three curved surfaces.
inline constexpr Tolerance forTraces{2e-4, 2e-4};

/// What the numbers of an answer are.
enum class Shape
{
    number,
    distance,  ///< -1: a miss
    vector,    ///< three numbers
    transmits, ///< nothing (one 0), or 1 and a vector
    numbers,   ///< names in Answer::names
};

struct Answer
{
    std::vector<double> values;
    std::vector<std::string> names; ///< for Shape::numbers: what each is; may be empty otherwise
};

struct Question
{
    std::string what; ///< "refract(D = (0, -1, 0), N = (0, 1, 0), n1 = 1, n2 = 1.5)"
    Shape shape = Shape::number;
    Tolerance tolerance = forValues;
    std::function<Answer(const Candidate&)> ask;
    /// Is the lesson's answer the same for slightly other input and in float? Else rounding decides, and another question is
    /// made. Empty: made so that it is.
    std::function<bool(int lesson)> safe;
};

/// Questions about one thing that can be wrong. `make` gives one of them; `index` counts them, so that a criterion can mix kinds
/// evenly: a constant answer must never be right for 95 % of a criterion.
struct Criterion
{
    const char* exercise;
    const char* name;
    Question (*make)(Random&, int index);
};

/// A small scene of which only the pixels count that show one feature.
struct SceneCriterion
{
    const char* exercise;
    const char* name;
    SceneDescription (*make)(Random&);
    bool (*shows)(const RayTree&);
};

std::vector<Criterion> questionCriteria(int lesson);
std::vector<SceneCriterion> sceneCriteria(int lesson);

inline constexpr int questionsInACriterion = 40;

/// Index of the first wrong value (a missing one too), or nothing. A name is never compared.
std::optional<std::size_t> firstWrong(const Question& question, const Answer& expected, const Answer& got);
/// The answer in words; where names are known, from the value `at` on.
std::string text(const Question& question, const Answer& answer, std::size_t at = 0);
/// Between two vectors, in degrees; empty if the answer is none, or one of them is not finite or zero.
std::optional<double> degreesBetween(const Question& question, const Answer& expected, const Answer& got);

/// A tree as numbers: each node's place, hit, media, shares and colours; siblings reflected first, as the order in which a
/// student follows two rays is their own.
Answer numbers(const RayTree& tree);

Question askColor(const std::string& what, const SceneDescription& scene, const V& origin, const V& direction);
Question askTree(const std::string& what, const SceneDescription& scene, const V& origin, const V& direction);

inline std::string text(const V& v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

// The criteria of one lesson each.
std::vector<Criterion> geometryCriteria();
std::vector<Criterion> directCriteria();
std::vector<Criterion> mirrorCriteria();
std::vector<Criterion> partialCriteria();
std::vector<Criterion> skyCriteria();
std::vector<Criterion> refractionCriteria();
std::vector<Criterion> fresnelCriteria();
std::vector<Criterion> capCriteria();
std::vector<Criterion> phongCriteria();

} // namespace rt::grade
