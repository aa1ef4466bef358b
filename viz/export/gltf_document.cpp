#include "viz/export/gltf_document.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "common/files/base64.h"

namespace rt::viz
{

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

namespace
{

using GltfJson = GltfDocument::Json;

// The specification's numbers.
enum Code
{
    unsignedByte = 5121,
    unsignedShort = 5123,
    unsignedInt = 5125,
    floating = 5126,
    vertexData = 34962,
    indexData = 34963,
    nearest = 9728,
    linearMipmapLinear = 9987,
    repeat = 10497
};

template <class Value>
constexpr int componentType = std::is_same_v<Value, float>           ? floating
                              : std::is_same_v<Value, std::uint32_t> ? unsignedInt
                              : std::is_same_v<Value, std::uint16_t> ? unsignedShort
                                                                     : unsignedByte;

constexpr std::size_t mostSharedTriangles = 2000;

void pad(std::string& bytes, char with)
{
    bytes.append((4 - bytes.size() % 4) % 4, with);
}

void append(std::string& bytes, std::uint32_t number)
{
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

} // namespace

void put(GltfJson& extras, const char* key, double x)
{
    if (std::isfinite(x)) extras[key] = x;
}

void put(GltfJson& extras, const char* key, const std::optional<double>& x)
{
    if (x) put(extras, key, *x);
}

void put(GltfJson& extras, const char* key, const vec3& v)
{
    if (isFinite(v)) extras[key] = {v.x, v.y, v.z};
}

bool fitsFloat(const vec3& point)
{
    return isFinite(Vec3<float>(point));
}

template <class Value>
int GltfDocument::accessor(View view, const std::vector<Value>& values, int components, bool withBounds)
{
    constexpr const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    auto& bytes = views[std::size_t(view)];
    GltfJson made = {{"bufferView", int(view)}, // of all views; finished() knows those that are in use
                     {"byteOffset", bytes.size()},
                     {"componentType", int(componentType<Value>)},
                     {"count", values.size() / std::size_t(components)},
                     {"type", types[components]}};
    if (std::is_same_v<Value, unsigned char>) made["normalized"] = true;
    if (withBounds)
        for (int c = 0; c < components; ++c)
        {
            Value low = values[std::size_t(c)], high = low;
            for (std::size_t i = std::size_t(c); i < values.size(); i += std::size_t(components))
            {
                low = std::min(low, values[i]);
                high = std::max(high, values[i]);
            }
            made["min"].push_back(low);
            made["max"].push_back(high);
        }
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    return add("accessors", std::move(made));
}

template <class Index>
int GltfDocument::indexAccessor(View view, const std::vector<std::array<int, 3>>& triangles)
{
    std::vector<Index> indices;
    for (const auto& triangle : triangles)
        for (const int index : triangle) indices.push_back(static_cast<Index>(index));
    return accessor(view, indices, 1, false);
}

std::optional<GltfDocument::Geometry> GltfDocument::add(const Mesh& mesh, bool fades,
                                                        const std::vector<std::array<double, 2>>& coordinates)
{
    if (mesh.empty() || !std::all_of(mesh.points.begin(), mesh.points.end(), fitsFloat)) return std::nullopt;
    std::vector<float> positions, normals, places;
    for (const auto& point : mesh.points)
        for (int c = 0; c < 3; ++c) positions.push_back(float(point[c]));
    for (const auto& N : mesh.normals)
    {
        // A triangle without area has no normal: any direction will do.
        const vec3 known = std::abs(dot(N, N) - 1) < 1e-3 ? N : vec3(0, 0, 1);
        for (int c = 0; c < 3; ++c) normals.push_back(float(known[c]));
    }
    Geometry geometry;
    geometry.positions = accessor(positionView, positions, 3, true);
    geometry.normals = accessor(normalView, normals, 3, false);
    if (fades)
    {
        std::vector<unsigned char> colors;
        for (const auto& color : mesh.colors) colors.insert(colors.end(), {255, 255, 255, color.a});
        geometry.colors = accessor(colorView, colors, 4, false);
    }
    if (!coordinates.empty())
    {
        for (const auto& [u, v] : coordinates) places.insert(places.end(), {float(u), float(v)});
        geometry.coordinates = accessor(coordinateView, places, 2, false);
    }
    const bool fewPoints = mesh.points.size() <= std::numeric_limits<std::uint16_t>::max();
    const auto known = shared.find(mesh.triangles);
    if (known != shared.end())
        geometry.indices = known->second;
    else
    {
        geometry.indices = fewPoints ? indexAccessor<std::uint16_t>(shortIndexView, mesh.triangles)
                                     : indexAccessor<std::uint32_t>(longIndexView, mesh.triangles);
        if (mesh.triangles.size() <= mostSharedTriangles && fewPoints) shared[mesh.triangles] = geometry.indices;
    }
    return geometry;
}

int GltfDocument::addMesh(const std::string& name, const std::vector<Primitive>& primitives)
{
    GltfJson list = GltfJson::array();
    for (const auto& [geometry, material] : primitives)
    {
        GltfJson attributes = {{"POSITION", geometry.positions}, {"NORMAL", geometry.normals}};
        if (geometry.colors >= 0) attributes["COLOR_0"] = geometry.colors;
        if (geometry.coordinates >= 0) attributes["TEXCOORD_0"] = geometry.coordinates;
        list.push_back({{"attributes", attributes}, {"indices", geometry.indices}, {"material", material}});
    }
    return add("meshes", {{"name", name}, {"primitives", list}});
}

int GltfDocument::addTexture(const std::string& name, const std::string& png)
{
    if (!json.contains("samplers"))
        add("samplers", {{"magFilter", int(nearest)},
                         {"minFilter", int(linearMipmapLinear)},
                         {"wrapS", int(repeat)},
                         {"wrapT", int(repeat)}});
    views.push_back(png);
    const int image = add("images", {{"name", name}, {"bufferView", views.size() - 1}, {"mimeType", "image/png"}});
    return add("textures", {{"sampler", 0}, {"source", image}});
}

int GltfDocument::add(const char* list, GltfJson item)
{
    json[list].push_back(std::move(item));
    return int(json[list].size()) - 1;
}

int GltfDocument::addChild(int parent, GltfJson node)
{
    const int index = add("nodes", std::move(node));
    children[parent].push_back(index);
    return index;
}

int GltfDocument::addLight(GltfJson light)
{
    uses("KHR_lights_punctual");
    auto& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(light));
    return int(lights.size()) - 1;
}

void GltfDocument::uses(const std::string& extension)
{
    auto& used = json["extensionsUsed"];
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

/// Views that hold nothing are left out: glTF has no empty ones.
GltfJson GltfDocument::finished(std::string& buffer) const
{
    GltfJson made = json;
    made["scenes"] = GltfJson::array({GltfJson::object()});
    for (const auto& [parent, indices] : children)
        (parent < 0 ? made["scenes"][0]["nodes"] : made["nodes"][std::size_t(parent)]["children"]) = indices;

    constexpr int strides[] = {12, 12, 4, 8, 0, 0};
    std::vector<int> numbers(views.size(), -1);
    for (std::size_t i = 0; i < views.size(); ++i)
    {
        if (views[i].empty()) continue;
        numbers[i] = int(made["bufferViews"].size());
        GltfJson view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", views[i].size()}};
        if (i < firstImageView)
        {
            if (strides[i] > 0) view["byteStride"] = strides[i];
            view["target"] = int(strides[i] > 0 ? vertexData : indexData);
        }
        made["bufferViews"].push_back(std::move(view));
        buffer += views[i];
        pad(buffer, '\0');
    }
    for (const char* list : {"accessors", "images"})
        if (made.contains(list))
            for (auto& user : made[list]) user["bufferView"] = numbers[user["bufferView"].get<std::size_t>()];
    if (!buffer.empty()) made["buffers"] = GltfJson::array({{{"byteLength", buffer.size()}}});
    return made;
}

std::string GltfDocument::binary() const
{
    std::string buffer;
    std::string text = finished(buffer).dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    pad(text, ' ');
    const std::size_t size = 12 + 8 + text.size() + (buffer.empty() ? 0 : 8 + buffer.size());
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw std::runtime_error("the model needs more than the 4 GiB that a .glb file can hold");
    std::string bytes = "glTF";
    append(bytes, 2);
    append(bytes, std::uint32_t(size));
    append(bytes, std::uint32_t(text.size()));
    bytes += "JSON" + text;
    if (buffer.empty()) return bytes;
    append(bytes, std::uint32_t(buffer.size()));
    bytes += std::string("BIN\0", 4) + buffer;
    return bytes;
}

std::string GltfDocument::text() const
{
    std::string buffer;
    GltfJson made = finished(buffer);
    if (!buffer.empty()) made["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer);
    return made.dump(1, ' ', false, GltfJson::error_handler_t::replace) + "\n";
}

} // namespace rt::viz
