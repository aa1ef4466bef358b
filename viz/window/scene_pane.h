// The scene in space with the rays of the chosen pixel.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "viz/drawing/planes.h"
#include "viz/drawing/rays.h"
#include "viz/drawing/view.h"
#include "viz/window/pane.h"
#include "viz/window/scene_overlay.h"

namespace rt::viz
{

class ScenePane : public Pane
{
public:
    explicit ScenePane(Controller& watched);
    bool update(unsigned changes) override;
    void dress() override;
    bool click(int x, int y) override;
    bool wheel(int x, int y, bool forward) override;

    std::vector<vtkRenderer*> renderers() override { return {renderer(), front}; }

    void fitScene();
    void fitRays();
    /// Adapts the width of lines to how near the viewer now is.
    void viewChanged();
    /// Rough while the user turns the scene, smooth when it stands still.
    void setMoving(bool moving);

private:
    Extent objects;
    /// What the view shows: with another size of the pane it is fitted anew, until the user moves it.
    struct Fitted
    {
        std::vector<vec3> points;
        vec3 towards{0, 0, 1};
        bool aboveLegend = false, withoutRays = false;
    };
    std::optional<Fitted> fitted;
    bool isFitted = false; // the view has been chosen
    double lineWidth = 1;  // factor; less than 1 when the viewer is near, more when he is far away
    RayDrawing drawing;    // of the whole tree
    RayDrawing visible;    // of the part that is to be seen now
    ImagePlane screen;
    LabelPlaces labels;
    std::array<double, 13> labelledFrom{};
    vtkNew<vtkRenderer> front; // what shines through whatever hides it, and the labels
    vtkSmartPointer<vtkActor> solidRays, fadingRays, glow, hiddenRays, frustum, picture, chosenPixel;

    void paint(Canvas& canvas) override;
    void placed() override;
    void build();
    void buildObjects();
    void buildPlanes(const Extent& shown);
    void buildLights();
    void buildFront();
    void rebuildRays();
    void updatePicture();
    std::vector<vec3> shownPoints(bool withLights) const;
    void rebuildChosenPixel();
    void look(const View& view);
    void lookAtFitted();
    double fittingLineWidth();
    void setLineWidth(double factor);
    View view();
    std::array<double, 13> seenFrom();
    double aspect() const { return double(area.width) / area.height; }
};

} // namespace rt::viz
