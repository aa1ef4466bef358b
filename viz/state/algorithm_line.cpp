#include "viz/state/algorithm_line.h"

#include <algorithm>

namespace rt::viz
{

namespace
{

bool isWord(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Places of a whole word.
std::vector<std::size_t> placesOf(const std::string& word, const std::string& text)
{
    std::vector<std::size_t> places;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if ((at == 0 || !isWord(text[at - 1])) && (at + word.size() == text.size() || !isWord(text[at + word.size()])))
            places.push_back(at);
    return places;
}

/// "hit" of "rec.ray(ray, hit);"; empty unless it is a plain name.
std::string lastArgument(const std::string& call)
{
    const auto close = call.rfind(')');
    if (close == std::string::npos) return "";
    auto start = close;
    while (start > 0 && isWord(call[start - 1])) --start;
    const auto before = call.find_last_not_of(' ', start == 0 ? 0 : start - 1);
    const bool isWhole = before != std::string::npos && (call[before] == ',' || call[before] == '(');
    return isWhole ? call.substr(start, close - start) : "";
}

/// Is there "name = ", "name += " or the like? Not "name == ".
bool sets(const std::string& line, const std::string& name)
{
    for (const auto place : placesOf(name, line))
    {
        auto at = line.find_first_not_of(' ', place + name.size());
        if (at == std::string::npos) continue;
        if (std::string("+-*/|&^").find(line[at]) != std::string::npos) ++at;
        if (at < line.size() && line[at] == '=' && (at + 1 == line.size() || line[at + 1] != '=')) return true;
    }
    return false;
}

} // namespace

Told toldBy(Event::Kind kind)
{
    return kind == Event::Kind::returns || kind == Event::Kind::notFollowed ? Told::end : Told::value;
}

AlgorithmLines::AlgorithmLines(const Listing& listing)
{
    const auto code = codeOf(listing);
    lines.resize(code.size());
    for (int line = 1; line <= int(code.size()); ++line)
    {
        auto& found = lines[std::size_t(line) - 1];
        found.value = found.end = line;
        const auto& text = code[std::size_t(line) - 1];
        for (const auto kind : {RayKind::reflected, RayKind::transmitted})
            if (text.find(std::string("trace(ray.spawn(") + rt::name(kind)) != std::string::npos)
                calls.push_back({line, kind});
        const auto& pieces = listing.inked[std::size_t(line) - 1];
        if (pieces.empty() || pieces[0].ink != Ink::instrument) continue;
        const auto function = found.function = functionAround(listing, line);
        if (!function.contains(line)) continue;
        const auto textOf = [&](int i) -> const std::string& { return code[std::size_t(i) - 1]; };
        int end = line + 1;
        while (end <= function.last && placesOf("return", textOf(end)).empty()) ++end;
        if (end <= function.last) found.end = end;
        const auto name = lastArgument(text);
        int value = line - 1;
        while (value >= function.first && (name.empty() || !sets(textOf(value), name))) --value;
        if (value >= function.first) found.value = value;
    }
}

int AlgorithmLines::of(int line, Told told) const
{
    if (line < 1 || line > int(lines.size())) return line;
    const auto& found = lines[std::size_t(line) - 1];
    return told == Told::value ? found.value : found.end;
}

int AlgorithmLines::callOf(const RayTree& tree, const Event& event) const
{
    const bool isCapped = event.kind == Event::Kind::notFollowed;
    if (!isCapped && event.kind != Event::Kind::follow) return 0;
    const auto& node = tree.nodes[std::size_t(event.node)];
    const int sender = isCapped ? event.node : node.parent;
    if (sender < 0) return 0;
    const auto kind = isCapped ? tree.capped[std::size_t(event.index)].kind : node.kind;
    const auto& parent = tree.nodes[std::size_t(sender)];
    // At glass all lessons leave the function that met it for one of its own.
    const auto followed =
        parent.line < 1 || parent.line > int(lines.size()) ? LineRange{} : lines[std::size_t(parent.line) - 1].function;
    int best = 0;
    for (const auto& call : calls)
        if (call.kind == kind && (best == 0 || followed.contains(call.line) != parent.n1.has_value())) best = call.line;
    return best;
}

} // namespace rt::viz
