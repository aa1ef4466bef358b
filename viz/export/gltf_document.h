// A glTF 2.0 document under construction: geometry goes into its buffer, the rest is JSON. Knows nothing of rays.
// https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viz/drawing/mesh.h"

namespace rt::viz
{

class GltfDocument
{
public:
    using Json = nlohmann::ordered_json;

    /// The accessors of one piece of geometry.
    struct Geometry
    {
        int positions = -1, normals = -1, indices = -1;
        int colors = -1;      ///< white with the mesh's alpha; -1: opaque
        int coordinates = -1; ///< of a texture; -1: none
    };

    struct Primitive
    {
        Geometry geometry;
        int material = -1;
    };

    /// One texture coordinate a point, or none. Empty if the mesh is, or if a point does not fit a float: what has no place
    /// is left out. Triangles of the same pattern share their indices.
    std::optional<Geometry> add(const Mesh& mesh, bool fades,
                                const std::vector<std::array<double, 2>>& coordinates = {});

    int addMesh(const std::string& name, const std::vector<Primitive>& primitives);
    /// The image lies in the buffer; it repeats, and is not blurred when seen from near.
    int addTexture(const std::string& name, const std::string& png);
    /// Appends to "materials", "nodes", "cameras", ...; returns the index.
    int add(const char* list, Json item);
    int addChild(int parent, Json node); ///< parent -1: a node of the scene itself
    int addLight(Json light);            ///< of KHR_lights_punctual
    void uses(const std::string& extension);
    Json& asset() { return json["asset"]; }

    std::string binary() const; ///< a .glb
    std::string text() const;   ///< a .gltf, the buffer as data URI

private:
    enum View
    {
        positionView,
        normalView,
        colorView,
        coordinateView,
        shortIndexView,
        longIndexView,
        firstImageView
    };

    template <class Value>
    int accessor(View view, const std::vector<Value>& values, int components, bool withBounds);
    template <class Index>
    int indexAccessor(View view, const std::vector<std::array<int, 3>>& triangles);
    Json finished(std::string& buffer) const;

    Json json = {{"asset", {{"version", "2.0"}, {"generator", "raytree"}}}, {"scene", 0}};
    std::vector<std::string> views{std::size_t(firstImageView)};
    std::map<int, std::vector<int>> children;              ///< of the nodes; -1: of the scene
    std::map<std::vector<std::array<int, 3>>, int> shared; ///< accessors of triangles
};

// Numbers for `extras`: what is not finite is left out, JSON cannot say it.
void put(GltfDocument::Json& extras, const char* key, double x);
void put(GltfDocument::Json& extras, const char* key, const std::optional<double>& x);
void put(GltfDocument::Json& extras, const char* key, const vec3& v);

/// True if the point stays finite as floats.
bool fitsFloat(const vec3& point);

} // namespace rt::viz
