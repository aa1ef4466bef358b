// What the page of a ray tree shows, as JSON: everything is computed here, the page only draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "viz/drawing/rays.h"
#include "viz/html/export_html.h"

namespace rt::viz
{

/// The page's data. Numbers for drawing are rounded to six digits; non-finite ones are null.
nlohmann::json htmlData(const HtmlPage& page);

/// Objects, lights and camera, and from where they are seen first.
nlohmann::json htmlObjects(const SceneDescription& scene, const RayDrawing& drawing, const Extent& objects);

/// Six significant digits; null if it is not finite.
nlohmann::json shortNumber(double x);
nlohmann::json shortTriple(const vec3& v);
/// "#rrggbb"
std::string hex(const Rgba& color);

/// Of a linear colour; empty if it is not finite.
std::string hexOf(const vec3& linear);

} // namespace rt::viz
