#include "tests/grade/report/page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/files/base64.h"
#include "common/files/markup.h"
#include "common/files/picture_file.h"
#include "common/files/text_file.h"
#include "lessons/programs/registry.h"
#include "tests/grade/digest.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

struct Style
{
    std::string css, hash;
};

/// The style sheet with its SHA-256 as policies write it.
const Style& style()
{
    static const Style once = [] {
        Style made{"\n" + readTextFile(RAYTREE_SOURCE_DIR "/tests/grade/report/page.css"), ""};
        std::string bytes;
        const std::string hex = sha256Hex(made.css);
        for (std::size_t i = 0; i < hex.size(); i += 2) bytes += char(std::stoi(hex.substr(i, 2), nullptr, 16));
        made.hash = base64(bytes);
        return made;
    }();
    return once;
}

/// What is not a number would be black in a file, and look like a shadow.
Image withMagenta(Image image)
{
    for (auto& pixel : image.pixels)
        if (!isFinite(pixel)) pixel = magenta;
    return image;
}

std::string figure(const Image& image, const std::string& title, const PictureTriple& all)
{
    const double radius = std::max(1.5, double(std::max(image.width, image.height)) / 28);
    std::string ring;
    for (const char* layer : {"below", "above"})
        ring += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\"/>", layer, all.x + 0.5,
                            all.y + 0.5, radius);
    return fmt::format("<figure><span class=\"frame\"><img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" "
                       "alt=\"{}: {}\"><svg viewBox=\"0 0 {} {}\" aria-hidden=\"true\">{}</svg></span>"
                       "<figcaption>{}</figcaption></figure>\n",
                       base64(pngBytes(withMagenta(image))), image.width, image.height, html(all.title), title,
                       image.width, image.height, ring, title);
}

} // namespace

std::string page(const std::string& title, const std::string& body)
{
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                       "style-src 'sha256-{}'; base-uri 'none'; form-action 'none'\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "<meta name=\"referrer\" content=\"no-referrer\">\n<meta name=\"robots\" content=\"noindex\">\n"
                       "<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>{}</style>\n</head>\n"
                       "<body>\n<main>\n{}</main>\n</body>\n</html>\n",
                       style().hash, html(title), style().css, body);
}

std::string html(std::string_view text)
{
    return escapedMarkup(cleanLine(text));
}

std::string htmlBlock(std::string_view text, const std::string& label, const char* cssClass)
{
    return fmt::format("<pre class=\"{}\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</pre>\n", cssClass,
                       html(label), escapedMarkup(cleanText(text)));
}

std::string bar(double share)
{
    const double width = std::isfinite(share) ? 100 * std::clamp(share, 0.0, 1.0) : 0;
    return fmt::format("<svg class=\"bar\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" aria-hidden=\"true\">"
                       "<rect class=\"track\" width=\"100\" height=\"10\"/><rect class=\"fill\" width=\"{:.1f}\" "
                       "height=\"10\"/></svg>",
                       width);
}

std::string percentText(double points, double most)
{
    return most > 0 ? fmt::format("{:.0f}&nbsp;%", 100 * points / most) : "";
}

std::string figures(const PictureTriple& all)
{
    if (all.expected.pixels.empty() || all.got.pixels.empty()) return "";
    std::string text =
        "<div class=\"triple\">\n" + figure(all.expected, "expected", all) + figure(all.got, "yours", all);
    if (!all.difference.pixels.empty()) text += figure(all.difference, "difference", all);
    return text + "</div>\n";
}

std::string lessonHtml(int lesson)
{
    if (lesson == 0) return "Lesson 00: Geometry"; // no tracer, hence not in the registry
    const auto* entry = findLesson(lesson);
    return html(entry ? fmt::format("Lesson {:02}: {}", lesson, entry->title) : fmt::format("Lesson {:02}", lesson));
}

} // namespace rt::grade
