#include <fmt/format.h>

#include "common/tree/tree_diff.h"

namespace rt
{

namespace
{

/// Where to look. By the order of comparison everything that the value was computed from agrees; this says so.
std::string advice(const TreeDifference& difference)
{
    const auto& field = difference.field;
    const auto& path = difference.path;
    const auto last = path.find_last_of(">,");
    const auto kind = last == std::string::npos ? path : path.substr(last + 2);
    const bool is = kind.find("reflected") == 0, through = kind.find("transmitted") == 0;
    const bool leaves = path.find_first_of(">,") != std::string::npos; // from a point that agrees
    if (difference.shadowLight >= 0)
    {
        if (field == "direction" || field == "distance") return "The point that it leaves agrees.";
        if (field == "visible")
            return "Its direction and distance agree: look at the test whether something is in the way.";
        if (field == "missing shadow ray") return "The point agrees, but its light is not asked for.";
        return "";
    }
    if (field == "direction" && is)
        return "The point that it leaves agrees, with its normal: look at the reflected vector.";
    if (field == "direction" && through)
        return "The point that it leaves agrees, with its normal, n1 and n2: look at the transmitted vector.";
    if (field == "direction" && !leaves) return "This is the first ray: its pixel or the camera differs.";
    if (field == "weight" && leaves) return "Its direction agrees: look at the share of light that it is given.";
    if (field == "fresnel") return "The ray that came agrees, with n1 and n2: look at the reflectance.";
    if (field.find("hit") == 0) return "Its origin and direction agree: look at the intersection.";
    if (field == "n1" || field == "n2") return "The hit agrees: look at which side of the surface the ray comes from.";
    if (field == "own") return "Its hit and its shadow rays agree: look at how the light of the lamps is added up.";
    if (field == "radiance") return "All that it is made of agrees: look at how it is put together.";
    if (field == "missing ray" && leaves) return "The hit that it should leave agrees: look at when a ray is followed.";
    if (field == "extra ray" && leaves) return "The hit that it leaves agrees: look at when a ray is followed.";
    return "";
}

} // namespace

std::string describe(const TreeDifference& difference)
{
    const int id = difference.gotNode >= 0 ? difference.gotNode : difference.expectedNode;
    const auto comma = difference.path.rfind(", ");
    const auto nodePath = difference.path.substr(0, comma);
    const auto last = nodePath.rfind("> ");
    auto who = nodePath.substr(last == std::string::npos ? 0 : last + 2) + " ray";
    if (comma != std::string::npos) who = difference.path.substr(comma + 2) + " from " + who;
    if (id >= 0) who += fmt::format(" [{}]", id);
    if (last != std::string::npos) who += fmt::format(" ({})", nodePath);

    const bool isMissing = difference.field.find("missing ") == 0, isExtra = difference.field.find("extra ") == 0;
    auto line = isMissing ? who + ": missing, " : isExtra ? who + ": too many, " : who + ": " + difference.field + " ";
    line += fmt::format("expected {}, got {}", difference.expected, difference.got);
    if (difference.angle) line += fmt::format(", {:.3g} degrees apart", *difference.angle);
    if (difference.got.find("nan") != std::string::npos)
        line += "\nnan is not a number: the root of a negative number, or zero divided by zero.";
    const auto further = advice(difference);
    return further.empty() ? line : line + "\n" + further;
}

} // namespace rt
