#include "tests/grade/questions/ask.h"

#include <algorithm>
#include <span>

#include "tests/grade/questions/known_mistakes.h"
#include "tests/grade/questions/run_criterion.h"

namespace rt::grade
{

namespace
{

void addOnce(std::vector<std::string>& remarks, const std::string& remark)
{
    if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end()) remarks.push_back(remark);
}

/// A criterion, how it went on each candidate that was asked, and its picture for the student's eyes.
struct Asked
{
    const AskedCriterion* what;
    std::vector<CriterionRun> runs = {};
    std::optional<PictureTriple> picture = {};
};

/// What one process is asked: the criteria of one exercise, public or hidden. So what one exercise does costs no other one
/// anything, and whoever has seen a hidden question is asked no public one, whose answers students see.
using Part = std::span<Asked>;

/// Classes of one exercise stand together, public before hidden.
std::vector<Part> partsOf(std::vector<Asked>& all, bool hidden)
{
    std::vector<Part> parts;
    const auto belongs = [&](std::size_t i, std::size_t first) {
        return all[i].what->exercise == all[first].what->exercise && all[i].what->hidden == all[first].what->hidden;
    };
    for (std::size_t first = 0, end; first < all.size(); first = end)
    {
        for (end = first; end < all.size() && belongs(end, first);) ++end;
        if (all[first].what->hidden == hidden) parts.push_back(Part(all).subspan(first, end - first));
    }
    return parts;
}

/// The next run of a part. What is lost already is not asked again.
void askPart(Part part, const Candidate& candidate, int lesson, const AskOptions& options,
             const std::function<void()>& progress)
{
    bool hangs = false; // each time costs seconds
    for (auto& [asked, runs, picture] : part)
    {
        progress();
        if (!runs.empty() && runs.front().gaveUp) continue;
        runs.push_back(runCriterion(*asked, candidate, options.stop, hangs));
        hangs |= runs.back().gaveUp && runs.back().outOfTime;
        if (runs.back().picture && !asked->hidden && !picture)
            picture = compareFor(*asked, *runs.back().picture, candidate, lesson);
        if (candidate.fingerprint) candidate.fingerprint(); // the tree for the comparison is not an answer
    }
}

/// The exercises whose public criteria ended the program, `all` of them or any.
std::vector<std::string> exercisesThatEnded(std::vector<Asked>& asked, bool all)
{
    std::vector<std::string> exercises;
    for (const auto part : partsOf(asked, false))
    {
        const auto ended = [](const Asked& one) { return !one.runs.empty() && one.runs.front().gaveUp; };
        if (all ? std::all_of(part.begin(), part.end(), ended) : std::any_of(part.begin(), part.end(), ended))
            exercises.push_back(part.front().what->exercise);
    }
    return exercises;
}

/// Answers that the clock cut short say nothing of a program: the machine may have been busier in one run.
bool differ(const CriterionRun& first, const CriterionRun& second)
{
    return !first.outOfTime && !second.outOfTime && first.fingerprint != second.fingerprint;
}

CriterionResult resultOf(const Asked& of)
{
    const auto& asked = *of.what;
    const auto& first = of.runs.front();
    const auto* second = of.runs.size() > 1 ? &of.runs[1] : nullptr;
    CriterionResult result;
    result.exercise = asked.exercise;
    result.name = asked.name;
    result.hidden = asked.hidden;
    result.most = asked.most;
    result.cases = first.cases;
    result.passed = second ? std::min(first.passed, second->passed) : first.passed;
    result.points = asked.most * (second ? std::min(first.credit, second->credit) : first.credit);
    result.outcome = second ? std::max(first.outcome, second->outcome) : first.outcome;
    if (second && differ(first, *second)) result.outcome = std::max(result.outcome, Outcome::notDeterministic);
    if (!asked.hidden) result.example = first.example || !second ? first.example : second->example;
    result.pictures = of.picture;
    return result;
}

/// Right colours were computed, and not noted: a line of the recorder was jumped over, as by a `return` in place of a TODO.
bool picturesAreRightAndTreesAreNot(Part part)
{
    const auto isPicture = [](const Asked& one) { return one.what->picture.has_value(); };
    const auto isWrong = [](const Asked& one) { return one.runs.front().outcome != Outcome::passed; };
    return std::any_of(part.begin(), part.end(), isPicture) &&
           std::none_of(part.begin(), part.end(), [&](const Asked& one) { return isPicture(one) && isWrong(one); }) &&
           std::any_of(part.begin(), part.end(), [](const Asked& one) {
               const auto& run = one.runs.front();
               return run.outcome == Outcome::wrong && run.example &&
                      run.example->what.find(": ray tree of") != std::string::npos;
           });
}

/// What students are told of all criteria together comes from public ones only: it is the same whatever the secret.
std::vector<std::string> publicRemarks(std::vector<Asked>& asked, const std::vector<std::string>& hopeless)
{
    std::vector<std::string> remarks;
    for (const auto& one : asked)
        if (!one.what->hidden && one.runs.size() > 1 && differ(one.runs[0], one.runs[1]))
            addOnce(remarks, "answers differ between two runs");
    if (const auto ended = exercisesThatEnded(asked, false); ended.size() > 1)
        remarks.push_back(fmt::format("the program ended, or did not answer, in {}: where one of them calls another, "
                                      "mend that one first",
                                      fmt::join(ended, ", ")));
    for (const auto part : partsOf(asked, false))
        if (picturesAreRightAndTreesAreNot(part))
            remarks.push_back(
                fmt::format("the pictures of {} are right, its ray trees are not: they are what the lines "
                            "`rec.` note, so nothing may return before those",
                            part.front().what->exercise));
    const bool anyHidden = std::any_of(asked.begin(), asked.end(), [](const Asked& one) { return one.what->hidden; });
    if (!hopeless.empty() && anyHidden)
        remarks.push_back(fmt::format("all public cases of {} ended the program, so no hidden ones were asked",
                                      fmt::join(hopeless, ", ")));
    return remarks;
}

/// Names the mistake in all failing criteria of an exercise whose wrong public answers it explains.
void nameMistakes(Answers& answers, const std::vector<Asked>& asked, int lesson)
{
    WrongAnswers wrong;
    for (const auto& [what, runs, picture] : asked)
    {
        if (what->hidden) continue;
        if (runs.front().notAttempted) wrong.unfinished.insert(what->exercise);
        if (!runs.front().evidence.empty())
            wrong.evidence[what->exercise].insert(runs.front().evidence.begin(), runs.front().evidence.end());
    }
    if (wrong.evidence.empty()) return; // the mutants are asked only if there is something to explain
    for (const auto& [exercise, sentence] : likelyMistakes(wrong, knownMistakes(lesson)))
        for (auto& result : answers.criteria)
            if (result.exercise == exercise && result.outcome != Outcome::passed) result.mistake = sentence;
}

} // namespace

Answers gradeCandidate(int lesson, const std::function<Candidate()>& start, const Secret& secret,
                       const AskOptions& options)
{
    const auto set = questionSet(lesson, secret, options.pictures);
    std::vector<Asked> asked;
    for (const auto& one : *set)
        if ((options.only.empty() || one.exercise == options.only) && (options.hidden || !one.hidden))
            asked.push_back({&one});
    const int runs = options.twice ? 2 : 1;
    double done = 0;
    const auto progress = [&] {
        if (options.progress) options.progress(++done / double(asked.size() * std::size_t(runs)));
    };
    std::vector<std::string> hopeless;
    for (const bool hidden : {false, true})
    {
        for (const auto part : partsOf(asked, hidden))
            for (int run = 0; run < runs; ++run)
            {
                const auto& exercise = part.front().what->exercise;
                if (std::find(hopeless.begin(), hopeless.end(), exercise) != hopeless.end())
                    for (auto& one : part) one.runs = {notAsked(*one.what)};
                askPart(part, start(), lesson, options, progress);
            }
        hopeless = exercisesThatEnded(asked, true);
    }
    Answers answers;
    for (const auto& one : asked) answers.criteria.push_back(resultOf(one));
    answers.remarks = publicRemarks(asked, hopeless);
    if (options.mistakes) nameMistakes(answers, asked, lesson);
    return answers;
}

std::optional<std::string> uninitialised(const Answers& pattern, const Answers& zero)
{
    std::vector<std::string> exercises;
    for (const auto& one : pattern.criteria)
        for (const auto& other : zero.criteria)
            if (one.exercise == other.exercise && one.name == other.name && one.hidden == other.hidden &&
                one.outcome != Outcome::passed && one.outcome != Outcome::timedOut && one.outcome != Outcome::notRun &&
                other.outcome == Outcome::passed)
                addOnce(exercises, one.exercise);
    if (exercises.empty()) return std::nullopt;
    return fmt::format("a variable is read before it is set, in {}", fmt::join(exercises, ", "));
}

} // namespace rt::grade
