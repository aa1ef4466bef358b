// What children are left to when we are killed and can end none of them ourselves.
#pragma once

#include <sys/types.h>

namespace rt
{

/// A shell of its own, started by the first call, that waits until we are gone, however we ended, and then kills the process
/// groups that it was told of: a parent's death ends no child, and PR_SET_PDEATHSIG reaches neither a child's children nor one
/// whose thread goes on to live in another. Returns the descriptor by which it is told; -1 if it could not be started.
int keeper();

/// '+': the group is ours. '-': it is not any more, its number may go to another. May be called between fork and exec.
void tellKeeper(int keeper, char sign, pid_t group);

} // namespace rt
