#include "tests/grade/report/statistics.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "tests/grade/report/feedback.h"

namespace rt::grade
{

std::vector<ClassStatistics> classStatistics(std::span<const SubmissionResult> results)
{
    std::map<std::tuple<std::string, std::string, bool>, std::size_t> places;
    std::vector<ClassStatistics> all;
    for (const auto& result : results)
        for (const auto& one : result.criteria)
        {
            const auto [place, isNew] = places.try_emplace({one.exercise, one.name, one.hidden}, all.size());
            if (isNew) all.push_back({one.exercise, one.name, one.hidden, 0, 0, 0, {}});
            auto& sum = all[place->second];
            ++sum.students;
            sum.full += isFull(one) ? 1 : 0;
            sum.share += one.most > 0 ? one.points / one.most : 0;
            ++sum.outcomes[one.outcome];
        }
    for (auto& sum : all) sum.share /= sum.students;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return std::pair(double(a.full) / a.students, a.share) < std::pair(double(b.full) / b.students, b.share);
    });
    return all;
}

std::vector<Mistake> commonMistakes(std::span<const SubmissionResult> results)
{
    std::map<std::pair<std::string, std::string>, int> counts;
    for (const auto& result : results)
    {
        std::set<std::pair<std::string, std::string>> own;
        for (const auto& one : result.criteria)
            if (!one.mistake.empty()) own.insert({one.exercise, one.mistake});
        for (const auto& mistake : own) ++counts[mistake];
    }
    std::vector<Mistake> all;
    for (const auto& [mistake, students] : counts) all.push_back({mistake.first, mistake.second, students});
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.students > b.students; });
    return all;
}

std::array<int, 10> histogram(std::span<const SubmissionResult> results, double most)
{
    std::array<int, 10> bins{};
    for (const auto& result : results)
        if (result.state == State::graded && most > 0)
            // A thousandth of a percent for sums of tenths: 0.1 + 0.2 is not below three tenths.
            ++bins[std::size_t(std::clamp(10 * result.points() / most + 1e-5, 0.0, 9.0))];
    return bins;
}

std::vector<std::string> exercisesOf(std::span<const SubmissionResult> results)
{
    std::vector<std::string> all;
    std::set<std::string> known;
    for (const auto& result : results)
        for (const auto& one : result.criteria)
            if (known.insert(one.exercise).second) all.push_back(one.exercise);
    return all;
}

double mostOf(std::span<const SubmissionResult> results)
{
    double most = 0;
    for (const auto& result : results) most = std::max(most, result.most());
    return most;
}

} // namespace rt::grade
