// Work that goes on while the window stays alive.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>

namespace rt::viz
{

/// At most one piece of work at a time; a newer one replaces an older one. Owned and used by one thread.
template <class Result>
class Background
{
public:
    Background() = default;
    ~Background() { cancel(); }
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// `work` must look at `stop` often and return, with anything, once it is set. Does not wait for what is replaced: the
    /// new work's thread does, so that the two never run side by side.
    void start(std::function<Result(const std::atomic<bool>& stop)> work)
    {
        *stop = true;
        stop = std::make_shared<std::atomic<bool>>(false);
        result = std::async(std::launch::async, [before = std::move(result), stop = stop, work = std::move(work)]() {
            if (before.valid()) before.wait();
            return *stop ? Result() : work(*stop);
        });
    }

    bool isBusy() const { return result.valid(); }

    /// Without waiting: the result, once. Throws what the work threw.
    std::optional<Result> poll()
    {
        if (!isBusy() || result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
        return result.get();
    }

    /// Waits, at most that long; true if there is nothing to wait for any more.
    bool waitFor(std::chrono::milliseconds time) const
    {
        return !isBusy() || result.wait_for(time) == std::future_status::ready;
    }

    void cancel()
    {
        *stop = true;
        if (isBusy()) result.wait();
        result = {};
    }

private:
    std::shared_ptr<std::atomic<bool>> stop = std::make_shared<std::atomic<bool>>(false); // of the newest piece
    std::future<Result> result;
};

} // namespace rt::viz
