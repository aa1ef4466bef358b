#include "common/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace rt
{

void forEach(int count, const std::function<void(int)>& body)
{
    tbb::parallel_for(0, count, [&body](int i) { body(i); });
}

struct Workers::State
{
    explicit State(int threads)
        : limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads)), arena(threads)
    {
    }

    tbb::global_control limit;
    tbb::task_arena arena;
};

Workers::Workers(int threads)
    : state(std::make_unique<State>(threads > 0 ? threads : tbb::this_task_arena::max_concurrency()))
{
}

Workers::~Workers() = default;

void Workers::forEach(int count, const std::function<void(int)>& body)
{
    state->arena.execute([&] { rt::forEach(count, body); });
}

} // namespace rt
