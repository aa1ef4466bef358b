// The state of the viewer and what can be done to it. Views draw it and call its actions; it knows no view.
#pragma once

#include <functional>

#include "common/lesson_entry.h"
#include "common/scene_description.h"

namespace rt::viz
{

/// What the command line chose.
struct Session
{
    SceneDescription scene;
    const LessonEntry* lesson = nullptr;
    Precision precision = Precision::doubled;
    RenderOptions render;
    Probe probe = std::array<int, 2>{0, 0}; ///< inside the picture
};

/// What an action has changed, as a sum.
enum Change : unsigned
{
    changedPicture = 1,
    changedTree = 2,
    changedNode = 4,
    changedOptions = 8,
    changedAll = 15
};

class Controller
{
public:
    /// Renders the picture and traces the tree of the probe.
    explicit Controller(Session chosen);

    const SceneDescription& scene() const { return session.scene; }
    const LessonEntry& lesson() const { return *session.lesson; }
    Precision precision() const { return session.precision; }
    const Image& picture() const { return image; }
    const RayTree& tree() const { return rays; }
    /// The chosen pixel; empty if a ray was given instead.
    std::optional<std::array<int, 2>> pixel() const { return rays.pixel; }
    int maxDepth() const { return session.scene.trace.maxDepth; }
    /// The greatest depth among the tree's nodes; 0 for an empty tree.
    int deepest() const;
    /// The selected node; null only if the tree is empty, as before an exercise is attempted.
    const RayTree::Node* node() const;
    int selected() const { return selectedNode; }
    bool showsNormals() const { return normals; }
    bool showsHelp() const { return help; }

    /// Pixels outside the picture are moved to its edge.
    void choosePixel(int x, int y);
    void movePixel(int dx, int dy);
    /// Ids that the tree does not have are ignored.
    void selectNode(int id);
    void nextNode() { selectNode(selectedNode + 1); }
    void previousNode() { selectNode(selectedNode - 1); }
    void parentNode();
    /// Rays deeper than this are not traced. Renders and traces anew.
    void setMaxDepth(int depth);
    void toggleNormals();
    void toggleHelp();

    /// Called after each action that changed something, with a sum of Change.
    std::function<void(unsigned)> changed;

private:
    Session session;
    Image image;
    RayTree rays;
    int selectedNode = 0;
    bool normals = true;
    bool help = false;

    void traceTree();
    void notify(unsigned what) const;
};

} // namespace rt::viz
