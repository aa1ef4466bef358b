#include "tests/grade/questions/ask.h"

#include <algorithm>

#include "tests/grade/questions/known_mistakes.h"
#include "tests/grade/questions/run_class.h"

namespace rt::grade
{

namespace
{

void addOnce(std::vector<std::string>& remarks, const std::string& remark)
{
    if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end()) remarks.push_back(remark);
}

struct Asking
{
    int lesson;
    const AskOptions& options;
    std::vector<const AskedClass*> classes;
    double done = 0, all = 0;
    std::vector<std::optional<PictureTriple>> pictures = {};

    std::vector<ClassRun> run(const Candidate& candidate)
    {
        std::vector<ClassRun> runs;
        for (const auto* asked : classes)
        {
            runs.push_back(runClass(*asked, candidate, options.stop));
            std::optional<PictureTriple> triple;
            if (runs.back().picture && !asked->hidden)
                triple = compareFor(*asked, *runs.back().picture, candidate, lesson);
            if (pictures.size() < runs.size())
                pictures.push_back(triple);
            else if (!pictures[runs.size() - 1])
                pictures[runs.size() - 1] = triple;
            if (candidate.fingerprint) candidate.fingerprint(); // the tree for the comparison is not an answer
            if (options.progress) options.progress(++done / all);
        }
        return runs;
    }
};

/// Answers that the clock cut short say nothing of a program: the machine may have been busier in one run.
bool differ(const ClassRun& first, const ClassRun& second)
{
    return !first.outOfTime && !second.outOfTime && first.fingerprint != second.fingerprint;
}

ClassResult resultOf(const AskedClass& asked, const ClassRun& first, const ClassRun* second)
{
    ClassResult result;
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
    return result;
}

/// Names the mistake in all failing classes of an exercise whose wrong public answers it explains.
void nameMistakes(Answers& answers, const std::vector<const AskedClass*>& classes, const std::vector<ClassRun>& runs,
                  int lesson)
{
    WrongAnswers wrong;
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        if (runs[i].notAttempted) wrong.unfinished.insert(classes[i]->exercise);
        if (!classes[i]->hidden && !runs[i].evidence.empty())
            wrong.evidence[classes[i]->exercise].insert(runs[i].evidence.begin(), runs[i].evidence.end());
    }
    if (wrong.evidence.empty()) return; // the mutants are asked only if there is something to explain
    for (const auto& [exercise, sentence] : likelyMistakes(wrong, knownMistakes(lesson)))
        for (auto& result : answers.classes)
            if (result.exercise == exercise && result.outcome != Outcome::passed) result.mistake = sentence;
}

} // namespace

Answers gradeCandidate(int lesson, const std::function<Candidate()>& start, const Secret& secret,
                       const AskOptions& options)
{
    const auto set = questionSet(lesson, secret, options.pictures);
    Asking asking{lesson, options, {}};
    for (const auto& asked : *set)
        if (options.only.empty() || asked.exercise == options.only) asking.classes.push_back(&asked);
    asking.all = double(asking.classes.size()) * (options.twice ? 2 : 1);

    const auto first = asking.run(start());
    const auto second = options.twice ? asking.run(start()) : std::vector<ClassRun>();
    Answers answers;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        answers.classes.push_back(resultOf(*asking.classes[i], first[i], options.twice ? &second[i] : nullptr));
        answers.classes.back().pictures = asking.pictures[i];
        if (options.twice && differ(first[i], second[i])) addOnce(answers.remarks, "answers differ between two runs");
    }
    if (options.mistakes) nameMistakes(answers, asking.classes, first, lesson);
    return answers;
}

std::optional<std::string> uninitialised(const Answers& pattern, const Answers& zero)
{
    std::vector<std::string> exercises;
    for (const auto& one : pattern.classes)
        for (const auto& other : zero.classes)
            if (one.exercise == other.exercise && one.name == other.name && one.hidden == other.hidden &&
                one.outcome != Outcome::passed && one.outcome != Outcome::timedOut && one.outcome != Outcome::notRun &&
                other.outcome == Outcome::passed)
                addOnce(exercises, one.exercise);
    if (exercises.empty()) return std::nullopt;
    return fmt::format("a variable is read before it is set, in {}", fmt::join(exercises, ", "));
}

} // namespace rt::grade
