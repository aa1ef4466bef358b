// What can be seen in a student's source without compiling it.
#pragma once

#include <string>
#include <vector>

namespace rt::grade
{

/// The text with comments and the insides of string and character literals blanked; lines stay where they are, except that
/// those continued with a backslash are joined.
std::string codeOnly(const std::string& text);

/// Each run of blanks is one blank or one line end, so that std::regex, which recurses once a character, does not exhaust our stack.
std::string squeezed(const std::string& text);

/// "glm::reflect is used", for functions of GLM that are what an exercise asks for; and in lesson 01, that the scene is asked
/// without the student's own formulas, for it has none itself there.
std::vector<std::string> remarksOn(const std::string& text, int lesson = 0);

/// Where the compiler can read all that others may read, as in the fallback without bubblewrap: why this text might make it read
/// something, or "". Only plain includes are fine, of our headers or of the standard library's and GLM's.
std::string unsafeToCompile(const std::string& text);

} // namespace rt::grade
