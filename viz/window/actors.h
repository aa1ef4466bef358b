// Meshes and pictures as VTK actors.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include "viz/drawing/mesh.h"

namespace rt::viz
{

/// How a surface looks in the 3D view; not how a lesson shades it.
enum class Finish
{
    matte,
    chrome, ///< mirrors: reflect a grey studio
    glass,  ///< nearly clear, denser at the rim
    vivid,  ///< rays: a little light of their own
    plain   ///< no light at all
};

vtkSmartPointer<vtkPolyData> polyData(const Mesh& mesh);
vtkSmartPointer<vtkActor> meshActor(const Mesh& mesh, Finish finish, bool translucent = false);
/// Replaces what an actor from meshActor shows.
void setMesh(vtkActor* actor, const Mesh& mesh);

/// A parallelogram, or the part within `outline`, with a picture whose first row lies along `right` at `corner`.
vtkSmartPointer<vtkActor> pictureActor(const vec3& corner, const vec3& right, const vec3& down,
                                       const std::vector<std::array<double, 2>>& outline = {
                                           {0, 0}, {1, 0}, {1, 1}, {0, 1}});
/// `pixels` row by row.
void setPicture(vtkActor* actor, const std::vector<Rgba>& pixels, int width, int height);

} // namespace rt::viz
