#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/ray_tree.h"

namespace rt
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr std::size_t largestJson = std::size_t(64) << 20;
constexpr std::size_t mostNodes = std::size_t(1) << 20;

Json number(double x)
{
    return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json triple(const Vec3<double>& v)
{
    return Json::array({number(v.x), number(v.y), number(v.z)});
}

Json orNull(const std::optional<double>& x)
{
    return x ? number(*x) : Json(nullptr);
}

Json endOf(End end)
{
    return end == End::none ? Json(nullptr) : Json(name(end));
}

Json nodeJson(const RayTree::Node& node)
{
    Json hit = nullptr;
    if (node.hit)
        hit = {{"t", number(node.hit->t)},           {"point", triple(node.hit->point)},
               {"normal", triple(node.hit->normal)}, {"primitive", node.hit->primitive},
               {"material", node.hit->material},     {"inside", node.hit->inside},
               {"color", triple(node.hit->color)}};
    return {{"id", node.id},
            {"parent", node.parent},
            {"kind", name(node.kind)},
            {"depth", node.depth},
            {"origin", triple(node.origin)},
            {"direction", triple(node.direction)},
            {"hit", hit},
            {"n1", orNull(node.n1)},
            {"n2", orNull(node.n2)},
            {"fresnel", orNull(node.fresnel)},
            {"weight", number(node.weight)},
            {"throughput", triple(node.throughput)},
            {"radiance", triple(node.radiance)},
            {"own", triple(node.own)},
            {"contribution", triple(node.contribution)},
            {"end", endOf(node.end)},
            {"tir", node.tir},
            {"orphan", node.orphan},
            {"line", node.line},
            {"return_line", node.returnLine},
            {"step", node.step},
            {"return_step", node.returnStep}};
}

Json shadowJson(const RayTree::Shadow& shadow)
{
    Json blocker = nullptr;
    if (shadow.blocker) blocker = {{"primitive", shadow.blocker->primitive}, {"point", triple(shadow.blocker->point)}};
    return {{"node", shadow.node},
            {"light", shadow.light},
            {"direction", triple(shadow.direction)},
            {"distance", number(shadow.distance)},
            {"visible", shadow.visible},
            {"tint", triple(shadow.tint)},
            {"blocker", blocker},
            {"line", shadow.line},
            {"step", shadow.step}};
}

Json cappedJson(const RayTree::Capped& capped)
{
    return {{"node", capped.node},
            {"kind", name(capped.kind)},
            {"direction", triple(capped.direction)},
            {"weight", number(capped.weight)},
            {"radiance", triple(capped.radiance)},
            {"reason", name(capped.reason)},
            {"line", capped.line},
            {"step", capped.step}};
}

/// Reads one object of the file; every message names the place, as in "nodes[3].hit.t".
class Reader
{
public:
    Reader(const Json& source, std::string where) : json(source), place(std::move(where))
    {
        if (!json.is_object()) fail("expected an object");
    }

    bool has(const char* key) const { return json.contains(key) && !json[key].is_null(); }

    const Json& at(const char* key) const
    {
        if (!json.contains(key)) fail(fmt::format("the key \"{}\" is missing", key));
        return json[key];
    }

    double real(const char* key) const
    {
        const auto& value = at(key);
        if (!value.is_number() || !std::isfinite(value.get<double>())) fail(key, "a finite number");
        return value.get<double>();
    }

    int integer(const char* key, int least, int most) const
    {
        const auto& value = at(key);
        if (!value.is_number_integer() || value.get<long long>() < least || value.get<long long>() > most)
            fail(key, fmt::format("a whole number from {} to {}", least, most));
        return value.get<int>();
    }

    bool boolean(const char* key) const
    {
        if (!at(key).is_boolean()) fail(key, "true or false");
        return at(key).get<bool>();
    }

    std::string string(const char* key) const
    {
        if (!at(key).is_string()) fail(key, "a string");
        return at(key).get<std::string>();
    }

    Vec3<double> triple(const char* key) const
    {
        const auto& value = at(key);
        Vec3<double> v(0);
        if (!value.is_array() || value.size() != 3) fail(key, "an array of 3 numbers");
        for (std::size_t i = 0; i < 3; ++i)
        {
            if (!value[i].is_number() || !std::isfinite(value[i].get<double>()))
                fail(key, "an array of 3 finite numbers");
            v[int(i)] = value[i].get<double>();
        }
        return v;
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
    const Json& json;
    std::string place;
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
    if (in.has("line")) node.line = in.integer("line", 0, 1 << 30);
    if (in.has("return_line")) node.returnLine = in.integer("return_line", 0, 1 << 30);
    if (in.has("step")) node.step = in.integer("step", 0, 1 << 30);
    if (in.has("return_step")) node.returnStep = in.integer("return_step", 0, 1 << 30);
    return node;
}

RayTree::Shadow readShadow(const Reader& in, int nodes)
{
    RayTree::Shadow shadow;
    shadow.node = in.integer("node", 0, nodes - 1);
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

RayTree::Capped readCapped(const Reader& in, int nodes)
{
    RayTree::Capped capped;
    capped.node = in.integer("node", 0, nodes - 1);
    capped.kind = in.choice("kind", {RayKind::camera, RayKind::reflected, RayKind::transmitted});
    capped.direction = in.triple("direction");
    capped.weight = in.real("weight");
    capped.radiance = in.triple("radiance");
    capped.reason = in.choice("reason", {End::cap, End::cutoff});
    if (in.has("line")) capped.line = in.integer("line", 0, 1 << 30);
    if (in.has("step")) capped.step = in.integer("step", 0, 1 << 30);
    return capped;
}

template <class Item, class Read>
std::vector<Item> readArray(const Json& json, const char* key, Read&& read)
{
    if (!json.is_array()) throw std::runtime_error(fmt::format("{}: expected an array", key));
    if (json.size() > mostNodes)
        throw std::runtime_error(fmt::format("{}: {} entries, at most {} are read", key, json.size(), mostNodes));
    std::vector<Item> items;
    items.reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i)
        items.push_back(read(Reader(json[i], fmt::format("{}[{}]", key, i)), int(i)));
    return items;
}

} // namespace

std::string toJson(const RayTree& tree)
{
    Json json = {{"version", tree.version}, {"lesson", tree.lesson}, {"scene", tree.scene}, {"source", tree.source}, {"real", tree.real}};
    if (tree.pixel)
        json["pixel"] = *tree.pixel;
    else if (!tree.nodes.empty())
        json["ray"] = {{"origin", triple(tree.nodes[0].origin)}, {"direction", triple(tree.nodes[0].direction)}};
    json["max_depth"] = tree.maxDepth;
    json["nodes"] = Json::array();
    for (const auto& node : tree.nodes) json["nodes"].push_back(nodeJson(node));
    json["shadows"] = Json::array();
    for (const auto& shadow : tree.shadows) json["shadows"].push_back(shadowJson(shadow));
    json["capped"] = Json::array();
    for (const auto& capped : tree.capped) json["capped"].push_back(cappedJson(capped));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

RayTree rayTreeFromJson(const std::string& text)
{
    if (text.size() > largestJson)
        throw std::runtime_error(fmt::format("{} bytes of JSON, at most {} are read", text.size(), largestJson));
    Json json;
    try
    {
        json = Json::parse(text);
    }
    catch (const Json::exception& error)
    {
        throw std::runtime_error(fmt::format("not JSON: {}", error.what()));
    }
    const Reader in(json, "tree");
    RayTree tree;
    tree.version = in.integer("version", 1, 1);
    if (in.has("lesson")) tree.lesson = in.integer("lesson", 0, 99);
    if (in.has("scene")) tree.scene = in.string("scene");
    if (in.has("source")) tree.source = in.string("source");
    if (in.has("real")) tree.real = in.string("real");
    if (in.has("pixel"))
    {
        const auto& pixel = json["pixel"];
        if (!pixel.is_array() || pixel.size() != 2 || !pixel[0].is_number_integer() || !pixel[1].is_number_integer())
            in.fail("pixel", "an array of 2 whole numbers");
        tree.pixel = {pixel[0].get<int>(), pixel[1].get<int>()};
    }
    if (in.has("max_depth")) tree.maxDepth = in.integer("max_depth", 0, 1 << 20);
    tree.nodes = readArray<RayTree::Node>(in.at("nodes"), "nodes", readNode);
    const int nodes = int(tree.nodes.size());
    tree.shadows = readArray<RayTree::Shadow>(in.at("shadows"), "shadows",
                                              [&](const Reader& entry, int) { return readShadow(entry, nodes); });
    if (in.has("capped"))
        tree.capped = readArray<RayTree::Capped>(json["capped"], "capped",
                                                 [&](const Reader& entry, int) { return readCapped(entry, nodes); });
    return tree;
}

} // namespace rt
