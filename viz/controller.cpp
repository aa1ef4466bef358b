#include "viz/controller.h"

#include <algorithm>

namespace rt::viz
{

namespace
{
constexpr int deepestCap = 1024; // as --depth allows
}

Controller::Controller(Session chosen) : session(std::move(chosen))
{
    image = session.lesson->render(session.scene, session.precision, session.render);
    traceTree();
}

int Controller::deepest() const
{
    int depth = 0;
    for (const auto& candidate : rays.nodes) depth = std::max(depth, candidate.depth);
    return depth;
}

const RayTree::Node* Controller::node() const
{
    return std::size_t(selectedNode) < rays.nodes.size() ? &rays.nodes[std::size_t(selectedNode)] : nullptr;
}

/// The selection stays if the new tree has a ray of the same kind and depth in that place.
void Controller::traceTree()
{
    const auto* before = node();
    const RayKind kind = before ? before->kind : RayKind::camera;
    const int depth = before ? before->depth : 0;
    rays = session.lesson->inspect(session.scene, session.precision, session.probe);
    const auto* after = node();
    if (!after || after->kind != kind || after->depth != depth) selectedNode = 0;
}

void Controller::choosePixel(int x, int y)
{
    const auto& camera = session.scene.camera;
    const std::array<int, 2> chosen{std::clamp(x, 0, camera.width - 1), std::clamp(y, 0, camera.height - 1)};
    if (pixel() == chosen) return;
    session.probe = chosen;
    traceTree();
    notify(changedTree | changedNode);
}

void Controller::movePixel(int dx, int dy)
{
    const auto from = pixel().value_or(session.scene.pixel());
    choosePixel(from[0] + dx, from[1] + dy);
}

void Controller::selectNode(int id)
{
    if (id == selectedNode || id < 0 || std::size_t(id) >= rays.nodes.size()) return;
    selectedNode = id;
    notify(changedNode);
}

void Controller::parentNode()
{
    if (node()) selectNode(node()->parent);
}

void Controller::setMaxDepth(int depth)
{
    depth = std::clamp(depth, 0, deepestCap);
    if (depth == maxDepth()) return;
    session.scene.trace.maxDepth = depth;
    image = session.lesson->render(session.scene, session.precision, session.render);
    traceTree();
    notify(changedPicture | changedTree | changedNode);
}

void Controller::toggleNormals()
{
    normals = !normals;
    notify(changedOptions);
}

void Controller::toggleHelp()
{
    help = !help;
    notify(changedOptions);
}

void Controller::notify(unsigned what) const
{
    if (changed) changed(what);
}

} // namespace rt::viz
