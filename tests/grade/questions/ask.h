// Asks a candidate everything about one lesson, twice, and scores the answers. DESIGN.md: "Questions and points".
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/grade/candidate.h"
#include "tests/grade/result.h"

namespace rt::grade
{

/// What hidden questions are made from. Whoever does not know `course` cannot foresee them.
struct Secret
{
    std::string course; ///< any bytes; empty: there are no hidden questions
    std::string term;   ///< "2026-autumn": other questions with the same secret
};

struct AskOptions
{
    bool twice = true;                       ///< on a second fresh candidate too; what differs is not deterministic
    bool pictures = true;                    ///< scenes; without them their points are shared by the other criteria
    bool mistakes = true;                    ///< name the likely mistake
    bool hidden = true;                      ///< ask the hidden questions too
    std::string only;                        ///< the id of one exercise; empty: all of the lesson
    std::function<void(double)> progress;    ///< called after each criterion with the share done, in [0, 1]
    const std::atomic<bool>* stop = nullptr; ///< set it to interrupt: gradeCandidate throws Interrupted
};

struct Interrupted : std::runtime_error
{
    Interrupted() : std::runtime_error("interrupted") {}
};

struct Answers
{
    std::vector<CriterionResult> criteria; ///< by exercise in the order of the manifest, public before hidden
    std::vector<std::string> remarks;      ///< each once
};

/// Lesson 0 to 8. start() gives a candidate in a fresh process, for each exercise, run, and once for its public and once for its
/// hidden questions; the one before is not asked any more. Its functions may throw NotAttempted and Died, and anything else
/// they throw counts as a wrong answer. Throws Interrupted; std::runtime_error with one sentence if the manifest is
/// broken. Threads may call it at the same time; they share the questions and what the lesson answers to them.
Answers gradeCandidate(int lesson, const std::function<Candidate()>& start, const Secret& secret,
                       const AskOptions& options = {});

/// The same source compiled twice, unset variables filled with a pattern and with zero: the remark if answers that are wrong
/// with the pattern are right with zero, naming the exercises.
std::optional<std::string> uninitialised(const Answers& pattern, const Answers& zero);

} // namespace rt::grade
