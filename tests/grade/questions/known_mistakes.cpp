#include "tests/grade/questions/known_mistakes.h"

#include <map>
#include <mutex>

#include <nlohmann/json.hpp>

#include "tests/grade/questions/run_criterion.h"
#include "tests/lessons/lesson00_mutants.h"
#include "tests/lessons/mutants.h"

namespace rt::grade
{

std::vector<MutantCandidate> mutantCandidates(int lesson)
{
    std::vector<MutantCandidate> all;
    for (const auto& mutant : cases::mutants(lesson))
        all.push_back({mutant.id, mutant.mistake, mutant.endless, {.tracer = mutant.subject}});
    if (lesson == 0)
        for (const auto& mutant : cases::geometryMutants())
        {
            auto candidate = reference(0);
            mutant.make(candidate.geometry);
            all.push_back({fmt::format("00-{}-{}", mutant.group, all.size()), mutant.mistake, false, candidate});
        }
    return all;
}

const std::vector<KnownMistake>& knownMistakes(int lesson)
{
    static std::mutex mutex;
    static std::map<int, std::vector<KnownMistake>> known;
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(lesson); found != known.end()) return found->second;
    std::vector<KnownMistake> all;
    const auto set = questionSet(lesson, {}, false);
    for (const auto& mutant : mutantCandidates(lesson))
    {
        if (mutant.endless) continue;
        KnownMistake one{mutant.id, mutant.mistake, {}};
        for (const auto& asked : *set)
            for (const auto& [question, answer] : runCriterion(asked, mutant.candidate, {}).evidence)
                one.evidence[asked.exercise][question] = answer;
        all.push_back(one);
    }
    return known[lesson] = all;
}

std::string mistakesJson(int lesson)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& mutant : mutantCandidates(lesson))
        if (!mutant.endless)
            list.push_back({{"id", mutant.id},
                            {"mistake", mutant.mistake},
                            {"evidence", ownCasesAnswers(mutant.candidate, lesson).evidence}});
    return nlohmann::ordered_json{{"version", 1}, {"lesson", lesson}, {"mistakes", list}}.dump(1) + "\n";
}

} // namespace rt::grade
