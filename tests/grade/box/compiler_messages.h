// A compiler's output for students: the first errors, without our paths, and what beginners meet in words.
#pragma once

#include <string>
#include <vector>

namespace rt::grade
{

/// The first 20 errors: "exercise.h:12:5: error: ...", followed by the lines that say where in exercise.h that was asked for.
/// `ours`: folders that vanish from paths.
std::vector<std::string> errorsIn(const std::string& output, const std::vector<std::string>& ours);

/// A sentence without a full stop for what is missing or too much: "exercise.h defines no struct Tracer in namespace
/// rt::exercise06", "there is no function refract"; else "exercise.h does not compile".
std::string reasonIn(const std::string& output, int lesson);

} // namespace rt::grade
