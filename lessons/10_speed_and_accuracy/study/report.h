// The study on paper: CSV, plots, a page of HTML, and the tables of the lesson's notes.
#pragma once

#include "modelling.h"
#include "study.h"

namespace rt::lesson10
{

/// What the figures were measured on.
struct Machine
{
    std::string compiler, flags, cpu;
};

Machine thisMachine();

struct Report
{
    Machine machine;
    bool quick = false;
    std::vector<SceneStudy> studies;
    std::vector<ModelledScene> modelled;
};

/// The columns of csv(), in order.
std::vector<std::string> csvColumns();

/// One line a setting. Numbers read back to the same double; a field with a comma or a quote is quoted (RFC 4180).
std::string csv(const Report& report);

/// One line a lesson on a scene.
std::string modellingCsv(const Report& report);

/// Time against PSNR of one scene, the Pareto front drawn through, as a file of its own; against the picture of many samples if `many`.
std::string svg(const SceneStudy& study, bool many);

/// All of it on one page that needs no other file, no script and no network.
std::string html(const Report& report);

/// The tables of slides-notes/10-speed-and-accuracy.md, in Markdown.
std::string markdown(const Report& report);

/// `text` with what stands between the lines "<!-- begin NAME -->" and "<!-- end NAME -->" replaced. Throws std::runtime_error if
/// the lines are not there.
std::string replaceSection(const std::string& text, const std::string& name, const std::string& section);

/// A picture as a PNG in a data: address.
std::string dataAddress(const Image& image);

} // namespace rt::lesson10
