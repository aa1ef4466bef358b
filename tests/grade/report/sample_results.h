// Made-up results for tests: of a student who did well and one who did not, and what an attacker would want in a report.
#pragma once

#include <cmath>
#include <limits>

#include "tests/grade/result.h"

namespace rt::grade::samples
{

/// Everything that some format takes for its own: HTML, CSS, XML, CSV, JSON, terminals, and text that reads backwards.
inline std::string hostileText()
{
    return std::string(
               "</pre></style></title><script>document.title='broken out'</script><img src=x onerror=\"document.title="
               "'broken out'\">\" onerror=\"x\" ' onload='x' ]]> <!-- --> &lt;b&gt; {{data}} ${x} "
               "<a href=\"javascript:alert(1)\">a</a><svg onload=alert(1)>\x1b[31mred\x1b[0m \x1b]0;title\x07"
               "\xe2\x80\xae"
               "drawkcab\xe2\x80\xa8line\xff\xfe\xc0\xaf\xed\xa0\x80 nul") +
           std::string(1, '\0') + " tab\t end\r\n=HYPERLINK(\"http://example.org\",\"x\")\n";
}

/// A picture with a disc, or without.
inline Image disc(double radius, const Vec3<double>& color)
{
    Image image(64, 48);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
        {
            const double dx = x - 36, dy = y - 22, r = std::sqrt(dx * dx + dy * dy);
            const double light = r < radius ? 0.35 + 0.6 * std::sqrt(1 - r * r / (radius * radius)) : 0;
            image.at(x, y) = r < radius ? light * color : Vec3<double>(0.05, 0.07, 0.1) + 0.004 * double(y);
        }
    return image;
}

inline PictureTriple pictures()
{
    PictureTriple triple;
    triple.title = "One glass sphere";
    triple.expected = disc(18, {0.4, 0.8, 0.9});
    triple.got = disc(18, {0.9, 0.5, 0.2});
    triple.difference = Image(64, 48);
    for (std::size_t i = 0; i < triple.got.pixels.size(); ++i)
        triple.difference.pixels[i] = abs(triple.got.pixels[i] - triple.expected.pixels[i]);
    triple.got.at(10, 10) = Vec3<double>(std::numeric_limits<double>::quiet_NaN());
    triple.x = 36;
    triple.y = 22;
    triple.divergence = "node 1: the transmitted ray leaves at 19.5 degrees to the normal, expected 41.8";
    triple.command = "./raytree view 6 lessons/06_fresnel/scenes/half_and_glass.toml --pixel 36,22 --compare exercise";
    return triple;
}

/// Six of ten points of lesson 6: one class wrong, one that crashes, one not attempted, hidden ones.
inline SubmissionResult partial(const std::string& student)
{
    SubmissionResult result;
    result.student = student;
    result.lesson = 6;
    result.key = std::string(64, 'a');
    result.grader = std::string(64, 'b');
    result.sandbox = "bubblewrap";
    result.seconds = 2.375;
    result.compileSeconds = 0.5;
    result.studentText = "debug: n1 = 1.5\n";
    result.remarks = {"glm::reflect is used: the exercise is to write it."};

    CriterionResult into{"06-fresnel", "into glass", false, 40, 40, 1.2, 1.2, Outcome::passed, {}, {}, ""};
    CriterionResult out{"06-fresnel", "out of glass", false, 40, 12, 0, 1.2, Outcome::wrong, {}, {}, ""};
    out.example = Example{"D = (0.6, -0.8, 0), N = (0, 1, 0), n1 = 1.5, n2 = 1", "Fr = 0.0625", "Fr = 0.0204", {}};
    out.mistake = "n1 and n2 are swapped";
    out.pictures = pictures();
    CriterionResult grazing{"06-fresnel", "grazing", false, 40, 3, 0, 0.6, Outcome::crashed, {}, {}, ""};
    grazing.example = Example{"D = (1, -0.0001, 0)", "Fr = 0.9994", "the program ended: segmentation fault", 12.3456};
    CriterionResult secret{"06-fresnel", "out of glass",         true, 93, 30, 0, 2.8, Outcome::wrong, {},
                           {},           "n1 and n2 are swapped"};
    CriterionResult schlick{"06-schlick", "all angles", false, 60, 60, 1.3, 1.3, Outcome::passed, {}, {}, ""};
    CriterionResult schlickSecret{"06-schlick", "all angles", true, 140, 140, 3.5, 3.5, Outcome::passed, {}, {}, ""};
    CriterionResult scene{"06-scene", "glass and mirror", false, 800, 0, 0, 0.4, Outcome::notAttempted, {}, {}, ""};
    result.criteria = {into, out, grazing, secret, schlick, schlickSecret, scene};
    return result;
}

inline SubmissionResult full(const std::string& student)
{
    auto result = partial(student);
    for (auto& one : result.criteria)
    {
        one.passed = one.cases;
        one.points = one.most;
        one.outcome = Outcome::passed;
        one.example.reset();
        one.pictures.reset();
        one.mistake.clear();
    }
    result.remarks.clear();
    result.studentText.clear();
    return result;
}

inline SubmissionResult notCompiled(const std::string& student)
{
    auto result = full(student);
    result.criteria.clear();
    result.state = State::notCompiled;
    result.reason = "the compiler refuses it";
    result.compilerErrors = {
        "exercise.h:41:9: error: 'refelct' was not declared in this scope; did you mean 'reflect'?\n"
        "   41 |         refelct(ray.D, N);\n      |         ^~~~~~~\n      |         reflect",
        "exercise.h:57:2: error: expected '}' at end of input"};
    return result;
}

inline SubmissionResult missing(const std::string& student)
{
    auto result = full(student);
    result.criteria.clear();
    result.state = State::missing;
    result.reason = "there is no exercise.h for lesson 06";
    result.sandbox = "";
    return result;
}

/// A submission whose every foreign text is hostile, some of them a megabyte long.
inline SubmissionResult hostile()
{
    auto result = partial(hostileText());
    const std::string text = hostileText(), longLine(1 << 20, 'x');
    for (auto& one : result.criteria)
    {
        one.exercise += text;
        one.name = text;
        one.mistake = text;
        if (one.example) one.example = Example{text + longLine, longLine, text, 3.0};
        if (one.pictures) one.pictures->title = one.pictures->divergence = one.pictures->command = text;
    }
    result.reason = text;
    result.compilerErrors = {text, longLine, longLine + text};
    result.remarks = {text, longLine};
    result.studentText = text + longLine;
    return result;
}

inline SubmissionResult hostileNotCompiled()
{
    auto result = hostile();
    result.student = "=cmd|' /C calc'!A0";
    result.state = State::notCompiled;
    result.criteria.clear();
    return result;
}

} // namespace rt::grade::samples
