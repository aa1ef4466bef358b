// What all pages share: the frame with a policy that lets nothing run or load, and pieces of HTML.
#pragma once

#include <string>
#include <string_view>

#include "tests/grade/result.h"

namespace rt::grade
{

/// A page that needs nothing but itself. `body` is HTML, `title` is text. The policy allows our one style sheet, by its
/// hash, and pictures within the page: even if foreign text became markup, no script would run and nothing be loaded.
std::string page(const std::string& title, const std::string& body);

/// Foreign text as HTML of one line.
std::string html(std::string_view text);

/// Foreign text of several lines as HTML, in a block that can be scrolled with the keyboard, too. `label` says what it is.
std::string htmlBlock(std::string_view text, const std::string& label, const char* cssClass = "");

/// A bar that is filled to `share`, from 0 to 1. The number stands beside it: the bar itself is decoration.
std::string bar(double share);

/// "55 %" as HTML; "" if most is 0.
std::string percentText(double points, double most);

/// What should be seen, what is seen and the difference, side by side, with a ring around the worst pixel.
std::string figures(const PictureTriple& pictures);

/// "Lesson 06: Fresnel", as HTML.
std::string lessonHtml(int lesson);

} // namespace rt::grade
