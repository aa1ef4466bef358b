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

/// The ids of those todo("id") that still stand in a block which is not as it was handed out: code was written there, and the
/// mark ends it all the same.
std::vector<std::string> todosLeft(const std::string& text, const std::string& handedOut);

} // namespace rt::grade
