// What a tracer did for one pixel, one thing after the other: what a debugger steps through.
#pragma once

#include <string>
#include <vector>

#include "common/tree/ray_tree.h"

namespace rt
{

struct Event
{
    enum class Kind
    {
        follow,      ///< a ray is followed to what it hits
        shadow,      ///< a light is asked for
        notFollowed, ///< a ray is not followed: MAXDEPTH or cutoff
        returns      ///< a ray returns its colour
    };

    Kind kind = Kind::follow;
    int node = 0;
    int index = -1; ///< into tree.shadows or tree.capped; -1 otherwise
    int line = 0;   ///< of the tree's source; 0: unknown
};

/// Everything that happened, in order. A tree that does not know its steps is taken to follow a ray, ask its lights, leave
/// out what it leaves out, follow its children and return.
std::vector<Event> eventsOf(const RayTree& tree);

/// "reflected ray [1] hits sphere0 at t = 3.162": one line, without a full stop.
std::string describe(const RayTree& tree, const Event& event);

} // namespace rt
