#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "report.h"

namespace rt::lesson10
{

namespace
{

std::string quoted(const std::string& field)
{
    if (field.find_first_of(",\"\n") == std::string::npos) return field;
    std::string text = "\"";
    for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + '"';
}

std::string line(const std::vector<std::string>& fields)
{
    std::string text;
    for (const auto& field : fields) text += (text.empty() ? "" : ",") + quoted(field);
    return text + "\n";
}

std::string number(double value)
{
    return fmt::format("{}", value);
}

std::vector<std::string> machineFields(const Report& report)
{
    return {report.machine.compiler, report.machine.flags, report.machine.cpu, report.quick ? "quick" : "full"};
}

} // namespace

Machine thisMachine()
{
    Machine machine{RAYTREE_COMPILER, RAYTREE_FLAGS, "unknown CPU"};
    std::ifstream info("/proc/cpuinfo");
    for (std::string text; std::getline(info, text);)
        if (text.rfind("model name", 0) == 0)
        {
            machine.cpu = text.substr(text.find(':') + 2);
            break;
        }
    return machine;
}

std::vector<std::string> csvColumns()
{
    return {"scene",        "knob",         "setting",         "scalar",
            "sphere",       "leaving",      "fresnel",         "depth",
            "cutoff",       "samples",      "width",           "height",
            "ns_per_pixel", "ns_per_ray",   "rays_per_pixel",  "rounds",
            "max_absolute", "rms",          "max_relative",    "rms_relative",
            "psnr_db",      "psnr_many_db", "visible_pixels",  "wrong_first_hit",
            "wrong_tree",   "acne_pixels",  "leak_pixels",     "non_finite_pixels",
            "pareto",       "pareto_many",  "reference_depth", "reference_cutoff",
            "many_samples", "compiler",     "flags",           "cpu",
            "plan"};
}

std::string csv(const Report& report)
{
    std::string text = line(csvColumns());
    for (const auto& study : report.studies)
        for (const auto& row : study.rows)
        {
            // The reference has one sample: what it says about more is not an error.
            const auto same = [&](double value) { return row.setting.spp == 1 ? number(value) : ""; };
            const auto& [errors, rays, s] = std::tie(row.errors, row.rays, row.setting);
            std::vector<std::string> fields{study.name,
                                            row.knob,
                                            describe(s),
                                            name(s.scalar),
                                            name(s.sphere),
                                            name(s.leaving),
                                            name(s.glass),
                                            number(s.depth),
                                            number(s.cutoff),
                                            number(s.spp),
                                            number(row.image.width),
                                            number(row.image.height),
                                            number(row.nsPerPixel()),
                                            number(row.nsPerRay()),
                                            number(rays.perPixel),
                                            number(row.rounds),
                                            same(errors.maxAbsolute),
                                            same(errors.rms),
                                            same(errors.maxRelative),
                                            same(errors.rmsRelative),
                                            same(errors.psnr),
                                            number(row.manyErrors.psnr),
                                            same(errors.visible),
                                            number(rays.wrongFirst),
                                            number(rays.wrongShape),
                                            number(rays.acnePixels),
                                            number(rays.leakPixels),
                                            number(errors.nonFinite),
                                            number(row.front),
                                            number(row.manyFront),
                                            number(study.reference.setting.depth),
                                            number(study.reference.setting.cutoff),
                                            number(study.manySamples)};
            for (auto& field : machineFields(report)) fields.push_back(std::move(field));
            text += line(fields);
        }
    return text;
}

std::string modellingCsv(const Report& report)
{
    std::string text = "scene,smallest_lesson,lesson,width,height,cpu_ms,ratio,same_bits,stack_bytes_per_level,"
                       "compiler,flags,cpu,plan\n";
    for (const auto& scene : report.modelled)
        for (const auto& lesson : scene.lessons)
        {
            std::vector<std::string> fields{scene.scene,
                                            number(scene.lessons[0].lesson),
                                            number(lesson.lesson),
                                            number(scene.width),
                                            number(scene.height),
                                            number(lesson.cpuSeconds * 1e3),
                                            number(lesson.ratio),
                                            number(lesson.sameBits),
                                            number(double(lesson.bytesALevel))};
            for (auto& field : machineFields(report)) fields.push_back(std::move(field));
            text += line(fields);
        }
    return text;
}

std::string replaceSection(const std::string& text, const std::string& name, const std::string& section)
{
    const std::string begin = "<!-- begin " + name + " -->\n", end = "<!-- end " + name + " -->";
    const auto first = text.find(begin), last = text.find(end);
    if (first == std::string::npos || last == std::string::npos || last < first)
        throw std::runtime_error(
            fmt::format("expected the lines \"<!-- begin {0} -->\" and \"{1}\" in the page", name, end));
    return text.substr(0, first + begin.size()) + section + text.substr(last);
}

} // namespace rt::lesson10
