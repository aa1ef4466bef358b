#include "viz/export/export_vtp.h"

#include <bit>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "common/files/base64.h"
#include "viz/drawing/rays.h"

namespace rt::viz
{

namespace
{

static_assert(std::endian::native == std::endian::little, "the file says byte_order=\"LittleEndian\"");

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int shadowKind = 3;

/// Numbers in base64 rather than as text: every double comes back with its bits, NaN too, which VTK cannot read from text.
struct Array
{
    std::string type, name;
    int components = 1;
    std::string bytes{};

    template <class Value>
    void add(const Value& value)
    {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    /// Strings end with a zero, so they cannot hold one.
    void add(const std::string& text) { bytes += text.substr(0, text.find('\0')) + '\0'; }

    std::string xml(std::size_t count) const
    {
        const std::uint64_t size = bytes.size();
        std::string data(reinterpret_cast<const char*>(&size), sizeof size);
        return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"binary\">\n{}\n"
                           "</DataArray>\n",
                           type, name, components, type == "String" ? fmt::format(" NumberOfTuples=\"{}\"", count) : "",
                           base64(data + bytes));
    }
};

struct Table
{
    std::vector<Array> arrays{};
    std::vector<vec3> points{}; ///< two a cell
    std::size_t column = 0;

    std::size_t cells() const { return points.size() / 2; }

    /// The next array of this cell: all cells name theirs in the same order.
    template <class Value>
    void put(const char* name, const Value& value)
    {
        constexpr bool isInt = std::is_same_v<Value, int>, isText = std::is_convertible_v<Value, std::string>;
        if (column == arrays.size())
            arrays.push_back({isInt    ? "Int32"
                              : isText ? "String"
                                       : "Float64",
                              name, std::is_same_v<Value, vec3> ? 3 : 1});
        if constexpr (isText)
            arrays[column++].add(std::string(value));
        else
            arrays[column++].add(value);
    }

    bool begin(const vec3& from, const vec3& to)
    {
        if (!isFinite(from) || !isFinite(to)) return false;
        points.push_back(from);
        points.push_back(to);
        column = 0;
        return true;
    }
};

/// Where the ray is drawn to: the hit point, or a little beyond the scene.
vec3 endOf(const RayTree::Node& ray, const SceneDescription& scene, const Extent& objects)
{
    if (ray.hit) return ray.hit->point;
    RayTree alone;
    alone.nodes.emplace_back();
    alone.nodes[0].origin = ray.origin;
    alone.nodes[0].direction = ray.direction;
    const auto drawing = drawRays(alone, scene, objects);
    return drawing.segments.empty() ? vec3(none) : drawing.segments[0].to;
}

void addRay(Table& table, const RayTree::Node& ray, const vec3& end)
{
    if (!table.begin(ray.origin, end)) return;
    table.put("id", ray.id);
    table.put("parent", ray.parent);
    table.put("kind", int(ray.kind));
    table.put("kind_name", name(ray.kind));
    table.put("depth", ray.depth);
    table.put("weight", ray.weight);
    table.put("throughput", ray.throughput);
    table.put("radiance", ray.radiance);
    table.put("own", ray.own);
    table.put("contribution", ray.contribution);
    table.put("t", ray.hit ? ray.hit->t : none);
    table.put("n1", ray.n1.value_or(none));
    table.put("n2", ray.n2.value_or(none));
    table.put("fresnel", ray.fresnel.value_or(none));
    table.put("end", name(ray.end));
    table.put("tir", int(ray.tir));
    table.put("inside", int(ray.hit && ray.hit->inside));
    table.put("primitive", ray.hit ? ray.hit->primitive : "");
    table.put("material", ray.hit ? ray.hit->material : "");
    table.put("line", ray.line);
    table.put("shadow", -1);
    table.put("light", -1);
    table.put("visible", -1);
    table.put("distance", none);
    table.put("tint", vec3(none));
}

void addShadow(Table& table, const RayTree& tree, int index)
{
    const auto& shadow = tree.shadows[std::size_t(index)];
    if (shadow.node < 0 || std::size_t(shadow.node) >= tree.nodes.size()) return;
    const auto& from = tree.nodes[std::size_t(shadow.node)];
    if (!from.hit) return;
    const vec3 I = from.hit->point, light = I + shadow.distance * shadow.direction;
    if (!table.begin(I, !shadow.visible && shadow.blocker ? shadow.blocker->point : light)) return;
    table.put("id", -1);
    table.put("parent", shadow.node);
    table.put("kind", shadowKind);
    table.put("kind_name", "shadow");
    table.put("depth", from.depth);
    table.put("weight", none);
    for (const char* name : {"throughput", "radiance", "own", "contribution"}) table.put(name, vec3(none));
    for (const char* name : {"t", "n1", "n2", "fresnel"}) table.put(name, none);
    table.put("end", "");
    table.put("tir", 0);
    table.put("inside", 0);
    table.put("primitive", shadow.blocker ? shadow.blocker->primitive : "");
    table.put("material", "");
    table.put("line", shadow.line);
    table.put("shadow", index);
    table.put("light", shadow.light);
    table.put("visible", int(shadow.visible));
    table.put("distance", shadow.distance);
    table.put("tint", shadow.tint);
}

} // namespace

std::string vtpText(const RayTree& tree, const SceneDescription& scene)
{
    const Extent objects = objectExtent(scene);
    Table table;
    for (const auto& ray : tree.nodes) addRay(table, ray, endOf(ray, scene, objects));
    for (std::size_t i = 0; i < tree.shadows.size(); ++i) addShadow(table, tree, int(i));

    Array points{"Float64", "Points", 3}, connectivity{"Int64", "connectivity"}, offsets{"Int64", "offsets"};
    for (const auto& point : table.points) points.add(point);
    for (std::int64_t i = 0; i < std::int64_t(table.points.size()); ++i) connectivity.add(i);
    for (std::int64_t i = 1; i <= std::int64_t(table.cells()); ++i) offsets.add(2 * i);
    std::string cellData;
    for (const auto& array : table.arrays) cellData += array.xml(table.cells());
    return fmt::format("<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                       "header_type=\"UInt64\">\n"
                       "<PolyData>\n"
                       "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                       "NumberOfPolys=\"0\">\n"
                       "<CellData Scalars=\"kind\">\n{}</CellData>\n<Points>\n{}</Points>\n<Lines>\n{}{}</Lines>\n"
                       "</Piece>\n</PolyData>\n</VTKFile>\n",
                       table.points.size(), table.cells(), cellData, points.xml(table.points.size()),
                       connectivity.xml(0), offsets.xml(0));
}

} // namespace rt::viz
