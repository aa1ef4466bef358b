// What goes between the grader and a student's process: requests to its standard input, answers from its descriptor 3.
#pragma once

#include "tests/grade/wire/bytes.h"

namespace rt::grade
{

/// What is asked. `scene` sets the scene that color, tree and picture are about; a process keeps it.
enum class Function : std::uint32_t
{
    scene,
    color,
    tree,
    picture,
    toSphere,
    toPlane,
    reflect,
    latLong,
    refract,
    cosSquared2,
    fresnel,
    schlick,
    phong,
    slopeIntercept,
    yAt,
    implicitForm,
    normals2,
    distanceToOrigin,
    withUnitNormal,
    segmentLength,
    parametricForm,
    normals3,
    unitNormal
};

/// How it went. All but `ok` bring a text.
enum class Status : std::uint32_t
{
    ok,
    notAttempted, ///< with the exercise's id
    threw,        ///< with what it said
    outOfMemory
};

inline constexpr std::uint32_t requestMagic = 0x51547452, answerMagic = 0x41547452; // "RtTQ", "RtTA"
inline constexpr std::uint32_t wireVersion = 1;
inline constexpr std::size_t largestRequest = std::size_t(64) << 20; ///< bytes of payload: a sky of 2048x1024
inline constexpr std::size_t largestAnswer = std::size_t(4) << 20;   ///< bytes of payload: a picture of 480x360

struct RequestHead
{
    std::uint32_t sequence = 0;
    Function function = Function::scene;
    std::uint32_t size = 0; ///< bytes of payload that follow
    static constexpr std::size_t bytes = 20;
};

struct AnswerHead
{
    std::uint32_t sequence = 0; ///< the request's
    Status status = Status::ok;
    std::uint32_t size = 0;
    static constexpr std::size_t bytes = 16;
};

inline std::string frame(const RequestHead& head, std::string_view payload)
{
    Writer writer;
    for (const auto word :
         {requestMagic, wireVersion, head.sequence, std::uint32_t(head.function), std::uint32_t(payload.size())})
        writer.plain(word);
    return writer.bytes.append(payload);
}

inline std::string frame(const AnswerHead& head, std::string_view payload)
{
    Writer writer;
    for (const auto word : {answerMagic, head.sequence, std::uint32_t(head.status), std::uint32_t(payload.size())})
        writer.plain(word);
    return writer.bytes.append(payload);
}

/// The words of a head. Throws FrameError if there are more or fewer bytes.
template <std::size_t count>
std::array<std::uint32_t, count> words(std::string_view bytes)
{
    std::array<std::uint32_t, count> all{};
    Reader reader(bytes);
    for (auto& word : all) reader.plain(word);
    reader.end();
    return all;
}

inline RequestHead requestHead(std::string_view bytes)
{
    const auto [magic, version, sequence, function, size] = words<5>(bytes);
    if (magic != requestMagic || version != wireVersion) throw FrameError("it does not begin like a request");
    if (function > std::uint32_t(Function::unitNormal))
        throw FrameError("there is no function " + std::to_string(function));
    if (size > largestRequest) throw FrameError("a request of " + std::to_string(size) + " bytes is too large");
    return {sequence, Function(function), size};
}

inline AnswerHead answerHead(std::string_view bytes)
{
    const auto [magic, sequence, status, size] = words<4>(bytes);
    if (magic != answerMagic) throw FrameError("it does not begin like an answer");
    if (status > std::uint32_t(Status::outOfMemory)) throw FrameError("there is no status " + std::to_string(status));
    if (size > largestAnswer) throw FrameError("an answer of " + std::to_string(size) + " bytes is too large");
    return {sequence, Status(status), size};
}

} // namespace rt::grade
