// Independent pieces of work on all cores.
#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace rt::lesson10
{

/// Calls work(0) .. work(count - 1), each once, in any order. The first exception is thrown on.
template <class Work>
void inParallel(std::size_t count, const Work& work)
{
    std::atomic<std::size_t> next = 0;
    std::vector<std::future<void>> workers;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        workers.push_back(std::async(std::launch::async, [&] {
            for (std::size_t n; (n = next++) < count;) work(n);
        }));
    for (auto& worker : workers) worker.get();
}

} // namespace rt::lesson10
