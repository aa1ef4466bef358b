#include "viz/state/controller.h"
#include "common/program/program.h"

#include <algorithm>
#include <limits>

namespace rt::viz
{

namespace
{

constexpr int deepestCap = 1024; // as --depth allows
constexpr int never = std::numeric_limits<int>::max();

} // namespace

const char* name(Kind kind)
{
    switch (kind)
    {
    case Kind::camera:
        return "camera";
    case Kind::reflected:
        return "reflected";
    case Kind::transmitted:
        return "transmitted";
    case Kind::lit:
        return "lit";
    case Kind::blocked:
        break;
    }
    return "blocked";
}

const char* name(Tone tone)
{
    return tone == Tone::trouble ? "trouble" : tone == Tone::waiting ? "waiting" : "done";
}

Controller::Controller(Session chosen) : session(std::move(chosen))
{
    if (session.source.isSlow || session.paintsLater)
    {
        paintPicture();
        if (session.source.isSlow) coarse->goOn();
    }
    else if (session.source.render)
        try
        {
            image = session.source.render(session.scene, session.render);
        }
        catch (const TooManyRays& error)
        {
            pictureProblem = error.what(); // another depth can be chosen in the window
        }
    session.render.progress = nullptr; // later pictures are made in the background
    if (asksOthers())
    {
        traceTree();
        return;
    }
    Trees trees = trace(session, interrupted());
    if (!trees.failure.empty() && trees.mine.nodes.empty() && !trees.tooMany) throw std::runtime_error(trees.failure);
    take(std::move(trees));
    takePicture(session.patience); // the coarse one, for the window's first drawing
}

std::optional<std::array<int, 2>> Controller::pixel() const
{
    const auto* chosen = std::get_if<std::array<int, 2>>(&session.probe);
    return chosen ? std::optional(*chosen) : std::nullopt;
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

const Event* Controller::current() const
{
    return stepping && steps > 0 ? &happened[std::size_t(steps - 1)] : nullptr;
}

bool Controller::isShown(int id) const
{
    const auto& candidate = rays.nodes[std::size_t(id)];
    // Not "at least": what is not a number is shown.
    return shown[std::size_t(candidate.kind)] && !(largestChannel(candidate.throughput) < leastThroughput);
}

bool Controller::isShadowShown(int shadow) const
{
    const auto& candidate = rays.shadows[std::size_t(shadow)];
    return shows(candidate.visible ? Kind::lit : Kind::blocked) &&
           !(largestChannel(rays.nodes[std::size_t(candidate.node)].throughput) < leastThroughput);
}

Controller::Trees Controller::trace(const Session& session, const std::atomic<bool>& stop)
{
    Trees trees;
    try
    {
        trees.mine = session.source.inspect(session.scene, session.probe, stop);
        if (session.other) trees.other = session.other->inspect(session.scene, session.probe, stop);
    }
    catch (const Stopped&)
    {
        // Nobody waits for them any more.
    }
    catch (const TooManyRays& error)
    {
        trees.failure = error.what();
        trees.tooMany = true;
    }
    catch (const std::exception& error)
    {
        trees.failure = error.what();
    }
    return trees;
}

void Controller::traceTree(unsigned also)
{
    const unsigned changes = changedTree | changedNode | changedStep | also;
    if (!asksOthers())
    {
        Trees trees = trace(session, interrupted());
        if ((also & changedScene) && !trees.failure.empty()) take({}); // the old tree is of a scene that is no more
        take(std::move(trees));
        notify(changes);
        return;
    }
    if (also & changedScene)
    {
        take({});
        notify(changes);
    }
    tracer.start([asked = session](const std::atomic<bool>& stop) { return trace(asked, stop); });
    say("waiting for " + (session.source.isSlow ? session.source : *session.other).title, Tone::waiting);
}

/// The selection stays if the new tree has a ray of the same kind and depth in that place; a failure leaves the old tree.
void Controller::take(Trees&& trees)
{
    said.clear();
    treeProblem = trees.failure;
    if (!treeProblem.empty() && trees.mine.nodes.empty())
    {
        // Of a program that cannot trace one pixel no picture is awaited.
        if (session.source.isSlow && rays.nodes.empty()) painter.cancel();
        return;
    }
    const auto* before = node();
    const RayKind kind = before ? before->kind : RayKind::camera;
    const int depth = before ? before->depth : 0;
    rays = std::move(trees.mine);
    const auto* after = node();
    if (!after || after->kind != kind || after->depth != depth) selectedNode = 0;
    hoveredNode = -1;
    indexEvents();
    compared.reset();
    if (trees.other) compare(*trees.other);
}

void Controller::compare(const RayTree& other)
{
    const bool precisionsDiffer = (rays.real == "float") != (other.real == "float");
    const TreeTolerance tolerance = precisionsDiffer ? floatAgainstDouble() : TreeTolerance{};
    compared =
        TreeComparison{other, matchTrees(rays, other, tolerance), firstDifference(rays, other, tolerance), tolerance};
}

void Controller::indexEvents()
{
    happened = eventsOf(rays);
    reachedAt.assign(rays.nodes.size(), never);
    returnedAt.assign(rays.nodes.size(), never);
    shadowAt.assign(rays.shadows.size(), never);
    cappedAt.assign(rays.capped.size(), never);
    for (std::size_t i = 0; i < happened.size(); ++i)
    {
        const auto& event = happened[i];
        auto& step = event.kind == Event::Kind::follow    ? reachedAt[std::size_t(event.node)]
                     : event.kind == Event::Kind::returns ? returnedAt[std::size_t(event.node)]
                     : event.kind == Event::Kind::shadow  ? shadowAt[std::size_t(event.index)]
                                                          : cappedAt[std::size_t(event.index)];
        step = int(i) + 1;
    }
    steps = lastStep();
    stepping = playing = false;
}

/// True if there is another scene now.
bool Controller::takeScene()
{
    if (!session.reread) return false;
    try
    {
        auto another = session.reread();
        if (!another) return false;
        session.scene = std::move(*another);
    }
    catch (const std::exception& error)
    {
        say(error.what());
        return false;
    }
    if (chosenDepth) session.scene.trace.maxDepth = *chosenDepth;
    const auto& camera = session.scene.camera;
    if (auto* chosen = std::get_if<std::array<int, 2>>(&session.probe))
        *chosen = {std::clamp((*chosen)[0], 0, camera.width - 1), std::clamp((*chosen)[1], 0, camera.height - 1)};
    paintPicture();
    coarse->goOn();
    return true;
}

void Controller::reread()
{
    if (takeScene()) traceTree(changedScene);
}

void Controller::choosePixel(int x, int y)
{
    const unsigned also = takeScene() ? changedScene : 0U;
    const auto& camera = session.scene.camera;
    const std::array<int, 2> chosen{std::clamp(x, 0, camera.width - 1), std::clamp(y, 0, camera.height - 1)};
    const bool isSame = pixel() == chosen;
    if (isSame && !also && !asksOthers()) return;
    if (session.source.isFixed && !isSame)
        return say(session.source.title + " holds the tree of one pixel: no other can be chosen");
    session.probe = chosen;
    if (isSame && !also && session.source.isSlow)
    {
        paintPicture();
        coarse->goOn();
    }
    traceTree(also);
}

void Controller::movePixel(int dx, int dy)
{
    const auto from = pixel().value_or(session.scene.pixel());
    choosePixel(from[0] + dx, from[1] + dy);
}

void Controller::selectNode(int id)
{
    if (id < 0 || std::size_t(id) >= rays.nodes.size()) return;
    const bool isAhead = !isReached(id);
    if (isAhead && reachedAt[std::size_t(id)] != never) return stepTo(reachedAt[std::size_t(id)]);
    if (id == selectedNode) return;
    selectedNode = id;
    notify(changedNode);
}

void Controller::parentNode()
{
    if (node()) selectNode(node()->parent);
}

void Controller::hover(int id)
{
    if (id < 0 || std::size_t(id) >= rays.nodes.size()) id = -1;
    if (id == hoveredNode) return;
    hoveredNode = id;
    notify(changedHover);
}

void Controller::stepTo(int step)
{
    step = std::clamp(step, 0, lastStep());
    const bool began = !stepping;
    stepping = true;
    if (step == steps && !began) return;
    steps = step;
    unsigned changes = changedStep;
    if (const auto* event = current(); event && event->node != selectedNode)
    {
        selectedNode = event->node;
        changes |= changedNode;
    }
    if (steps == 0 && selectedNode != 0)
    {
        selectedNode = 0;
        changes |= changedNode;
    }
    notify(changes);
}

void Controller::stepBy(int by)
{
    stepTo(steps + by);
}

void Controller::setPlaying(bool play)
{
    if (play == playing || happened.empty()) return;
    playing = play;
    // Playing begins at the beginning unless the user is on his way.
    if (playing && isComplete()) stepTo(0);
    notify(changedOptions);
}

void Controller::playFaster(bool faster)
{
    playSpeed = std::clamp(faster ? 2 * playSpeed : playSpeed / 2, 0.5, 64.0);
    say(playSpeed < 1 ? "plays a step in 2 seconds"
                      : "plays " + std::to_string(int(playSpeed)) + (playSpeed > 1 ? " steps" : " step") + " a second",
        Tone::done);
}

void Controller::playOn(int count)
{
    if (!playing) return;
    stepBy(count);
    if (isComplete()) setPlaying(false);
}

void Controller::setMaxDepth(int depth)
{
    depth = std::clamp(depth, 0, deepestCap);
    if (depth == maxDepth()) return;
    if (session.source.isFixed)
        return say(session.source.title + " holds one tree, traced already: no other depth can be chosen");
    chosenDepth = depth;
    session.scene.trace.maxDepth = depth;
    paintPicture();
    const auto show = [this](std::chrono::milliseconds patience) {
        if (!isRefining()) return;
        if (const unsigned changes = takePicture(patience)) notify(changes);
    };
    // The picture first: its pane is drawn in a fraction of the time that all take.
    show(session.patience);
    traceTree();
    show(std::chrono::milliseconds(0)); // if it was late
    coarse->goOn();
}

void Controller::paintPicture()
{
    if (!session.source.render) return;
    // What was painted until now goes on putting its pictures where nobody takes them.
    coarse = std::make_shared<CoarsePictures>();
    share = std::make_shared<std::atomic<double>>(0);
    sharesTold = 0;
    painter.start([asked = session, pictures = coarse, done = share](const std::atomic<bool>& stop) {
        RenderOptions options = asked.render;
        options.progress = [done](double now) { *done = now; };
        options.stop = &stop;
        return paintInPasses(asked.source, asked.scene, options, *pictures);
    });
}

/// Takes over the picture, or the newest coarse one, for which it waits; says what has changed.
unsigned Controller::takePicture(std::chrono::milliseconds patience)
{
    if (!painter.isBusy()) return 0;
    auto pass = coarse->take(patience);
    try
    {
        if (auto finished = painter.poll())
        {
            image = std::move(*finished);
            pictureProblem.clear();
            return changedPicture | changedMessage;
        }
    }
    catch (const std::exception& error)
    {
        pictureProblem = error.what(); // the last picture stays
        return changedMessage;
    }
    if (!pass) return 0;
    image = std::move(pass->image);
    return changedPass;
}

bool Controller::poll()
{
    coarse->goOn(); // whoever polls has drawn what there was
    if (const int percent = int(100 * *share); isRefining() && percent > sharesTold)
    {
        sharesTold = percent;
        notify(changedShare);
    }
    if (const unsigned changes = takePicture(std::chrono::milliseconds(0))) notify(changes);
    if (auto finished = tracer.poll())
    {
        take(std::move(*finished));
        notify(changedTree | changedNode | changedStep | changedMessage);
    }
    return painter.isBusy() || tracer.isBusy();
}

void Controller::wait()
{
    coarse->goOn();
    const auto finish = [this](auto& work) {
        while (!work.waitFor(std::chrono::milliseconds(50)))
            if (interrupted()) work.cancel();
        poll();
    };
    finish(tracer); // first: of a program that cannot trace, no picture is awaited
    finish(painter);
}

void Controller::setWeakest(double throughput)
{
    throughput = std::clamp(throughput, 0.0, 1.0);
    if (throughput == leastThroughput) return;
    leastThroughput = throughput;
    notify(changedOptions);
}

void Controller::toggle(Kind kind)
{
    shown[std::size_t(kind)] = !shown[std::size_t(kind)];
    notify(changedOptions);
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

void Controller::toggleLook()
{
    theme = theme == Look::dark ? Look::light : Look::dark;
    notify(changedAll);
}

void Controller::toggleComparison()
{
    if (!canCompare()) return say("there is nothing to compare with: start the viewer with --compare");
    showsOther = !showsOther;
    notify(changedOptions | changedTree);
}

void Controller::selectDifference()
{
    if (!comparison() || !compared->first) return;
    const auto& first = *compared->first;
    if (first.expectedNode >= 0) selectNode(first.expectedNode);
}

void Controller::say(const std::string& message, Tone as)
{
    if (message == said && as == saidAs) return;
    said = message;
    saidAs = as;
    notify(changedMessage);
}

void Controller::notify(unsigned what) const
{
    if (changed) changed(what);
}

} // namespace rt::viz
