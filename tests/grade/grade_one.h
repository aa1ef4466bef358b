// Grading one submission: package, compile, ask, score.
#pragma once

#include <atomic>
#include <string>

#include "tests/grade/box/box.h"
#include "tests/grade/package/package.h"
#include "tests/grade/questions/ask.h"
#include "tests/grade/result.h"

namespace rt::grade
{

struct Setting
{
    int lesson = 1;
    Secret secret;
    Sandbox sandbox = Sandbox::bubblewrap;
    Limits limits;
    std::string grader; ///< SHA-256 of this program and of the kit: another grader gives other keys
};

/// What decides the result: SHA-256 over the submission's bytes, the grader, the lesson and the secret, in hex.
std::string keyOf(const Setting& setting, const Taken& taken);

/// The same without the submission.
std::string graderKey(const Setting& setting);

/// SHA-256 over this program's file and the kit that submissions are compiled with, in hex.
std::string graderHash();

/// Never throws for what a submission does; for what the grader cannot do, it does. `worker` counts from 0: each has a user
/// of its own in the box. `folder` is its place for programs, and empty again afterwards. `stop` ends it early; its result is
/// then worth nothing.
SubmissionResult gradeOne(const Submission& submission, const Taken& taken, const Setting& setting, int worker,
                          const std::string& folder, const std::atomic<bool>& stop);

} // namespace rt::grade
