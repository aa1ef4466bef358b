// Recorders only watch: which line of the algorithm it is that they tell about.
#pragma once

#include <vector>

#include "common/tree/events.h"
#include "viz/state/listing.h"

namespace rt::viz
{

/// What a recorder tells.
enum class Told
{
    value, ///< its last argument, as of rec.ray(ray, hit) the hit
    end    ///< that a ray returns, or is not followed
};

Told toldBy(Event::Kind kind);

/// One rule for all sources. A value belongs to the nearest line above in the same function that sets it; an end to the
/// nearest `return` below. What is not found so stays in the recorder's own line, as does a line that holds no recorder.
class AlgorithmLines
{
public:
    explicit AlgorithmLines(const Listing& listing);

    int of(int line, Told told) const;
    int of(const Event& event) const { return of(event.line, toldBy(event.kind)); }
    /// Where the event's ray is sent on its way: the line of its parent's that calls trace(ray.spawn(its kind, ...)). 0:
    /// unknown, or a camera ray.
    int callOf(const RayTree& tree, const Event& event) const;

private:
    struct Lines
    {
        int value = 0, end = 0;
        LineRange function;
    };
    struct Call
    {
        int line = 0;
        RayKind kind = RayKind::camera;
    };
    std::vector<Lines> lines; ///< of line 1 at place 0
    std::vector<Call> calls;
};

} // namespace rt::viz
