// For the tests: an "exercise 05" that misbehaves on request. refract's n1 says how; fresnel and phong it has not.
#include <cstdio>
#include <cstdlib>
#include <new>

#include <unistd.h>

#include "tests/grade/wire/frames.h"
#include "tests/grade/wire/misbehaving.h"
#include "tests/grade/wire/student.h"

namespace
{

using namespace rt;
using namespace rt::grade;

volatile bool always = true;
int asked = 1; // the greeting is the first question

void put(const std::string& bytes)
{
    for (std::size_t done = 0; done < bytes.size();)
    {
        const auto count = ::write(3, bytes.data() + done, bytes.size() - done);
        if (count <= 0) ::_exit(1);
        done += std::size_t(count);
    }
}

void put(AnswerHead head, std::size_t bytes)
{
    put(frame(head, std::string(bytes, '\0')));
}

int deeper(int depth)
{
    volatile char room[1 << 12] = {};
    return always ? deeper(depth + 1) + room[7] : depth;
}

std::optional<cases::V> refract(const cases::V& D, const cases::V&, double how, double)
{
    ++asked;
    switch (Way(int(how)))
    {
    case Way::behave:
        return D;
    case Way::abort:
        std::abort();
    case Way::recurse:
        deeper(0);
        break;
    case Way::loop:
        while (always)
        {
        }
        break;
    case Way::sleep:
        while (always) ::sleep(1);
        break;
    case Way::exit:
        std::exit(0);
    case Way::print:
        std::printf("debug %d\n", asked);
        break;
    case Way::printMuch:
        for (int i = 0; i < 1 << 15; ++i) std::printf("debug %d\n", i);
        break;
    case Way::garbage:
        put("PASSED\n");
        break;
    case Way::otherSequence:
        put({12345, Status::ok, 1}, 1);
        break;
    case Way::hugeAnswer:
        put({std::uint32_t(asked), Status::ok, 0xffffffff}, 0);
        break;
    case Way::longAnswer:
        put({std::uint32_t(asked), Status::ok, 26}, 26);
        break;
    case Way::halfAnswer:
        put(frame(AnswerHead{std::uint32_t(asked), Status::ok, 25}, "").substr(0, 10));
        ::_exit(0);
    case Way::flood:
        while (always) put({std::uint32_t(asked), Status(99), 0}, 1 << 16);
        break;
    case Way::closeAnswers:
        ::close(3);
        break;
    case Way::throwText:
        throw std::runtime_error(std::string(5000, 'x'));
    case Way::throwNumber:
        throw 7;
    case Way::throwMemory:
        throw std::bad_alloc();
    case Way::eatMemory:
        for (std::string* all = nullptr; always;) all = new std::string(std::size_t(1) << 24, char(all != nullptr));
        break;
    case Way::ownMark:
        throw NotAttempted("05-refract");
    case Way::foreignMark:
        throw NotAttempted("06-fresnel");
    case Way::inventedMark:
        throw NotAttempted("05-");
    }
    return D;
}

} // namespace

rt::grade::Student rt::grade::makeStudent()
{
    Student student;
    student.tracer.refract = ::refract;
    student.tracer.picture = [](const SceneDescription& scene) {
        return Image(scene.camera.width, scene.camera.height - 1);
    };
    student.tracer.tree = [](const SceneDescription& scene, const cases::V& origin, const cases::V&) {
        RayTree tree;
        tree.maxDepth = scene.trace.maxDepth;
        tree.nodes.resize(std::size_t(origin.x));
        tree.shadows.resize(std::size_t(origin.y));
        return tree;
    };
    return student;
}
