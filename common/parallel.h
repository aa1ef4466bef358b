// Independent pieces of work on oneTBB.
#pragma once

#ifndef RAYTREE_ONE_THREAD
#include <tbb/parallel_for.h>
#endif

namespace rt
{

/// Calls body(0) .. body(count - 1), in any order and at the same time. A program of one thread is compiled with
/// RAYTREE_ONE_THREAD and needs no oneTBB: the sandboxed ones of the grader.
template <class Body>
void forEach(int count, const Body& body)
{
#ifdef RAYTREE_ONE_THREAD
    for (int i = 0; i < count; ++i) body(i);
#else
    tbb::parallel_for(0, count, body);
#endif
}

} // namespace rt
