// A pixel's ray tree as one web page that needs nothing else: picture, 3D view, tree, source, numbers and stepping.
#pragma once

#include <string>

#include "common/base/image.h"
#include "common/tree/explain.h"

namespace rt::viz
{

/// What a page shows. All texts may come from strangers: none of them can run or leave its place.
struct HtmlPage
{
    const RayTree& tree;
    const SceneDescription& scene; ///< the one that the tree was recorded in
    const Image& picture;          ///< 0x0: none
    std::string title;             ///< "Lesson 06: Fresnel"
    std::string sourceText;        ///< the file whose lines tree.source names; may be empty
    const LectureFormulas& formulas;
};

/// One file that refers to no other and to no network. Reads the templates in viz/html. Throws std::runtime_error with one
/// sentence if they cannot be read, or if the picture cannot be written to the folder for temporary files.
std::string htmlPage(const HtmlPage& page);

/// Of a larger tree the least deep nodes are shown, and the page says so.
inline constexpr int mostHtmlNodes = 12000;

/// Formulas with numbers are given for so many nodes, those that weigh most in the pixel.
inline constexpr int mostExplained = 400;

} // namespace rt::viz
