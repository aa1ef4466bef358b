#include "lessons/10_speed_and_accuracy/study/study.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/10_speed_and_accuracy/study/recommend.h"
#include "lessons/10_speed_and_accuracy/study/report.h"
#include "lessons/programs/registry.h"

namespace rt::lesson10
{

namespace
{

constexpr const char* classic = "lessons/10_speed_and_accuracy/scenes/classic.toml";
const std::atomic<bool> go = false;

SceneDescription scene(int width, int height)
{
    auto description = resized(loadScene(projectFile(classic)), width, height);
    description.file = "classic.toml";
    return description;
}

const SceneStudy& smallStudy()
{
    static const auto measured =
        study(scene(24, 18),
              {.quick = true, .width = 24, .height = 18, .rounds = 2, .mostSamples = 4, .manySamples = 16}, {}, go);
    return *measured;
}

const Row& row(const std::string& described)
{
    const auto& rows = smallStudy().rows;
    return *std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return describe(r.setting) == described; });
}

std::vector<std::string> lines(const std::string& text)
{
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

/// Fields of a CSV line; commas within quotes do not count.
std::size_t fields(const std::string& line)
{
    bool quoted = false;
    return 1 + std::size_t(std::count_if(line.begin(), line.end(), [&](char c) {
               quoted = quoted != (c == '"');
               return c == ',' && !quoted;
           }));
}

TEST(Study, EveryKnobIsMeasured)
{
    const auto& rows = smallStudy().rows;
    EXPECT_EQ(describe(rows[0].setting), "baseline");
    for (const char* knob :
         {"scalar type", "sphere formula", "self-hit policy", "Fresnel", "depth", "cutoff", "samples", "mixture"})
        EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const Row& r) { return r.knob == knob; })) << knob;
    for (const auto& r : rows)
    {
        EXPECT_GT(r.cpuSeconds, 0) << describe(r.setting);
        EXPECT_GE(r.rounds, 2) << describe(r.setting);
        EXPECT_GT(r.rays.perPixel, 1) << describe(r.setting);
    }
}

TEST(Study, MoreDepthIsMoreAccurateAndMoreRays)
{
    EXPECT_LT(row("depth 1").errors.psnr, row("depth 2").errors.psnr);
    EXPECT_LT(row("depth 2").errors.psnr, row("depth 4").errors.psnr);
    EXPECT_LT(row("depth 4").errors.psnr, row("depth 64; cutoff 0.0001").errors.psnr);
    EXPECT_LT(row("depth 1").rays.perPixel, row("depth 4").rays.perPixel);
    EXPECT_EQ(row("4 samples").rays.perPixel > 3 * row("baseline").rays.perPixel, true);
}

TEST(Study, NoMarkedRowIsDominated)
{
    for (const auto& a : smallStudy().rows)
        for (const auto& b : smallStudy().rows)
            if (a.front && b.setting.spp == 1)
            {
                // Accuracies count in tenths of a dB.
                EXPECT_FALSE(b.cpuSeconds < a.cpuSeconds && b.errors.psnr > a.errors.psnr + 0.1)
                    << describe(a.setting) << ", " << describe(b.setting);
            }
}

TEST(Study, ASceneWithoutGlassAndMirrorsHasFewerKnobs)
{
    auto plain = scene(24, 18);
    for (auto& mat : plain.materials) mat.mirror = mat.ior = 0;
    for (const auto& [knob, setting] : knobsAlone(plain, 4))
    {
        EXPECT_NE(knob, "Fresnel");
        EXPECT_NE(knob, "depth");
        EXPECT_NE(knob, "cutoff");
    }
    for (const auto& setting : candidates(scene(24, 18), 4)) EXPECT_FALSE(isExhibit(setting)) << describe(setting);
}

TEST(Study, AReferenceWhoseTreesGrowWithoutEndIsCutOffOrLessDeep)
{
    const auto box = loadScene(projectFile("lessons/07_recursion_caps/scenes/mirror_box.toml"));
    const Setting unlimited{.scalar = Scalar::longDouble, .depth = 64, .cutoff = 0};
    EXPECT_EQ(referenceSetting(scene(24, 18), 500), unlimited);
    EXPECT_FALSE(affordable(box, unlimited, 500));
    const auto limited = referenceSetting(box, 500);
    EXPECT_TRUE(affordable(box, limited, 500));
    EXPECT_TRUE(limited.depth < 64 || limited.cutoff > 0);
    EXPECT_EQ(limited.scalar, Scalar::longDouble);
}

TEST(Study, StopsWhenItIsTold)
{
    const std::atomic<bool> stop = true;
    EXPECT_FALSE(study(scene(24, 18), Plan::quickOne(), {}, stop));
    EXPECT_FALSE(recommend(
        scene(24, 18), {.seconds = 1, .decibels = {}}, [](const std::string&) {}, stop));
    EXPECT_FALSE(model(scene(24, 18), true, 2, 1, stop));
}

TEST(Study, OfAllScenesTheWorstAccuracyCounts)
{
    const std::vector<SceneStudy> two{smallStudy(), smallStudy()};
    auto changed = two;
    for (auto& r : changed[1].rows) r.cpuSeconds *= 4;
    changed[1].rows[1].errors.psnr = 3;
    const auto all = overAll(changed);
    ASSERT_EQ(all.rows.size(), two[0].rows.size());
    EXPECT_NEAR(all.rows[0].nsPerPixel(), 2 * two[0].rows[0].nsPerPixel(), 1e-6 * all.rows[0].nsPerPixel());
    EXPECT_EQ(all.rows[1].errors.psnr, 3);
    EXPECT_EQ(all.rows[2].errors.psnr, two[0].rows[2].errors.psnr);
}

Report smallReport()
{
    return {.machine = {"compiler, \"quoted\"", "-O2", "CPU"},
            .quick = true,
            .studies = {smallStudy()},
            .modelled = {*model(scene(24, 18), true, 3, 0.1, go)}};
}

TEST(Report, TheCsvHasItsColumnsInEveryLine)
{
    const auto text = lines(csv(smallReport()));
    ASSERT_EQ(text.size(), 1 + smallStudy().rows.size());
    const auto columns = csvColumns();
    for (const char* needed :
         {"scene", "knob", "ns_per_pixel", "rays_per_pixel", "psnr_db", "acne_pixels", "compiler", "flags", "cpu"})
        EXPECT_NE(std::find(columns.begin(), columns.end(), needed), columns.end()) << needed;
    for (const auto& line : text) EXPECT_EQ(fields(line), columns.size()) << line;
    EXPECT_NE(text[1].find("\"compiler, \"\"quoted\"\"\""), std::string::npos);
    const auto modelling = lines(modellingCsv(smallReport()));
    for (const auto& line : modelling) EXPECT_EQ(fields(line), fields(modelling[0])) << line;
}

TEST(Report, ThePageNeedsNothingElse)
{
    const auto page = html(smallReport());
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
    EXPECT_EQ(page.find("href="), std::string::npos);
    EXPECT_NE(page.find("src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    EXPECT_NE(page.find("<svg"), std::string::npos);
}

TEST(Report, OnlyItsOwnSectionOfAPageIsReplaced)
{
    EXPECT_EQ(replaceSection("a\n<!-- begin t -->\nold\n<!-- end t -->\nb\n", "t", "new\n"),
              "a\n<!-- begin t -->\nnew\n<!-- end t -->\nb\n");
    EXPECT_THROW(replaceSection("no section", "t", "new"), std::runtime_error);
}

TEST(Modelling, TheSmallestLessonHasTheBitsOfAllLaterOnes)
{
    for (const auto& file : shippedScenes())
    {
        const auto one = model(resized(loadScene(projectFile(file)), 20, 15), true, 3, 0, go);
        ASSERT_TRUE(one);
        for (const auto& lesson : one->lessons) EXPECT_TRUE(lesson.sameBits) << file << ", lesson " << lesson.lesson;
    }
}

TEST(Modelling, MirrorsTakeStackAndDiffuseSurfacesDoNot)
{
    EXPECT_GT(stackALevel(8, scene(24, 18)), 100U);
    EXPECT_EQ(stackALevel(1, loadScene(projectFile("lessons/01_direct_illumination/scenes/diffuse_spheres.toml"))), 0U);
}

TEST(Recommend, KeepsItsPromiseOfAccuracy)
{
    for (const double decibels : {30.0, 60.0, 80.0})
    {
        const auto found = recommend(
            scene(240, 180), {.seconds = {}, .decibels = decibels}, [](const std::string&) {}, go);
        ASSERT_TRUE(found && found->kept()) << decibels;
        EXPECT_GT(found->stride, 1) << "measured on some rows only";
        const auto exact = prepare(scene(240, 180), found->reference)->render({});
        EXPECT_GE(errorsAgainst(found->image, exact).psnr, decibels);
        EXPECT_EQ(found->tried.back().predictedDecibels, found->tried.back().decibels) << "chosen by the whole picture";
        EXPECT_EQ(errorsAgainst(found->image, exact).psnr, found->tried.back().decibels);
        const auto again = prepare(scene(240, 180), found->tried.back().setting)->render({});
        EXPECT_EQ(again.pixels, found->image.pixels);
    }
}

TEST(Recommend, WithALongBudgetChoosesTheMostAccurate)
{
    const auto found = recommend(
        scene(48, 36), {.seconds = 3600, .decibels = {}}, [](const std::string&) {}, go);
    ASSERT_TRUE(found && found->kept());
    EXPECT_EQ(found->tried.size(), 1U);
    EXPECT_EQ(found->tried[0].setting.depth, 64);
    EXPECT_EQ(found->tried[0].setting.cutoff, 0);
    EXPECT_EQ(found->tried[0].setting.scalar, Scalar::doubled);
}

TEST(Recommend, SaysWhenThePromiseCannotBeKept)
{
    const auto fast = recommend(
        scene(48, 36), {.seconds = 1e-9, .decibels = {}}, [](const std::string&) {}, go);
    ASSERT_TRUE(fast);
    EXPECT_FALSE(fast->kept());
    const auto exact = recommend(
        scene(48, 36), {.seconds = {}, .decibels = 5000}, [](const std::string&) {}, go);
    ASSERT_TRUE(exact);
    EXPECT_FALSE(exact->kept());
}

TEST(Recommend, AgainstManySamplesItTakesMoreSamples)
{
    const auto found = recommend(
        scene(48, 36), {.seconds = {}, .decibels = 36, .many = true, .manySamples = 128}, [](const std::string&) {},
        go);
    ASSERT_TRUE(found);
    EXPECT_GT(found->tried.back().setting.spp, 1);
}

} // namespace

} // namespace rt::lesson10
