// The state of the viewer and what can be done to it. Views draw it and call its actions; it knows no view.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "common/scene/scene_description.h"
#include "common/tree/events.h"
#include "common/tree/tree_diff.h"
#include "viz/base/look.h"
#include "viz/state/background.h"
#include "viz/state/refine.h"
#include "viz/state/tree_source.h"

namespace rt::viz
{

/// What the command line chose.
struct Session
{
    SceneDescription scene;
    /// The scene anew, if its file has changed; throws one sentence. Empty: it does not change.
    std::function<std::optional<SceneDescription>()> reread = {};
    TreeSource source;
    std::optional<TreeSource> other; ///< what `source` is compared with
    RenderOptions render;
    Probe probe = std::array<int, 2>{0, 0}; ///< inside the picture
    std::chrono::milliseconds patience{25}; ///< so long another depth waits for its coarse picture
    bool paintsLater = false;               ///< the first picture, too, is painted in the background, coarse first
};

/// What an action has changed, as a sum.
enum Change : unsigned
{
    changedPicture = 1,
    changedTree = 2,
    changedNode = 4,
    changedStep = 8,     ///< what has happened so far
    changedOptions = 16, ///< what is shown, and how
    changedHover = 32,
    changedMessage = 64,
    changedPass = 128, ///< the picture, which is still coarse
    changedAll = 255,
    changedScene = 256, ///< not among changedAll: the 3D pane is built anew, which takes long
    changedShare = 512  ///< of the picture that is painted
};

/// What keys 1 to 5 show or hide.
enum class Kind
{
    camera,
    reflected,
    transmitted,
    lit,    ///< shadow rays that reach their light
    blocked ///< and those that do not
};
inline constexpr int kinds = 5;
const char* name(Kind kind); ///< "camera", "reflected", "transmitted", "lit", "blocked"

/// What kind of message is shown.
enum class Tone
{
    trouble, ///< stays until it is cleared, or something is traced
    waiting, ///< until the answer is there
    done     ///< goes away by itself
};
const char* name(Tone tone); ///< "trouble", "waiting", "done"

/// Two trees of the same probe.
struct TreeComparison
{
    RayTree tree;    ///< of the other source
    TreeMatch match; ///< expected: the controller's own tree; got: this one
    std::optional<TreeDifference> first;
    TreeTolerance tolerance; ///< smaller differences are none
};

class Controller
{
public:
    /// Renders the picture and traces the tree of the probe. Throws what the source throws; but what is asked in the
    /// background, as a slow source is, fails with a message, as do too many rays.
    explicit Controller(Session chosen);

    const SceneDescription& scene() const { return session.scene; }
    const TreeSource& source() const { return session.source; }
    /// The last one that is there: after a change, first a coarse one.
    const Image& picture() const { return image; }
    /// Is the picture another than the final one for what is chosen? Never of a slow source, which says when it is ready.
    bool isRefining() const { return painter.isBusy() && !session.source.isSlow; }
    /// How much of it is painted, from 0 to 1.
    double painted() const { return isRefining() ? double(sharesTold) / 100 : 1; }
    const RayTree& tree() const { return rays; }
    /// The chosen pixel; empty if a ray was given instead.
    std::optional<std::array<int, 2>> pixel() const;
    /// Of each pixel of the picture. The tree is that of the first one, whose ray goes through the pixel's centre.
    int samples() const { return session.render.spp; }
    int maxDepth() const { return session.scene.trace.maxDepth; }
    /// The greatest depth among the tree's nodes; 0 for an empty tree.
    int deepest() const;
    /// The selected node; null only if the tree is empty, as before an exercise is attempted.
    const RayTree::Node* node() const;
    int selected() const { return selectedNode; }
    /// The node under the pointer, in whatever pane; -1: none.
    int hovered() const { return hoveredNode; }

    // Stepping: the first `step` events have happened.
    const std::vector<Event>& events() const { return happened; }
    int step() const { return steps; }
    int lastStep() const { return int(happened.size()); }
    bool isComplete() const { return steps == lastStep(); }
    /// The event that happened last; null before the first, and when everything has happened and nobody steps.
    const Event* current() const;
    bool isReached(int node) const { return reachedAt[std::size_t(node)] <= steps; }
    bool hasReturned(int node) const { return returnedAt[std::size_t(node)] <= steps; }
    bool isShadowReached(int shadow) const { return shadowAt[std::size_t(shadow)] <= steps; }
    bool isCappedReached(int capped) const { return cappedAt[std::size_t(capped)] <= steps; }
    bool isPlaying() const { return playing; }
    /// Steps in a second.
    double speed() const { return playSpeed; }

    // What is shown.
    bool showsNormals() const { return normals; }
    bool showsHelp() const { return help; }
    bool shows(Kind kind) const { return shown[std::size_t(kind)]; }
    /// Rays of less throughput (largest channel) than this are hidden; 0 hides none.
    double weakest() const { return leastThroughput; }
    /// Neither its kind is hidden nor is it too weak.
    bool isShown(int node) const;
    bool isShadowShown(int shadow) const;
    Look look() const { return theme; }

    /// Null unless there is another source, and it has answered.
    const TreeComparison* comparison() const { return compared && showsOther ? &*compared : nullptr; }
    bool canCompare() const { return session.other.has_value(); }
    const TreeSource& other() const { return *session.other; }

    /// What went wrong, is going on or has been done; empty: nothing. One sentence.
    const std::string& message() const
    {
        return !said.empty() ? said : !treeProblem.empty() ? treeProblem : pictureProblem;
    }

    Tone tone() const { return said.empty() ? Tone::trouble : saidAs; }

    /// Takes over the scene's file if that has changed, and traces it. What is wrong with it becomes the message.
    void reread();
    /// Pixels outside the picture are moved to its edge. The same one is traced again if another program is asked: it may
    /// answer otherwise now.
    void choosePixel(int x, int y);
    void movePixel(int dx, int dy);
    /// Ids that the tree does not have are ignored. A node that has not been reached is stepped to.
    void selectNode(int id);
    void nextNode() { selectNode(selectedNode + 1); }
    void previousNode() { selectNode(selectedNode - 1); }
    void parentNode();
    void hover(int id);
    /// Clamped to 0 and lastStep().
    void stepTo(int step);
    void stepBy(int steps);
    void setPlaying(bool playing);
    /// Some steps while playing; stops at the end.
    void playOn(int steps = 1);
    /// Twice as fast, or half as fast, from a step in two seconds to 64 in one.
    void playFaster(bool faster);
    /// Rays deeper than this are not traced. The tree is traced at once, the picture in the background, coarse first.
    void setMaxDepth(int depth);
    void setWeakest(double throughput);
    void toggle(Kind kind);
    void toggleNormals();
    void toggleHelp();
    void toggleLook();
    void toggleComparison();
    /// Goes to the node where the comparison found its first difference.
    void selectDifference();
    void say(const std::string& message, Tone as = Tone::trouble);

    /// Takes over what the background has finished; true while it is still at work. A window calls it now and then.
    bool poll();
    /// Until the background has finished, or somebody interrupts.
    void wait();

    /// Called after each action that changed something, with a sum of Change.
    std::function<void(unsigned)> changed;

private:
    struct Trees
    {
        RayTree mine;
        std::optional<RayTree> other;
        std::string failure;
        bool tooMany = false; ///< it is that they would have too many rays
    };

    Session session;
    Image image;
    RayTree rays;
    std::optional<TreeComparison> compared;
    std::vector<Event> happened;
    std::vector<int> reachedAt, returnedAt, shadowAt, cappedAt; // step after which it is so
    int selectedNode = 0, hoveredNode = -1, steps = 0;
    bool playing = false, normals = true, help = false, showsOther = true;
    bool stepping = false; // the user walks through the events, rather than looking at all of them
    std::array<bool, kinds> shown{true, true, true, true, true};
    double leastThroughput = 0;
    double playSpeed = 2;
    std::optional<int> chosenDepth; // by the user: it outlives what the file says
    Look theme = Look::dark;
    std::string said, treeProblem, pictureProblem;
    Tone saidAs = Tone::trouble;
    std::shared_ptr<CoarsePictures> coarse = std::make_shared<CoarsePictures>();           // of what is painted now
    std::shared_ptr<std::atomic<double>> share = std::make_shared<std::atomic<double>>(0); // likewise
    int sharesTold = 0;                                                                    // in percent
    Background<Image> painter;
    Background<Trees> tracer;

    bool asksOthers() const { return session.source.isSlow || (session.other && session.other->isSlow); }
    /// What it does needs nothing of the controller: it may run in another thread.
    static Trees trace(const Session& session, const std::atomic<bool>& stop);
    bool takeScene();
    void traceTree(unsigned also = 0);
    void take(Trees&& trees);
    void indexEvents();
    void compare(const RayTree& other);
    void paintPicture();
    unsigned takePicture(std::chrono::milliseconds patience);
    void notify(unsigned what) const;
};

} // namespace rt::viz
