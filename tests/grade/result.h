// What grading one submission found out: plain data. The scorer fills it, the reports read it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/base/image.h"

namespace rt::grade
{

/// How a criterion of cases ended; later ones are worse.
enum class Outcome
{
    passed,
    wrong,
    notAttempted,     ///< the exercise's TODO still stands
    notDeterministic, ///< two runs gave other bits; the worse one counts
    crashed,
    timedOut,
    outOfMemory,
    forbiddenCall, ///< a system call that the box refuses
    protocol,      ///< an answer that is not one
    notRun         ///< given up after too many of the above
};

/// One failing case: in words, with numbers.
struct Example
{
    std::string what, expected, got;
    std::optional<double> degrees; ///< between the expected and the given vector, where the answer is one
};

/// What should be seen, what is seen, and where they differ; all of the same size.
struct PictureTriple
{
    std::string title; ///< the scene's
    Image expected, got, difference;
    int x = 0, y = 0;       ///< the worst pixel
    std::string divergence; ///< the first difference of the two ray trees there, in words; empty: none
    std::string command; ///< opens the viewer there, comparing both; SCENE in it stands for a file that holds `scene`
    std::string scene;   ///< as TOML
};

/// Cases that are worth points together.
struct CriterionResult
{
    std::string exercise; ///< "06-fresnel"
    std::string name;     ///< "into glass"
    bool hidden = false;  ///< its cases come from the course's secret: feedback names the criterion only
    int cases = 0, passed = 0;
    double points = 0, most = 0;
    Outcome outcome = Outcome::passed;
    std::optional<Example> example;        ///< the first failing case; never of hidden ones
    std::optional<PictureTriple> pictures; ///< never of hidden ones
    std::string mistake;                   ///< "n1 and n2 are swapped"; empty: unknown
};

/// How far a submission came.
enum class State
{
    graded,
    missing,     ///< there is no file for this lesson
    refused,     ///< its package is not acceptable
    notCompiled, ///< the compiler refuses it, or needed too much
    graderError, ///< something of ours failed; not the student's fault
};

struct SubmissionResult
{
    std::string student; ///< the name of its folder or file: foreign text
    int lesson = 0;
    std::string key;    ///< SHA-256 of submission, grader, lesson data and seed, in hex
    std::string grader; ///< the same without the submission: results that may stand in one gradebook have the same
    State state = State::graded;
    std::string reason;                      ///< one sentence if not graded; foreign text may stand in it
    std::vector<std::string> compilerErrors; ///< the first 20, without our paths: foreign text
    std::vector<CriterionResult> criteria;   ///< by exercise, public before hidden
    std::vector<std::string> remarks;        ///< for the student, as "glm::reflect is used"
    std::string studentText;                 ///< what the program printed: for the instructor only, foreign text
    std::string sandbox;                     ///< "bubblewrap", "chroot", "none"
    double seconds = 0;                      ///< of wall time that grading took
    double compileSeconds = 0;               ///< of processor time

    double points() const
    {
        double sum = 0;
        for (const auto& one : criteria) sum += one.points;
        return sum;
    }
    double most() const
    {
        double sum = 0;
        for (const auto& one : criteria) sum += one.most;
        return sum;
    }
};

const char* name(Outcome outcome); ///< "passed", "wrong", "not attempted", "not deterministic", ...
const char* name(State state);     ///< "graded", "missing", "refused", "not compiled"

} // namespace rt::grade
