#include "viz/html/export_html.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/base/image.h"
#include "common/files/base64.h"
#include "common/files/markup.h"
#include "common/files/picture_file.h"
#include "common/files/text_file.h"
#include "common/program/program.h"
#include "viz/drawing/picture_view.h"
#include "viz/html/html_data.h"
#include "viz/state/controller.h"

namespace rt::viz
{

namespace
{

constexpr const char* scripts[] = {"state.js", "theme.js",   "view.js",    "space.js", "labels.js", "scene.js",
                                   "tree.js",  "picture.js", "numbers.js", "code.js",  "chart.js",  "main.js"};

/// Widths that are tried for the picture, and the size of file that is good enough.
constexpr int pictureWidths[] = {640, 480, 400, 320, 240};
constexpr std::size_t pictureBytes = 30 * 1024;

/// Without indentation and lines that are only a comment.
std::string compact(const std::string& text)
{
    std::istringstream in(text);
    std::string result, line;
    bool inComment = false;
    while (std::getline(in, line))
    {
        const auto start = line.find_first_not_of(" \t");
        if (start == std::string::npos) continue;
        if (line.compare(start, 2, "/*") == 0) inComment = true;
        const bool skipped = inComment || line.compare(start, 2, "//") == 0;
        if (inComment && line.find("*/") != std::string::npos) inComment = false;
        if (!skipped) result += line.substr(start) + "\n";
    }
    return result;
}

std::string readTemplate(const std::string& name)
{
    return readTextFile(projectFile("viz/html/" + name));
}

/// JSON that may stand in a script element: nothing in it can end the element or start a comment.
std::string scriptJson(const nlohmann::json& json)
{
    const auto text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string result;
    result.reserve(text.size() + text.size() / 16);
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '<' || text[i] == '>' || text[i] == '&')
            result += fmt::format("\\u{:04x}", int(text[i]));
        else if (text.compare(i, 3, "\u2028") == 0 || text.compare(i, 3, "\u2029") == 0)
        {
            result += text[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
            i += 2;
        }
        else
            result += text[i];
    return result;
}

Image asImage(const ScreenPicture& picture)
{
    Image image(picture.width, picture.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
    {
        const auto& p = picture.pixels[i];
        image.pixels[i] = {fromSrgb8(p.r), fromSrgb8(p.g), fromSrgb8(p.b)};
    }
    return image;
}

/// The picture as a data URL, reduced until the file is small; empty if there is no picture.
std::string pictureUrl(const Image& image)
{
    if (image.width < 1 || image.height < 1) return "";
    const ScreenPicture picture(image);
    std::string png;
    for (const int width : pictureWidths)
    {
        const double scale = std::min(1.0, double(width) / image.width);
        const auto side = int(std::ceil(scale * std::max(image.width, image.height)));
        png = pngBytes(asImage(picture.reduced(side)));
        if (png.size() <= pictureBytes) break;
    }
    return "data:image/png;base64," + base64(png);
}

/// The colours of one look of the window as custom properties of CSS.
std::string paletteCss(Look look)
{
    const Theme& theme = themeOf(look);
    const std::pair<const char*, Rgba> colors[] = {{"window", theme.window},
                                                   {"panel", theme.panel},
                                                   {"raised", theme.panelRaised},
                                                   {"line", theme.line},
                                                   {"sky-low", theme.skyLow},
                                                   {"sky-high", theme.skyHigh},
                                                   {"text", theme.text},
                                                   {"dim", theme.textDim},
                                                   {"faint", theme.textFaint},
                                                   {"accent", theme.accent},
                                                   {"ink", theme.dark},
                                                   {"lit", theme.lit},
                                                   {"keyword", theme.keyword},
                                                   {"literal", theme.literal},
                                                   {"comment", theme.comment},
                                                   {"camera", colorOf(RayRole::camera, look)},
                                                   {"reflected", colorOf(RayRole::reflected, look)},
                                                   {"transmitted", colorOf(RayRole::transmitted, look)},
                                                   {"reaches", colorOf(RayRole::reaches, look)},
                                                   {"blocked", colorOf(RayRole::blocked, look)},
                                                   {"normal", colorOf(RayRole::normal, look)}};
    std::string css = fmt::format(":root[data-theme={}]{{", name(look));
    for (const auto& [property, value] : colors) css += fmt::format("--{}:{};", property, hex(value));
    return css + "}\n";
}

/// The template with each {{name}} replaced, once: what is put in is not looked at again.
std::string filled(const std::string& text, const std::map<std::string, std::string>& values)
{
    std::string result;
    std::size_t at = 0;
    while (true)
    {
        const auto open = text.find("{{", at), close = text.find("}}", open);
        if (open == std::string::npos || close == std::string::npos) return result + text.substr(at);
        const auto name = text.substr(open + 2, close - open - 2);
        const auto value = values.find(name);
        if (value == values.end())
            throw std::runtime_error(fmt::format("viz/html/page.html: there is no text for {{{{{}}}}}", name));
        result += text.substr(at, open - at) + value->second;
        at = close + 2;
    }
}

} // namespace

std::string htmlPage(const HtmlPage& page)
{
    std::string script;
    for (const char* name : scripts) script += compact(readTemplate(name));
    return filled(compact(readTemplate("page.html")),
                  {{"title", escapedMarkup(page.title)},
                   {"style", paletteCss(Look::dark) + paletteCss(Look::light) + compact(readTemplate("page.css"))},
                   {"script", script},
                   {"data", scriptJson(htmlData(page))},
                   {"picture", pictureUrl(page.picture)}});
}

} // namespace rt::viz
