// The student's process: answers requests until there are no more. It is compiled once, without the exercise; it holds no
// expected values and gives no verdict. Beyond what the exercise does it needs read, write, memory and exit.
#include <cstdio>
#include <new>
#include <tuple>

#include <unistd.h>

#include "tests/grade/wire/functions.h"
#include "tests/grade/wire/payload.h"
#include "tests/grade/wire/student.h"

namespace rt
{

RAYTREE_SCENE(, double)
template class TreeRecorder<double>;

namespace grade
{

namespace
{

constexpr int answers = 3; ///< the descriptor
constexpr int broken = 70; ///< exit code: the grader does not speak as it should, or has gone

/// False at the end of the input.
bool readAll(char* to, std::size_t count)
{
    for (std::size_t done = 0; done < count;)
    {
        const auto got = ::read(STDIN_FILENO, to + done, count - done);
        if (got == 0 && done == 0) return false;
        if (got <= 0) ::_exit(broken);
        done += std::size_t(got);
    }
    return true;
}

void writeAll(std::string_view bytes)
{
    while (!bytes.empty())
    {
        const auto put = ::write(answers, bytes.data(), bytes.size());
        if (put <= 0) ::_exit(broken);
        bytes.remove_prefix(std::size_t(put));
    }
}

template <class R, class... Args>
std::string call(const std::function<R(Args...)>& function, std::string_view payload)
{
    std::tuple<std::decay_t<Args>...> arguments;
    Reader reader(payload);
    std::apply([&](auto&... each) { all(reader, each...); }, arguments);
    reader.end();
    if (!function) throw std::runtime_error("the exercise does not have this function");
    return encode(std::apply(function, arguments));
}

class Runner
{
public:
    explicit Runner(const Student& of) : student(of) {}

    /// The payload of the answer.
    std::string answer(Function function, std::string_view payload)
    {
        if (function == Function::scene)
        {
            scene = decode<SceneDescription>(payload);
            return {};
        }
        if (function == Function::color) return call(about(student.tracer.color), payload);
        if (function == Function::tree) return call(about(student.tracer.tree), payload);
        if (function == Function::picture) return call(about(student.tracer.picture), payload);
        std::string bytes;
        const auto tryOne = [&](Function number, const auto& which) {
            if (number == function) bytes = call(which, payload);
        };
        eachFormula(student.tracer, tryOne);
        eachGeometry(student.geometry, tryOne);
        return bytes;
    }

private:
    Student student;
    SceneDescription scene;

    /// The function with the scene that was sent before.
    template <class R, class... Args>
    std::function<R(Args...)> about(const std::function<R(const SceneDescription&, Args...)>& function)
    {
        if (!function) return {};
        return [&](Args... arguments) { return function(scene, arguments...); };
    }
};

std::string cut(const char* text)
{
    return std::string(text ? text : "").substr(0, 1000);
}

/// The status and the payload.
std::pair<Status, std::string> tried(Runner& runner, Function function, std::string_view payload)
{
    try
    {
        std::string bytes = runner.answer(function, payload);
        if (bytes.size() > largestAnswer) return {Status::threw, "the answer is larger than 4 MiB"};
        return {Status::ok, std::move(bytes)};
    }
    catch (const NotAttempted& mark)
    {
        return {Status::notAttempted, cut(mark.id.c_str())};
    }
    catch (const std::bad_alloc&)
    {
        return {Status::outOfMemory, "std::bad_alloc"};
    }
    catch (const std::exception& error)
    {
        return {Status::threw, cut(error.what())};
    }
    catch (...)
    {
        return {Status::threw, "something that is no std::exception"};
    }
}

int run()
{
    Runner runner(makeStudent());
    char head[RequestHead::bytes];
    for (std::string payload; readAll(head, sizeof head);)
    {
        const auto request = requestHead({head, sizeof head});
        payload.resize(request.size);
        if (request.size > 0 && !readAll(payload.data(), payload.size())) return broken;
        const auto [status, bytes] = tried(runner, request.function, payload);
        std::fflush(stdout); // what the exercise printed so far; never to the descriptor of the answers
        writeAll(frame(AnswerHead{request.sequence, status}, bytes));
    }
    return 0;
}

} // namespace

} // namespace grade

} // namespace rt

int main()
{
    return rt::grade::run();
}
