#include "viz/window/scene_pane.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "viz/drawing/object_meshes.h"
#include "viz/drawing/picture_view.h"
#include "viz/drawing/ray_mesh.h"
#include "viz/drawing/shown_rays.h"
#include "viz/window/actors.h"
#include "viz/window/scene_overlay.h"

namespace rt::viz
{

namespace
{

constexpr int patchSide = 768;       // pixels of a plane's picture
constexpr double frameWidth = 0.006; // of the objects' extent
constexpr int planePicture = 1024;   // largest side of the picture on the image plane

/// `origin`: near the scene. This mapper counts in float, so places are told from there.
vtkSmartPointer<vtkActor> glowActor(const SceneDescription& scene, const vec3& origin, double radius)
{
    Mesh centres;
    for (const auto& light : scene.lights)
    {
        centres.points.push_back(light.position - origin);
        centres.normals.emplace_back(0, 1, 0);
        centres.colors.push_back(lightColor(light));
    }
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(polyData(centres));
    mapper->SetScaleFactor(radius);
    mapper->EmissiveOff();
    mapper->SetColorModeToDirectScalars();
    mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                               "float d = length(offsetVCVSOutput.xy);\n"
                               "if (d > 1.0) { discard; }\n"
                               "opacity = 0.55 * pow(1.0 - d, 2.2);\n");
    mapper->SetTriangleScale(1.6F);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetPosition(origin.x, origin.y, origin.z);
    actor->GetProperty()->LightingOff();
    actor->ForceTranslucentOn();
    return actor;
}

} // namespace

ScenePane::ScenePane(Controller& watched) : Pane(watched)
{
    renderer()->GradientBackgroundOn();
    dress();
    renderer()->SetUseFXAA(true);
    build();
}

void ScenePane::build()
{
    auto* view = renderer();
    view->RemoveAllViewProps();
    front->RemoveAllViewProps();
    objects = extentOf(controller.scene(), controller.tree());
    screen = imagePlane(controller.scene().camera, objects);
    drawing = drawRays(controller.tree(), controller.scene(), objects);
    buildObjects();
    solidRays = meshActor({}, Finish::vivid);
    fadingRays = meshActor({}, Finish::vivid, true);
    view->AddActor(solidRays);
    view->AddActor(fadingRays);
    glow = meshActor({}, Finish::plain, true);
    view->AddActor(glow);
    buildFront();
    rebuildRays();
}

std::vector<vec3> ScenePane::shownPoints(bool withLights) const
{
    auto points = objectPoints(controller.scene());
    for (const auto& p : rayPoints(drawing, withLights)) points.push_back(p);
    if (withLights)
        for (const auto& light : controller.scene().lights) points.push_back(light.position);
    for (const auto& [x, y] : {vec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}) points.push_back(screen.at(x, y));
    points.push_back(screen.eye);
    // What is too far away to be part of the scene would make all the rest tiny.
    std::erase_if(points, [&](const vec3& p) {
        return !(glm::length(p - objects.centre) < 12 * objects.radius) && p != screen.eye;
    });
    return points;
}

void ScenePane::buildObjects()
{
    const auto& scene = controller.scene();
    const Extent shown = around(shownPoints(true), objects);
    const auto meshes = objectMeshes(scene, shown);
    buildPlanes(shown);
    renderer()->AddActor(meshActor(meshes.backdrop, Finish::matte, true));
    renderer()->AddActor(meshActor(meshes.matte, Finish::matte));
    renderer()->AddActor(meshActor(meshes.chrome, Finish::chrome));
    renderer()->AddActor(meshActor(meshes.glass, Finish::glass));
    frustum = meshActor({}, Finish::plain);
    renderer()->AddActor(frustum);
    buildLights();

    picture = pictureActor(screen.topLeft, screen.right, screen.down);
    picture->GetProperty()->SetOpacity(0.85);
    picture->ForceTranslucentOn();
    renderer()->AddActor(picture);
    chosenPixel = meshActor({}, Finish::plain);
    renderer()->AddActor(chosenPixel);
    updatePicture();
}

void ScenePane::buildPlanes(const Extent& shown)
{
    const auto& scene = controller.scene();
    // Without what is high above the floor, so that the floor lies under the objects.
    Extent ground = shown;
    ground.centre = 0.5 * (shown.centre + objects.centre);
    for (const auto& patch : planePatches(scene, ground))
    {
        const auto painted = paintPatch(patch, scene, patchSide);
        const auto add = [&]() {
            const auto actor = pictureActor(patch.corner, patch.right, patch.forward, patch.outline);
            setPicture(actor, painted.pixels, painted.side, painted.side);
            renderer()->AddActor(actor);
            return actor;
        };
        const auto actor = add();
        if (patch.seeThrough)
        {
            actor->ForceTranslucentOn();
            continue;
        }
        // Planes are what is furthest away: drawn first they may fade into the background without being sorted.
        actor->ForceOpaqueOn();
        if (patch.isFloor) continue;
        // A wall hides nothing from behind: there it is only hinted at.
        actor->GetProperty()->BackfaceCullingOn();
        const auto hint = add();
        hint->GetProperty()->FrontfaceCullingOn();
        hint->GetProperty()->SetOpacity(0.12);
        hint->ForceTranslucentOn();
    }
}

void ScenePane::buildLights()
{
    const auto& scene = controller.scene();
    const double radius = lightRadius(drawing);
    renderer()->AddActor(meshActor(lightMesh(scene, radius), Finish::plain));
    if (!scene.lights.empty()) renderer()->AddActor(glowActor(scene, objects.centre, 7 * radius));

    renderer()->SetAutomaticLightCreation(false);
    renderer()->RemoveAllLights();
    vtkNew<vtkLight> headlight;
    headlight->SetLightTypeToHeadlight();
    headlight->SetIntensity(scene.lights.empty() ? 0.9 : 0.3);
    renderer()->AddLight(headlight);
    // The strongest lamps shine on the objects; how strongly is a matter of looks here.
    std::vector<Light<double>> lamps = scene.lights;
    const auto strength = [&](const Light<double>& lamp) {
        const vec3 d = lamp.position - objects.centre;
        return largestChannel(lamp.color) / std::max(1e-9, dot(d, d));
    };
    std::stable_sort(lamps.begin(), lamps.end(),
                     [&](const auto& a, const auto& b) { return strength(a) > strength(b); });
    lamps.resize(std::min<std::size_t>(lamps.size(), 3));
    double all = 0;
    for (const auto& lamp : lamps) all += strength(lamp);
    for (const auto& lamp : lamps)
    {
        if (!(all > 0) || !std::isfinite(all)) break;
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        light->PositionalOn();
        light->SetConeAngle(180);
        light->SetPosition(lamp.position.x, lamp.position.y, lamp.position.z);
        light->SetFocalPoint(objects.centre.x, objects.centre.y, objects.centre.z);
        const Rgba tint = mix(lightColor(lamp), {255, 255, 255}, 0.3);
        light->SetColor(tint.r / 255.0, tint.g / 255.0, tint.b / 255.0);
        light->SetIntensity(0.9 * strength(lamp) / all);
        renderer()->AddLight(light);
    }
}

/// Rays and lights behind a wall or below the floor are still faintly seen.
void ScenePane::buildFront()
{
    front->SetLayer(1);
    front->SetActiveCamera(renderer()->GetActiveCamera());
    hiddenRays = meshActor({}, Finish::plain, true);
    const auto hiddenLights = meshActor(lightMesh(controller.scene(), lightRadius(drawing)), Finish::plain, true);
    for (auto* actor : {hiddenRays.Get(), hiddenLights.Get()})
    {
        actor->GetProperty()->SetOpacity(0.22);
        actor->GetProperty()->BackfaceCullingOn();
        front->AddActor(actor);
    }
    paintIn(front);
}

void ScenePane::updatePicture()
{
    const auto reduced = ScreenPicture(controller.picture()).reduced(planePicture);
    picture->SetVisibility(!reduced.pixels.empty()); // another tracer may trace, but not paint
    if (reduced.pixels.empty()) return;
    setPicture(picture, reduced.pixels, reduced.width, reduced.height);
}

void ScenePane::rebuildRays()
{
    visible = shownPart(drawing, controller);
    for (auto& segment : otherRays(controller, objects)) visible.segments.push_back(std::move(segment));
    const auto mesh = buildRayMesh(visible, {.selected = drawing.nodes > 1 ? controller.selected() : -1,
                                             .withNormals = controller.showsNormals(),
                                             .width = lineWidth});
    setMesh(solidRays, mesh.solid);
    setMesh(fadingRays, mesh.fading);
    setMesh(glow, mesh.glow);
    setMesh(hiddenRays, mesh.solid);
    setMesh(frustum, cameraMesh(screen, frameWidth * lineWidth * objects.radius));
    rebuildChosenPixel();
}

void ScenePane::rebuildChosenPixel()
{
    Mesh square;
    if (const auto pixel = controller.pixel())
    {
        const auto& camera = controller.scene().camera;
        // At least so large that it can be seen.
        const double w = std::max(1.0 / camera.width, 0.02), h = std::max(1.0 / camera.height, 0.027);
        const double x = ((*pixel)[0] + 0.5) / camera.width, y = ((*pixel)[1] + 0.5) / camera.height;
        const vec3 corners[] = {screen.at(x - w / 2, y - h / 2), screen.at(x + w / 2, y - h / 2),
                                screen.at(x + w / 2, y + h / 2), screen.at(x - w / 2, y + h / 2)};
        for (int i = 0; i < 4; ++i)
            addTube(square, corners[i], corners[(i + 1) % 4], frameWidth * lineWidth * objects.radius,
                    colorOf(RayRole::camera), colorOf(RayRole::camera));
    }
    setMesh(chosenPixel, square);
}

void ScenePane::dress()
{
    setBackground(color::skyLow);
    renderer()->SetBackground2(color::skyHigh.r / 255.0, color::skyHigh.g / 255.0, color::skyHigh.b / 255.0);
}

bool ScenePane::update(unsigned changes)
{
    // The pane is slow to draw: a coarse picture is shown here only if there is something else to draw.
    if ((changes & changedPicture) || ((changes & changedPass) && (changes & changedTree))) updatePicture();
    if (changes & changedScene)
    {
        build();
        renderer()->ResetCameraClippingRange();
        return true;
    }
    if (changes & changedTree) labels.places.clear();
    if (changes & changedTree) drawing = drawRays(controller.tree(), controller.scene(), objects);
    if (!(changes & ~(changedPicture | changedPass | changedHover | changedMessage | changedShare)))
        return (changes & changedPicture) != 0;
    rebuildRays();
    if ((changes & changedTree) && isPlaced() && fitted && fitted->withoutRays && drawing.nodes > 0) fitScene();
    renderer()->ResetCameraClippingRange();
    return true;
}

/// Only a pane that has a size can choose its view: at the start the cheat sheet may stand in its place.
void ScenePane::placed()
{
    if (!isPlaced()) return;
    if (!isFitted)
        fitScene();
    else if (fitted)
        lookAtFitted();
}

void ScenePane::fitScene()
{
    isFitted = true;
    const vec3 towards = bestDirection(drawing, controller.scene()), up = controller.scene().camera.up;
    auto everything = shownPoints(true), nearby = shownPoints(false);
    const View all = fitView(everything, towards, up, aspect()), close = fitView(nearby, towards, up, aspect());
    // Lights far from everything else may lie outside: the shadow rays point to them.
    const auto distance = [&](const View& view) { return glm::length(view.position - objects.centre); };
    const bool withLights = !(distance(all) > 1.2 * distance(close));
    fitted = {std::move(withLights ? everything : nearby), towards, false, drawing.nodes == 0};
    lookAtFitted();
}

void ScenePane::lookAtFitted()
{
    Margins margins;
    if (fitted->aboveLegend)
        margins.bottom = std::clamp((labels.legend.y + labels.legend.height) / area.height + 0.03, margins.bottom, 0.4);
    look(fitView(fitted->points, fitted->towards, controller.scene().camera.up, aspect(), margins));
}

/// What is shown now, into what the legend leaves free.
void ScenePane::fitRays()
{
    auto points = rayPoints(visible, true);
    std::erase_if(points, [&](const vec3& p) { return !(glm::length(p - objects.centre) < 12 * objects.radius); });
    if (points.empty()) return fitScene();
    // Not closer than a part of the objects is large.
    const Extent rays = around(points, objects);
    for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)})
        for (const double sign : {-0.4, 0.4}) points.push_back(rays.centre + sign * objects.radius * axis);
    const View now = view();
    fitted = {std::move(points), unit(now.position - now.focal), true, false};
    lookAtFitted();
}

void ScenePane::look(const View& view)
{
    auto* camera = renderer()->GetActiveCamera();
    camera->SetPosition(view.position.x, view.position.y, view.position.z);
    camera->SetFocalPoint(view.focal.x, view.focal.y, view.focal.z);
    camera->SetViewUp(view.up.x, view.up.y, view.up.z);
    camera->SetViewAngle(view.angle);
    // What is fitted must not depend on what was seen before.
    setLineWidth(fittingLineWidth());
}

/// Lines are as wide as suits the scene, but neither hairs from afar nor pipes near by.
double ScenePane::fittingLineWidth()
{
    const View now = view();
    const Projector projector(now, area.width, area.height);
    const double widest = tubeRadius(drawing) * projector.pixelsPerUnit(now.focal);
    return std::clamp(1.0, 2.3 * scale / widest, 6 * scale / widest);
}

void ScenePane::setLineWidth(double factor)
{
    if (factor != lineWidth)
    {
        lineWidth = factor;
        rebuildRays();
    }
    renderer()->ResetCameraClippingRange();
}

void ScenePane::viewChanged()
{
    // Small changes are not worth new meshes.
    const double factor = fittingLineWidth();
    setLineWidth(std::abs(factor - lineWidth) < 0.08 * lineWidth ? lineWidth : factor);
}

bool ScenePane::wheel(int, int, bool forward)
{
    fitted.reset();
    renderer()->GetActiveCamera()->Dolly(forward ? 1.15 : 1 / 1.15);
    viewChanged();
    return true;
}

View ScenePane::view()
{
    auto* camera = renderer()->GetActiveCamera();
    const double *p = camera->GetPosition(), *f = camera->GetFocalPoint(), *u = camera->GetViewUp();
    return {{p[0], p[1], p[2]}, {f[0], f[1], f[2]}, {u[0], u[1], u[2]}, camera->GetViewAngle()};
}

/// All that decides where a point of space lies in the pane.
std::array<double, 13> ScenePane::seenFrom()
{
    const auto [p, f, u, angle] = view();
    return {p.x, p.y, p.z, f.x, f.y, f.z, u.x, u.y, u.z, angle, double(area.width), double(area.height), scale};
}

void ScenePane::setMoving(bool moving)
{
    renderer()->SetUseFXAA(!moving);
    fitted.reset();
}

bool ScenePane::click(int x, int y)
{
    const Projector projector(view(), area.width, area.height);
    // Labels lie above all rays.
    if (const int named = labels.nodeAt({x + 0.5, y + 0.5}); named >= 0)
    {
        controller.selectNode(named);
        return false;
    }
    const int found = pickSegment(visible, projector, {x + 0.5, y + 0.5}, 10 * scale);
    if (found >= 0) controller.selectNode(visible.segments[std::size_t(found)].node);
    return false;
}

void ScenePane::paint(Canvas& canvas)
{
    const std::array<double, 13> seen = seenFrom();
    if (seen != labelledFrom) labels.places.clear();
    labelledFrom = seen;
    paintSceneOverlay(canvas, {controller, visible, objects, view(), area.width, area.height, labels});
}

} // namespace rt::viz
