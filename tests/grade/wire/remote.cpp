#include "tests/grade/wire/remote.h"

#include <algorithm>
#include <chrono>
#include <map>

#include <fmt/format.h>

#include "tests/grade/box/child.h"
#include "tests/grade/wire/exercise_ids.h"
#include "tests/grade/wire/functions.h"
#include "tests/grade/wire/payload.h"

namespace rt::grade
{

namespace
{

constexpr int mostDeaths = 20;
constexpr int mostSilent =
    3; ///< processes in a row that ended before their first answer: no question is to blame for that
constexpr std::size_t processesHeard = 4, textKept = 4096;

/// A student's numbers come from other formulas than the lesson's, and that is fine: with this epsilon the 64 units in the
/// last place that cases allow are 6e-8, a millionth of what an eye sees and a thousandth of what a mistake costs. It also
/// lets stored pictures differ at edges, as in single precision.
constexpr double studentEpsilon = 0x1p-30;

} // namespace

struct Remote::State
{
    /// FNV-1a, 64 bit (Fowler, Noll, Vo).
    class Hash
    {
    public:
        void add(std::string_view bytes)
        {
            for (const char byte : bytes) value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
        }
        std::uint64_t value = 0xcbf29ce484222325;
    };

    Box box;
    std::string program;
    int lesson = 0;
    Limits limits;
    std::vector<std::string> ids;

    std::unique_ptr<Child> child;
    std::string scene; ///< that it has, as bytes
    std::uint32_t sequence = 0;
    double waited = 0; ///< in seconds
    bool hung = false; ///< one of them did not answer in time
    int deaths = 0;
    int silent = 0;        ///< see mostSilent
    std::size_t ended = 0; ///< processes
    std::string printed;
    Hash hash;

    void start()
    {
        // How old a process gets says nothing: it waits most of its life. What it makes us wait is counted here.
        Limits ageless = limits;
        ageless.wallSeconds = 1e6;
        try
        {
            child = std::make_unique<Child>(box, program, ageless);
        }
        catch (const std::runtime_error& error)
        {
            throw GraderError(error.what());
        }
        scene.clear();
        greet();
    }

    /// An empty scene is a question that costs nothing: whoever answers it has started, and later ones need no time for that.
    void greet()
    {
        const Hash before = hash; // it is no answer of the exercise's
        ++silent;
        exchange(Function::scene, encode(SceneDescription{}), secondsToStart());
        silent = 0;
        hash = before;
    }

    /// Nothing of what it was asked, or did, counts any more; only whether it starts at all.
    void renew()
    {
        if (child) finish();
        deaths = 0;
        waited = 0;
        hung = false;
    }

    Child::End finish()
    {
        const auto ending = std::move(child);
        try
        {
            const auto end = ending->finish();
            if (ended++ < processesHeard) printed += ending->text().substr(0, textKept);
            return end;
        }
        catch (const std::runtime_error& error)
        {
            throw GraderError(error.what());
        }
    }

    [[noreturn]] void give(Outcome outcome, const std::string& sentence)
    {
        ++deaths;
        throw Died(outcome, sentence);
    }

    /// It still runs, but is asked no more.
    [[noreturn]] void stop(Outcome outcome, const std::string& sentence)
    {
        finish();
        give(outcome, sentence);
    }

    /// It ended before it had answered, or does not read.
    [[noreturn]] void gone()
    {
        const auto end = finish();
        if (end.outcome == Outcome::passed) give(Outcome::protocol, "it ended without an answer");
        give(end.outcome, end.sentence);
    }

    /// One question and its answer. Only the payload of an `ok` comes back.
    std::string exchange(Function function, std::string_view payload, double seconds)
    {
        using Clock = std::chrono::steady_clock;
        const double most = std::min(seconds, limits.wallSeconds - waited);
        const auto begin = Clock::now();
        const auto used = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
        const auto count = [&] { waited += used(); };
        const auto receive = [&](std::size_t size) {
            std::string bytes;
            const auto got = child->receive(bytes, size, std::max(0.0, most - used()));
            if (got == Child::Got::all) return bytes;
            count();
            if (got == Child::Got::ended) gone();
            hung = true;
            stop(Outcome::timedOut,
                 waited >= limits.wallSeconds
                     ? fmt::format("all answers together took more than {:.3g} s", limits.wallSeconds)
                     : fmt::format("it did not answer within {:.3g} s", seconds));
        };

        const RequestHead question{++sequence, function, std::uint32_t(payload.size())};
        if (!child->send(frame(question, payload), most))
        {
            count();
            gone();
        }
        AnswerHead head;
        std::string bytes = receive(AnswerHead::bytes);
        try
        {
            head = answerHead(bytes);
            if (head.sequence != sequence)
                throw FrameError(fmt::format("it answers question {}, asked was {}", head.sequence, sequence));
        }
        catch (const FrameError& error)
        {
            stop(Outcome::protocol, fmt::format("its answer is malformed: {}", error.what()));
        }
        bytes = receive(head.size);
        count();
        hash.add(std::string(1, char(head.status)));
        hash.add(bytes);
        judge(head.status, bytes, function == Function::scene);
        return bytes;
    }

    /// Throws unless it is `ok`.
    void judge(Status status, const std::string& text, bool isScene)
    {
        if (status == Status::ok) return;
        if (status == Status::outOfMemory) stop(Outcome::outOfMemory, "it needs more memory than there is");
        if (isScene) stop(Outcome::protocol, "its answer is malformed: it refuses the scene");
        if (status == Status::threw) throw std::runtime_error("an exception: " + text);
        if (std::find(ids.begin(), ids.end(), text) == ids.end())
            stop(Outcome::protocol, "its answer is malformed: it names an exercise that this lesson does not have");
        throw NotAttempted(text);
    }

    void begin()
    {
        if (deaths >= mostDeaths)
            throw Died(Outcome::notRun, fmt::format("it is not asked any more: it ended {} times", deaths));
        if (waited >= limits.wallSeconds)
            throw Died(Outcome::notRun, fmt::format("it is not asked any more: its answers took {:.3g} s", waited));
        if (silent >= mostSilent)
            throw Died(Outcome::notRun, fmt::format("it is not asked any more: it did not start {} times", silent));
        if (!child) start();
    }

    double secondsFor(Function function) const
    {
        // The shares that make 2 and 10 of 24.
        return limits.wallSeconds * (function == Function::picture && !hung ? 5 : 1) / 12;
    }

    /// Other processes may be before it.
    double secondsToStart() const { return limits.wallSeconds * 5 / 12; }

    template <class R>
    R ask(Function function, std::string_view payload)
    {
        const std::string bytes = exchange(function, payload, secondsFor(function));
        try
        {
            return decode<R>(bytes);
        }
        catch (const FrameError& error)
        {
            stop(Outcome::protocol, fmt::format("its answer is malformed: {}", error.what()));
        }
    }

    /// Sends the scene unless the process has it.
    void show(const SceneDescription& description)
    {
        std::string bytes;
        try
        {
            bytes = encode(description);
        }
        catch (const FrameError& error)
        {
            throw GraderError(fmt::format("a scene cannot be sent: {}", error.what()));
        }
        if (bytes.size() > largestRequest)
            throw GraderError(fmt::format("a scene of {} bytes is too large for a question", bytes.size()));
        if (bytes == scene) return;
        scene.clear();
        if (!exchange(Function::scene, bytes, secondsFor(Function::scene)).empty())
            stop(Outcome::protocol, "its answer is malformed: there is nothing to say to a scene");
        scene = std::move(bytes);
    }
};

namespace
{

/// In the box, lesson 01's shapes.h has no formulas, and the recorder could not look for what stands in a shadow ray's way.
/// That is no part of the exercise.
void findBlockers(RayTree& tree, const SceneDescription& description)
{
    const Scene<double> scene(description);
    std::map<std::string, PrimitiveId> ids;
    const auto primitives = PrimitiveId(scene.spheres.size() + scene.planes.size() + scene.triangles.size());
    for (PrimitiveId id = 0; id < primitives; ++id) ids[scene.primitiveName(id)] = id;
    for (auto& shadow : tree.shadows)
    {
        const auto& from = tree.nodes[std::size_t(shadow.node)].hit;
        if (shadow.visible || shadow.blocker || !from) continue;
        const auto id = ids.find(from->primitive);
        const Ray<double> ray{
            .O = from->point, .D = shadow.direction, .from = id == ids.end() ? noPrimitive : id->second};
        if (const auto hit = scene.intersect(ray))
            shadow.blocker = {scene.primitiveName(hit->I.on), Vec3<double>(hit->I)};
    }
}

} // namespace

Remote::Remote(const Box& box, const std::string& program, int lesson, const Limits& limits)
    : state(std::make_shared<State>())
{
    state->box = box;
    state->program = program;
    state->lesson = lesson;
    state->limits = limits;
    state->ids = exerciseIds(lesson);
}

Candidate Remote::candidate() const
{
    using cases::V;
    Candidate candidate = reference(state->lesson); // which functions there are; all are replaced
    const auto connect = [s = state]<class R, class... Args>(Function number, std::function<R(Args...)>& function) {
        if (!function) return;
        function = [s, number](Args... arguments) {
            s->begin();
            Writer writer;
            all(writer, arguments...);
            return s->template ask<R>(number, writer.bytes);
        };
    };
    eachFormula(candidate.tracer, connect);
    eachGeometry(candidate.geometry, connect);
    candidate.tracer.epsilon = candidate.geometry.epsilon = studentEpsilon;
    candidate.fingerprint = [s = state] { return std::exchange(s->hash, {}).value; };
    if (state->lesson == 0) return candidate;

    const auto aboutRay = [s = state]<class R>(Function number, const SceneDescription& scene, const V& origin,
                                               const V& direction, R*) {
        s->begin();
        s->show(scene);
        return s->template ask<R>(number, encode(std::array{origin, direction}));
    };
    candidate.tracer.color = [aboutRay](const SceneDescription& scene, const V& origin, const V& direction) {
        return aboutRay(Function::color, scene, origin, direction, static_cast<V*>(nullptr));
    };
    candidate.tracer.tree = [aboutRay, s = state](const SceneDescription& scene, const V& origin, const V& direction) {
        RayTree tree = aboutRay(Function::tree, scene, origin, direction, static_cast<RayTree*>(nullptr));
        if (tree.maxDepth != scene.trace.maxDepth || tree.version != 1)
            s->stop(Outcome::protocol, "its answer is malformed: the tree is not of this scene");
        if (s->lesson == 1) findBlockers(tree, scene);
        return tree;
    };
    candidate.tracer.picture = [s = state](const SceneDescription& scene) {
        const int width = scene.camera.width, height = scene.camera.height;
        if (std::size_t(width) * std::size_t(height) * sizeof(V) > largestAnswer - 2 * sizeof(int))
            throw GraderError(fmt::format("a picture of {}x{} pixels is too large for an answer", width, height));
        s->begin();
        s->show(scene);
        Image image = s->ask<Image>(Function::picture, {});
        if (image.width != width || image.height != height)
            s->stop(Outcome::protocol,
                    fmt::format("its answer is malformed: a picture of {}x{} pixels, asked was {}x{}", image.width,
                                image.height, width, height));
        return image;
    };
    return candidate;
}

Candidate Remote::afresh() const
{
    state->renew();
    return candidate();
}

std::string Remote::text()
{
    if (state->child) state->finish();
    return state->printed;
}

int Remote::deaths() const
{
    return state->deaths;
}

Candidate remoteCandidate(const Box& box, const std::string& program, int lesson, const Limits& limits)
{
    return Remote(box, program, lesson, limits).candidate();
}

} // namespace rt::grade
