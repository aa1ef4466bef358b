// The objects of a scene as meshes, one for each finish; the camera and the lights as they are drawn.
#pragma once

#include "viz/drawing/mesh.h"

namespace rt::viz
{

struct ObjectMeshes
{
    Mesh matte, chrome, glass;
    Mesh backdrop; ///< the near part of spheres that serve as a floor, fading out
};

/// `shown`: how much of the backdrop is wanted.
ObjectMeshes objectMeshes(const SceneDescription& scene, const Extent& shown);

/// The camera: its pyramid and the frame of its image plane.
Mesh cameraMesh(const ImagePlane& plane, double thickness);

/// A ball in the light's colour, as bright as the screen can.
Rgba lightColor(const Light<double>& light);
Mesh lightMesh(const SceneDescription& scene, double radius);

} // namespace rt::viz
