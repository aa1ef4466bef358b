#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/tree/ray_tree.h"

namespace rt
{

namespace
{

using Parsed = nlohmann::json;

constexpr std::size_t largestJson = std::size_t(64) << 20;
constexpr std::size_t mostEntries = std::size_t(1) << 20; // of nodes, of shadows, of capped
constexpr std::size_t longestString = 4096;               // bytes; names and paths
constexpr int deepest = 64;                               // arrays and objects in one another; we write 4
constexpr int mostValues = 200;                           // of one entry, keys that we do not know left out

/// Reads one object of the file; every message names the place, as in "nodes[3].hit.t".
class Reader
{
public:
    Reader(const Parsed& source, std::string where) : json(source), place(std::move(where))
    {
        if (!json.is_object()) fail("expected an object");
    }

    bool has(const char* key) const { return json.contains(key) && !json[key].is_null(); }

    const Parsed& at(const char* key) const
    {
        if (!json.contains(key)) fail(fmt::format("the key \"{}\" is missing", key));
        return json[key];
    }

    /// null is NaN: JSON has no word for a number that is not finite.
    double real(const char* key) const
    {
        const auto& value = at(key);
        if (!isReal(value)) fail(key, "a number, or null for one that is not finite");
        return asReal(value);
    }

    int integer(const char* key, int least, int most) const
    {
        const auto& value = at(key);
        if (!isInteger(value, least, most)) fail(key, fmt::format("a whole number from {} to {}", least, most));
        return value.get<int>();
    }

    std::array<int, 2> integers(const char* key, int least, int most) const
    {
        const auto& value = at(key);
        if (!value.is_array() || value.size() != 2 || !isInteger(value[0], least, most) ||
            !isInteger(value[1], least, most))
            fail(key, fmt::format("an array of 2 whole numbers from {} to {}", least, most));
        return {value[0].get<int>(), value[1].get<int>()};
    }

    bool boolean(const char* key) const
    {
        if (!at(key).is_boolean()) fail(key, "true or false");
        return at(key).get<bool>();
    }

    std::string string(const char* key) const
    {
        if (!at(key).is_string()) fail(key, "a string");
        const auto& text = at(key).get_ref<const std::string&>();
        if (text.size() > longestString || text.find('\0') != std::string::npos)
            fail(key, fmt::format("at most {} bytes, none of them zero", longestString));
        return text;
    }

    Vec3<double> triple(const char* key) const
    {
        const auto& value = at(key);
        if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), isReal))
            fail(key, "an array of 3 numbers, or null for those that are not finite");
        return {asReal(value[0]), asReal(value[1]), asReal(value[2])};
    }

    template <class Enum>
    Enum choice(const char* key, std::initializer_list<Enum> values) const
    {
        const auto word = string(key);
        std::string known;
        for (const auto value : values)
        {
            if (word == name(value)) return value;
            known += (known.empty() ? "" : ", ") + std::string(name(value));
        }
        fail(key, "one of " + known);
    }

    Reader object(const char* key) const { return {at(key), place + "." + key}; }

    [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(place + ": " + what); }
    [[noreturn]] void fail(const char* key, const std::string& expected) const
    {
        throw std::runtime_error(place + "." + key + ": expected " + expected);
    }

private:
    const Parsed& json;
    std::string place;

    static bool isReal(const Parsed& value) { return value.is_number() || value.is_null(); }
    static double asReal(const Parsed& value)
    {
        return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
    }
    /// 2.0 is whole, too, as in JSON Schema. As double, so that 2^64 - 1 does not come out as -1.
    static bool isInteger(const Parsed& value, int least, int most)
    {
        return value.is_number() && value.get<double>() >= least && value.get<double>() <= most &&
               value.get<double>() == std::floor(value.get<double>());
    }
};

RayTree::Hit readHit(const Reader& in)
{
    RayTree::Hit hit;
    hit.t = in.real("t");
    hit.point = in.triple("point");
    hit.normal = in.triple("normal");
    hit.primitive = in.string("primitive");
    hit.material = in.string("material");
    hit.inside = in.boolean("inside");
    if (in.has("color")) hit.color = in.triple("color");
    return hit;
}

/// Where `own` is not given it is what the children do not explain: see inferOwn.
RayTree::Node readNode(const Reader& in, int id)
{
    RayTree::Node node;
    node.id = in.integer("id", id, id);
    node.parent = in.integer("parent", -1, id - 1);
    node.kind = in.choice("kind", {RayKind::camera, RayKind::reflected, RayKind::transmitted});
    node.depth = in.integer("depth", 0, 1 << 20);
    node.origin = in.triple("origin");
    node.direction = in.triple("direction");
    if (in.has("hit")) node.hit = readHit(in.object("hit"));
    if (in.has("n1")) node.n1 = in.real("n1");
    if (in.has("n2")) node.n2 = in.real("n2");
    if (in.has("fresnel")) node.fresnel = in.real("fresnel");
    node.weight = in.real("weight");
    node.throughput = in.triple("throughput");
    node.radiance = in.triple("radiance");
    node.contribution = in.triple("contribution");
    if (in.has("own")) node.own = in.triple("own");
    if (in.has("end")) node.end = in.choice("end", {End::absorbed, End::miss, End::cap, End::cutoff, End::black});
    if (in.has("tir")) node.tir = in.boolean("tir");
    if (in.has("orphan")) node.orphan = in.boolean("orphan");
    if (node.parent < 0 && id > 0) node.orphan = true;
    if (in.has("line")) node.line = in.integer("line", 0, 1 << 30);
    if (in.has("return_line")) node.returnLine = in.integer("return_line", 0, 1 << 30);
    if (in.has("step")) node.step = in.integer("step", 0, 1 << 30);
    if (in.has("return_step")) node.returnStep = in.integer("return_step", 0, 1 << 30);
    return node;
}

/// The nodes may stand further down in the file: that `node` is one of them is checked at the end.
RayTree::Shadow readShadow(const Reader& in)
{
    RayTree::Shadow shadow;
    shadow.node = in.integer("node", 0, 1 << 30);
    shadow.light = in.integer("light", 0, 1 << 30);
    shadow.direction = in.triple("direction");
    shadow.distance = in.real("distance");
    shadow.visible = in.boolean("visible");
    if (in.has("tint")) shadow.tint = in.triple("tint");
    if (in.has("blocker"))
    {
        const auto blocker = in.object("blocker");
        shadow.blocker = {blocker.string("primitive"), blocker.triple("point")};
    }
    if (in.has("line")) shadow.line = in.integer("line", 0, 1 << 30);
    if (in.has("step")) shadow.step = in.integer("step", 0, 1 << 30);
    return shadow;
}

RayTree::Capped readCapped(const Reader& in)
{
    RayTree::Capped capped;
    capped.node = in.integer("node", 0, 1 << 30);
    capped.kind = in.choice("kind", {RayKind::camera, RayKind::reflected, RayKind::transmitted});
    capped.direction = in.triple("direction");
    capped.weight = in.real("weight");
    capped.radiance = in.triple("radiance");
    capped.reason = in.choice("reason", {End::cap, End::cutoff});
    if (in.has("line")) capped.line = in.integer("line", 0, 1 << 30);
    if (in.has("step")) capped.step = in.integer("step", 0, 1 << 30);
    return capped;
}

void addKeys(std::set<std::string>& keys, const Parsed& json)
{
    for (const auto& [key, value] : json.items())
    {
        keys.insert(key);
        if (value.is_object()) addKeys(keys, value);
    }
}

/// All keys of nodes, shadow rays and rays not followed: what is read is what is written.
const std::set<std::string>& knownKeys()
{
    static const auto keys = [] {
        RayTree tree;
        tree.nodes.emplace_back().hit.emplace();
        tree.shadows.emplace_back().blocker.emplace();
        tree.capped.emplace_back();
        const auto written = Parsed::parse(toJson(tree));
        std::set<std::string> found;
        for (const char* list : {"nodes", "shadows", "capped"}) addKeys(found, written[list][0]);
        return found;
    }();
    return keys;
}

/// Builds the tree while the text is parsed. Only one entry at a time exists as JSON, and nothing of what we do not know: a
/// hostile text of 64 MiB would otherwise take 2 GiB.
class TreeBuilder
{
public:
    RayTree tree;

    /// To be called by the parser; false: this part is not kept. Throws std::runtime_error.
    bool operator()(int depth, Parsed::parse_event_t event, Parsed& parsed)
    {
        using Event = Parsed::parse_event_t;
        if (depth > deepest) fail(fmt::format("arrays and objects are more than {} deep in one another", deepest));
        if (depth > skipped) return false;
        skipped = deepest;
        switch (event)
        {
        case Event::key:
            keyDepth = depth;
            return keyKnown = depth == 1 ? enter(parsed.get_ref<const std::string&>())
                                         : knownKeys().count(parsed.get_ref<const std::string&>()) > 0;
        case Event::object_start:
        case Event::array_start:
            if (keyDepth == depth && !keyKnown)
            {
                skipped = depth;
                return false;
            }
            begin(depth, event == Event::object_start ? What::object : What::array);
            return true;
        case Event::value:
            if (keyDepth != depth || keyKnown) begin(depth, parsed.is_null() ? What::null : What::value);
            return true;
        case Event::object_end:
            if (depth != 2 || !inList()) return true;
            add(parsed);
            return false;
        case Event::array_end:
            return true;
        }
        return true;
    }

    /// Reads the rest, now that all of the text is there.
    void finish(const Parsed& json)
    {
        const Reader in(json, "tree");
        tree.version = in.integer("version", 1, 1);
        if (in.has("lesson")) tree.lesson = in.integer("lesson", 0, 99);
        if (in.has("scene")) tree.scene = in.string("scene");
        if (in.has("source")) tree.source = in.string("source");
        if (in.has("real")) tree.real = in.string("real");
        if (in.has("pixel")) tree.pixel = in.integers("pixel", -(1 << 30), 1 << 30);
        if (in.has("max_depth")) tree.maxDepth = in.integer("max_depth", 0, 1 << 20);
        in.at("nodes");
        in.at("shadows");
        checkNodes("shadows", tree.shadows);
        checkNodes("capped", tree.capped);
        inferOwn();
    }

    /// Where in the text the parser is.
    std::string place() const
    {
        if (!inList()) return section.empty() ? "tree" : "tree." + section;
        return inEntry ? fmt::format("{}[{}]", section, count()) : section;
    }

private:
    std::string section; // the key at the top that is being read
    std::set<std::string> seen;
    bool inEntry = false;
    int values = 0;        // in this entry, or at the top
    int skipped = deepest; // what is deeper is of no interest
    int keyDepth = -1;     // of the last key
    bool keyKnown = false;
    std::vector<bool> hasOwn; // of each node

    [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(place() + ": " + what); }

    bool inList() const { return section == "nodes" || section == "shadows" || section == "capped"; }

    std::size_t count() const
    {
        if (section == "nodes") return tree.nodes.size();
        return section == "shadows" ? tree.shadows.size() : tree.capped.size();
    }

    /// A key at the top; false if it is none of ours.
    bool enter(const std::string& key)
    {
        static const std::set<std::string> known{"version", "lesson", "scene",   "source", "real",
                                                 "pixel",   "nodes",  "shadows", "capped", "max_depth"};
        inEntry = false;
        const bool ours = known.count(key) > 0;
        section = ours ? key : "";
        if (ours && !seen.insert(key).second) fail("is there twice");
        return ours;
    }

    enum class What
    {
        object,
        array,
        null,
        value
    };

    /// Something that is kept begins.
    void begin(int depth, What what)
    {
        if (depth == 0 && what != What::object) fail("expected an object");
        if (depth == 1 && inList() && what != What::array && !(section == "capped" && what == What::null))
            fail("expected an array");
        if (depth == 2 && inList())
        {
            inEntry = true;
            if (what != What::object) fail("expected an object");
            if (count() == mostEntries) fail(fmt::format("at most {} entries are read", mostEntries));
            values = 0;
        }
        if (++values > mostValues) fail(fmt::format("holds more than {} values", mostValues));
    }

    void add(const Parsed& entry)
    {
        const Reader in(entry, place());
        if (section == "nodes")
        {
            tree.nodes.push_back(readNode(in, int(count())));
            hasOwn.push_back(in.has("own"));
        }
        else if (section == "shadows")
            tree.shadows.push_back(readShadow(in));
        else
            tree.capped.push_back(readCapped(in));
        inEntry = false;
    }

    template <class Item>
    void checkNodes(const char* key, const std::vector<Item>& items) const
    {
        for (std::size_t i = 0; i < items.size(); ++i)
            if (std::size_t(items[i].node) >= tree.nodes.size())
                throw std::runtime_error(fmt::format("{}[{}].node: there is no node {}", key, i, items[i].node));
    }

    /// A tracer need not tell `own`: it is the radiance without what came from children and stand-ins.
    void inferOwn()
    {
        std::vector<Vec3<double>> brought(tree.nodes.size(), Vec3<double>(0));
        const auto bring = [&](int parent, double weight, const Vec3<double>& radiance) {
            const auto& hit = tree.nodes[std::size_t(parent)].hit;
            brought[std::size_t(parent)] += weight * ((hit ? hit->color : Vec3<double>(1)) * radiance);
        };
        for (const auto& node : tree.nodes)
            if (node.parent >= 0) bring(node.parent, node.weight, node.radiance);
        for (const auto& capped : tree.capped) bring(capped.node, capped.weight, capped.radiance);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            if (!hasOwn[i]) tree.nodes[i].own = tree.nodes[i].radiance - brought[i];
    }
};

/// "line 3, column 7: the text ends too early".
std::string syntaxError(const std::string& text, const Parsed::parse_error& error)
{
    const std::size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto lines = std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
    const auto start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const auto where =
        fmt::format("line {}, column {}", lines + 1, at - (start == std::string::npos ? 0 : start + 1) + 1);
    if (at == text.size()) return where + ": the text ends too early";
    constexpr std::size_t shown = 20;
    std::string excerpt;
    for (const char c : text.substr(at, shown))
        if (c >= ' ' && c <= '~')
            excerpt += c;
        else
            break;
    return where + (excerpt.empty() ? ": unexpected byte" : ": unexpected " + excerpt);
}

bool isWordOfCode(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// JSON has no word for a number that is not finite. Python, JavaScript and printf write one all the same, just where a tree is
/// worth looking at: it becomes null, which is what we write.
std::string withNullForNotFinite(const std::string& text)
{
    std::string out;
    std::size_t copied = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] == '"') inString = !inString;
        if (inString && text[i] == '\\') ++i; // and what is escaped
        if (inString || !std::strchr("NnIi-", text[i]) || (i > 0 && isWordOfCode(text[i - 1]))) continue;
        for (const std::string_view word : {"NaN", "-NaN", "nan", "-nan", "Infinity", "-Infinity", "inf", "-inf"})
            if (const auto end = i + word.size();
                text.compare(i, word.size(), word) == 0 && (end == text.size() || !isWordOfCode(text[end])))
            {
                out.append(text, copied, i - copied).append("null");
                copied = end;
                i = end - 1;
                break;
            }
    }
    return copied == 0 ? text : out.append(text, copied);
}

} // namespace

RayTree rayTreeFromJson(const std::string& source)
{
    if (source.size() > largestJson)
        throw std::runtime_error(fmt::format("{} bytes of JSON, at most {} are read", source.size(), largestJson));
    // The parser takes a zero byte for the end and would not look at what follows.
    if (const auto zero = source.find('\0'); zero != std::string::npos)
        throw std::runtime_error(fmt::format("not JSON: byte {} is zero", zero));
    const std::string text = withNullForNotFinite(source);
    TreeBuilder builder;
    try
    {
        const auto json = Parsed::parse(text, std::ref(builder));
        builder.finish(json);
    }
    catch (const Parsed::parse_error& error)
    {
        throw std::runtime_error("not JSON: " + syntaxError(text, error));
    }
    catch (const Parsed::out_of_range&)
    {
        throw std::runtime_error(builder.place() + ": a number is larger than a double can be");
    }
    return std::move(builder.tree);
}

} // namespace rt
