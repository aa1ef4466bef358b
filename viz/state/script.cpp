#include "viz/state/script.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "common/base/interrupt.h"
#include "common/base/nearest_word.h"
#include "common/files/text_file.h"
#include "viz/state/state.h"

namespace rt::viz
{

namespace
{

using Words = std::vector<std::string>;

std::optional<double> numberOf(const std::string& word)
{
    const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
    double number = 0;
    const auto [end, error] = std::from_chars(first, word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || !(std::abs(number) <= 1e9)) return std::nullopt;
    return number;
}

std::optional<int> wholeOf(const std::string& word)
{
    const auto number = numberOf(word);
    return number && *number == std::floor(*number) ? std::optional(int(*number)) : std::nullopt;
}

/// An argument is described by one word: "INT", "NUMBER", "FILE", or "one|of|these".
bool fits(const std::string& argument, const std::string& described)
{
    if (described == "INT") return wholeOf(argument).has_value();
    if (described == "NUMBER") return numberOf(argument).has_value();
    if (described == "FILE" || described == "KEY") return !argument.empty();
    if (described == "STEP") return argument == "first" || argument == "last" || wholeOf(argument).has_value();
    return ("|" + described + "|").find("|" + argument + "|") != std::string::npos;
}

struct CommandKind
{
    const char* name;
    Words arguments;
    const char* help;
    bool inWindow;
    std::function<void(const ScriptHost&, const Words&)> run;
};

int whole(const std::string& word)
{
    return *wholeOf(word);
}

void goTo(Controller& controller, const std::string& step)
{
    if (step == "first") return controller.stepTo(0);
    if (step == "last") return controller.stepTo(controller.lastStep());
    if (step.starts_with('+') || step.starts_with('-')) return controller.stepBy(whole(step));
    if (whole(step) > controller.lastStep())
        throw std::runtime_error(fmt::format("there are {} steps", controller.lastStep()));
    controller.stepTo(whole(step));
}

/// Brings a switch into a state by toggling it or not.
template <class Toggle>
void turn(bool is, const std::string& onOrOff, Toggle&& toggle)
{
    if (is != (onOrOff == "on")) toggle();
}

void selectOrFail(Controller& controller, int id)
{
    if (id < 0 || std::size_t(id) >= controller.tree().nodes.size())
        throw std::runtime_error(
            fmt::format("the tree has no node {}; it has {} nodes, from 0", id, controller.tree().nodes.size()));
    controller.selectNode(id);
}

const std::vector<CommandKind>& commandKinds()
{
    static const std::vector<CommandKind> all{
        {"pick",
         {"INT", "INT"},
         "choose the pixel X Y",
         false,
         [](const ScriptHost& host, const Words& w) {
             const auto& camera = host.controller.scene().camera;
             const int x = whole(w[1]), y = whole(w[2]);
             if (x < 0 || y < 0 || x >= camera.width || y >= camera.height)
                 throw std::runtime_error(
                     fmt::format("the picture has {} x {} pixels, counted from 0", camera.width, camera.height));
             host.controller.choosePixel(x, y);
             host.controller.wait();
         }},
        {"select",
         {"INT"},
         "select node N",
         false,
         [](const ScriptHost& host, const Words& w) { selectOrFail(host.controller, whole(w[1])); }},
        {"next",
         {},
         "select the next node",
         false,
         [](const ScriptHost& host, const Words&) { host.controller.nextNode(); }},
        {"previous",
         {},
         "select the node before",
         false,
         [](const ScriptHost& host, const Words&) { host.controller.previousNode(); }},
        {"parent",
         {},
         "select the node's parent",
         false,
         [](const ScriptHost& host, const Words&) { host.controller.parentNode(); }},
        {"difference",
         {},
         "select where the compared trees first differ",
         false,
         [](const ScriptHost& host, const Words&) { host.controller.selectDifference(); }},
        {"step",
         {"STEP"},
         "go to event N, or by +N or -N events; first: before all of them; last: after",
         false,
         [](const ScriptHost& host, const Words& w) { goTo(host.controller, w[1]); }},
        {"play",
         {},
         "play all events",
         false,
         [](const ScriptHost& host, const Words&) {
             host.controller.setPlaying(true);
             while (host.controller.isPlaying()) host.controller.playOn();
         }},
        {"depth",
         {"INT"},
         "the depth cap: rays deeper than N are not traced",
         false,
         [](const ScriptHost& host, const Words& w) {
             const int depth = whole(w[1]);
             if (depth < 0 || depth > 1024) throw std::runtime_error("expected a depth from 0 to 1024");
             host.controller.setMaxDepth(depth);
             host.controller.wait();
         }},
        {"hide",
         {"NUMBER"},
         "hide rays of less throughput than this share (0 to 1)",
         false,
         [](const ScriptHost& host, const Words& w) {
             const double share = *numberOf(w[1]);
             if (share < 0 || share > 1) throw std::runtime_error("expected a share from 0 to 1");
             host.controller.setWeakest(share);
         }},
        {"kind",
         {"camera|reflected|transmitted|lit|blocked", "on|off"},
         "show or hide a kind of rays",
         false,
         [](const ScriptHost& host, const Words& w) {
             for (int i = 0; i < kinds; ++i)
                 if (w[1] == name(Kind(i)))
                     turn(host.controller.shows(Kind(i)), w[2], [&] { host.controller.toggle(Kind(i)); });
         }},
        {"normals",
         {"on|off"},
         "show or hide the normals",
         false,
         [](const ScriptHost& host, const Words& w) {
             turn(host.controller.showsNormals(), w[1], [&] { host.controller.toggleNormals(); });
         }},
        {"help",
         {"on|off"},
         "show or hide the cheat sheet",
         false,
         [](const ScriptHost& host, const Words& w) {
             turn(host.controller.showsHelp(), w[1], [&] { host.controller.toggleHelp(); });
         }},
        {"look",
         {"dark|light"},
         "dark or light colours",
         false,
         [](const ScriptHost& host, const Words& w) {
             if (w[1] != name(host.controller.look())) host.controller.toggleLook();
         }},
        {"compare",
         {"on|off"},
         "show or hide what --compare has found",
         false,
         [](const ScriptHost& host, const Words& w) {
             turn(host.controller.comparison() != nullptr, w[1], [&] { host.controller.toggleComparison(); });
         }},
        {"state",
         {"FILE"},
         "write the state as JSON",
         false,
         [](const ScriptHost& host, const Words& w) {
             if (host.controller.isRefining()) host.controller.wait(); // as for a picture of the window
             writeTextFile(w[1], stateJson(host.controller));
         }},
        {"export",
         {"FILE"},
         "write a .json, .vtp, .glb, .gltf or .html file, or all of them into a folder",
         false,
         [](const ScriptHost& host, const Words& w) { host.exportTo(w[1]); }},
        {"shot",
         {"FILE"},
         "write a picture of the window",
         true,
         [](const ScriptHost& host, const Words& w) { host.shot(w[1]); }},
        {"key",
         {"KEY"},
         "press a key, named as X11 does: Left, space, bracketleft, n",
         true,
         [](const ScriptHost& host, const Words& w) { host.key(w[1]); }},
        {"click",
         {"INT", "INT"},
         "click at X Y of the window, from its upper left",
         true,
         [](const ScriptHost& host, const Words& w) { host.click(whole(w[1]), whole(w[2])); }},
        {"drag",
         {"INT", "INT", "INT", "INT"},
         "drag from X Y to X Y with the left button",
         true,
         [](const ScriptHost& host, const Words& w) { host.drag(whole(w[1]), whole(w[2]), whole(w[3]), whole(w[4])); }},
        {"hover",
         {"INT", "INT"},
         "move the pointer to X Y",
         true,
         [](const ScriptHost& host, const Words& w) { host.hover(whole(w[1]), whole(w[2])); }},
        {"wheel",
         {"INT", "INT", "in|out"},
         "turn the wheel at X Y",
         true,
         [](const ScriptHost& host, const Words& w) { host.wheel(whole(w[1]), whole(w[2]), w[3] == "in"); }},
        {"resize",
         {"INT", "INT"},
         "the window's width and height",
         true,
         [](const ScriptHost& host, const Words& w) { host.resize(whole(w[1]), whole(w[2])); }},
    };
    return all;
}

std::string usage(const CommandKind& kind)
{
    std::string text = kind.name;
    for (const auto& argument : kind.arguments) text += " " + argument;
    return text;
}

const CommandKind* findKind(const std::string& name)
{
    const auto& all = commandKinds();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& kind) { return name == kind.name; });
    return found == all.end() ? nullptr : &*found;
}

std::string placeOf(const ScriptCommand& command)
{
    return fmt::format("script, command {} (\"{}\"): ", command.number, command.text);
}

/// The commands' texts, split into words.
std::vector<ScriptCommand> split(const std::string& script)
{
    std::vector<ScriptCommand> commands;
    ScriptCommand command;
    std::string word;
    bool quoted = false, comment = false, inWord = false;
    const auto endWord = [&] {
        if (inWord) command.words.push_back(word);
        word.clear();
        inWord = false;
    };
    const auto endCommand = [&] {
        endWord();
        while (!command.text.empty() && command.text.back() == ' ') command.text.pop_back();
        if (!command.words.empty())
        {
            command.number = int(commands.size()) + 1;
            commands.push_back(command);
        }
        command = {};
    };
    for (const char c : script)
    {
        if (c == '\n') comment = false;
        if (comment) continue;
        if (c == '"')
        {
            quoted = !quoted;
            inWord = true;
        }
        else if (!quoted && c == '#')
        {
            comment = true;
            continue;
        }
        else if (!quoted && (c == ';' || c == '\n'))
        {
            endCommand();
            continue;
        }
        else if (!quoted && (c == ' ' || c == '\t' || c == '\r'))
            endWord();
        else
        {
            word += c;
            inWord = true;
        }
        if (!command.text.empty() || (c != ' ' && c != '\t' && c != '\r')) command.text += c;
    }
    if (quoted) throw std::runtime_error(fmt::format("script: a quote is not closed in \"{}\"", command.text));
    endCommand();
    return commands;
}

} // namespace

std::vector<ScriptCommand> parseScript(const std::string& script)
{
    auto commands = split(script);
    for (const auto& command : commands)
    {
        const auto* kind = findKind(command.words[0]);
        if (!kind)
        {
            std::vector<std::string_view> known;
            for (const auto& each : commandKinds()) known.emplace_back(each.name);
            const auto meant = nearestWord(command.words[0], known);
            throw std::runtime_error(
                placeOf(command) + "there is no such command" +
                (meant.empty() ? "; --help lists them" : fmt::format("; did you mean \"{}\"?", meant)));
        }
        bool right = command.words.size() == kind->arguments.size() + 1;
        for (std::size_t i = 0; right && i < kind->arguments.size(); ++i)
            right = fits(command.words[i + 1], kind->arguments[i]);
        if (!right) throw std::runtime_error(placeOf(command) + "expected " + usage(*kind));
    }
    return commands;
}

std::string scriptHelp()
{
    std::string text;
    for (const auto& kind : commandKinds()) text += fmt::format("  {:<34} {}\n", usage(kind), kind.help);
    return text;
}

bool needsWindow(const std::vector<ScriptCommand>& commands)
{
    return std::any_of(commands.begin(), commands.end(),
                       [](const auto& command) { return findKind(command.words[0])->inWindow; });
}

void runScript(const std::vector<ScriptCommand>& commands, const ScriptHost& host)
{
    for (const auto& command : commands)
    {
        try
        {
            if (interrupted()) throw Stopped(); // what is not whole is neither shown nor written
            findKind(command.words[0])->run(host, command.words);
        }
        catch (const Stopped&)
        {
            throw;
        }
        catch (const std::exception& error)
        {
            throw std::runtime_error(placeOf(command) + error.what());
        }
    }
}

} // namespace rt::viz
