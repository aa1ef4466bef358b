// "Did you mean ...?": the known word that a mistyped one was probably meant to be.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace rt
{

/// Letters to insert, delete, replace or swap with their neighbour to turn one word into the other; ASCII capitals count
/// as small letters. Distances above `limit` come back as limit + 1, soon.
inline std::size_t editDistance(std::string_view a, std::string_view b, std::size_t limit)
{
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > limit) return limit + 1;

    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const bool same = small(a[i - 1]) == small(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        if (*std::min_element(row.begin(), row.end()) > limit) return limit + 1;
        beforeLast.swap(last);
        last.swap(row);
    }
    return std::min(last[b.size()], limit + 1);
}

/// The one of `words` that is nearest to `word`, or "" if none is near: at most a third of the letters differ, or one
/// contains the other ("fov" means "vertical_fov"). Of equally near ones the first.
inline std::string_view nearestWord(std::string_view word, const std::vector<std::string_view>& words)
{
    constexpr std::size_t longest = 64, shortestPart = 3;
    if (word.size() > longest) return "";

    std::string_view nearest, part;
    std::size_t distance = longest;
    for (const auto candidate : words)
    {
        if (candidate.empty() || candidate.size() > longest) continue;
        const std::size_t limit = std::max<std::size_t>(1, std::max(word.size(), candidate.size()) / 3);
        const std::size_t d = editDistance(word, candidate, limit);
        if (d <= limit && d < distance)
        {
            distance = d;
            nearest = candidate;
        }
        const bool contains = word.find(candidate) != word.npos || candidate.find(word) != word.npos;
        const bool longEnough = std::min(word.size(), candidate.size()) >= shortestPart;
        if (contains && longEnough && candidate.size() > part.size()) part = candidate;
    }
    return nearest.empty() ? part : nearest;
}

} // namespace rt
