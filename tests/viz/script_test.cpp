#include "viz/state/script.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/files/scene_file.h"
#include "common/files/text_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/state/state.h"

namespace rt::viz
{

namespace
{

Session session()
{
    Session chosen;
    chosen.scene = loadScene(projectFile(findLesson(6)->scene));
    chosen.source = lessonSource(*findLesson(6), Precision::doubled);
    chosen.source.render = nullptr; // only the trees count here
    chosen.probe = chosen.scene.pixel();
    return chosen;
}

std::string errorOf(const std::string& script)
{
    try
    {
        parseScript(script);
    }
    catch (const std::exception& error)
    {
        return error.what();
    }
    return "";
}

nlohmann::json stateAfter(const std::string& script)
{
    Controller controller(session());
    runScript(parseScript(script), {.controller = controller});
    return nlohmann::json::parse(stateJson(controller));
}

TEST(Script, CommandsStandBetweenSemicolonsAndLineEnds)
{
    const auto commands = parseScript("pick 3 4; # the first\n  step +2 ;;\nstate \"a file.json\"\n");
    ASSERT_EQ(commands.size(), 3U);
    EXPECT_EQ(commands[0].words, (std::vector<std::string>{"pick", "3", "4"}));
    EXPECT_EQ(commands[1].words, (std::vector<std::string>{"step", "+2"}));
    EXPECT_EQ(commands[1].text, "step +2");
    EXPECT_EQ(commands[2].words, (std::vector<std::string>{"state", "a file.json"}));
    EXPECT_EQ(commands[2].number, 3);
    EXPECT_TRUE(parseScript(" ;\n # nothing").empty());
}

TEST(Script, AMistakeIsNamedBeforeAnythingRuns)
{
    EXPECT_EQ(errorOf("next; selct 4"),
              "script, command 2 (\"selct 4\"): there is no such command; did you mean \"select\"?");
    EXPECT_EQ(errorOf("pick 3"), "script, command 1 (\"pick 3\"): expected pick INT INT");
    EXPECT_EQ(errorOf("pick 3 four"), "script, command 1 (\"pick 3 four\"): expected pick INT INT");
    EXPECT_EQ(errorOf("kind red on"),
              "script, command 1 (\"kind red on\"): expected kind camera|reflected|transmitted|lit|blocked on|off");
    EXPECT_EQ(errorOf("hide nan"), "script, command 1 (\"hide nan\"): expected hide NUMBER");
    EXPECT_EQ(errorOf("depth 1e99"), "script, command 1 (\"depth 1e99\"): expected depth INT");
    EXPECT_EQ(errorOf("step 1.5"), "script, command 1 (\"step 1.5\"): expected step STEP");
    EXPECT_NE(errorOf("state \"x"), "");
    EXPECT_EQ(errorOf("step first; step last; step -3; step 7"), "");
}

TEST(Script, OnlyWhatIsSeenNeedsAWindow)
{
    EXPECT_FALSE(needsWindow(parseScript("pick 1 1; step 3; depth 2; state x; export y")));
    EXPECT_TRUE(needsWindow(parseScript("next; shot x.png")));
    EXPECT_TRUE(needsWindow(parseScript("key Left")));
}

TEST(Script, DrivesTheControllerToTheStateThatItSays)
{
    const auto whole = stateAfter("");
    EXPECT_EQ(whole["step"], whole["last_step"]);
    EXPECT_TRUE(whole["event"].is_null());
    ASSERT_GT(whole["nodes"], 4);

    const auto state = stateAfter("pick 10 20; depth 3; look light; normals off; kind lit off; help on");
    EXPECT_EQ(state["pixel"], (nlohmann::json{10, 20}));
    EXPECT_EQ(state["max_depth"], 3);
    EXPECT_EQ(state["look"], "light");
    EXPECT_EQ(state["normals"], false);
    EXPECT_EQ(state["kinds"]["lit"], false);
    EXPECT_EQ(state["kinds"]["blocked"], true);
    EXPECT_EQ(state["help"], true);
}

TEST(State, HasTheRadianceOfThePixel)
{
    const Controller controller(session());
    const auto state = nlohmann::json::parse(stateJson(controller));
    const auto& radiance = controller.tree().nodes.at(0).radiance;
    EXPECT_EQ(state["radiance"], (nlohmann::json{radiance.x, radiance.y, radiance.z}));
}

TEST(Script, StepsAndSelects)
{
    const auto stepped = stateAfter("step first; step +3; step -1");
    EXPECT_EQ(stepped["step"], 2);
    EXPECT_FALSE(stepped["event"].is_null());
    EXPECT_LT(stepped["shown_nodes"].size(), stepped["nodes"]);
    EXPECT_EQ(stateAfter("step 4")["step"], 4);
    const auto selected = stateAfter("select 3; previous");
    EXPECT_EQ(selected["selected"], 2);
    EXPECT_EQ(stateAfter("select 1; parent")["selected"], 0);
    const auto played = stateAfter("step 2; play");
    EXPECT_EQ(played["step"], played["last_step"]);
    EXPECT_EQ(played["playing"], false);
    EXPECT_EQ(stateAfter("hide 1")["shown_nodes"], nlohmann::json{0});
}

TEST(Script, StopsAtTheFirstCommandThatFails)
{
    Controller controller(session());
    try
    {
        runScript(parseScript("select 1; select 5000; select 2"), {.controller = controller});
        FAIL() << "node 5000 was selected";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_EQ(std::string(error.what()).find("script, command 2 (\"select 5000\"): the tree has no node 5000"), 0U)
            << error.what();
    }
    EXPECT_EQ(controller.selected(), 1);
    EXPECT_THROW(runScript(parseScript("pick 100000 1"), {.controller = controller}), std::runtime_error);
}

TEST(Script, WritesTheStateToAFile)
{
    Controller controller(session());
    const auto file = std::filesystem::path(testing::TempDir()) / "script_state.json";
    runScript(parseScript("step 5; state " + file.string()), {.controller = controller});
    const auto state = nlohmann::json::parse(readTextFile(file.string()));
    EXPECT_EQ(state["step"], 5);
    EXPECT_EQ(state["message"], "");
    std::filesystem::remove(file);
}

} // namespace

} // namespace rt::viz
