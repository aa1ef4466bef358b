// What the misbehaving student of the tests does, by the number that it is asked with.
#pragma once

namespace rt::grade
{

enum class Way
{
    behave,
    abort,
    recurse,
    loop,
    sleep,
    exit,
    print,
    printMuch,
    garbage,
    otherSequence,
    hugeAnswer,
    longAnswer,
    halfAnswer,
    flood,
    closeAnswers,
    throwText,
    throwNumber,
    throwMemory,
    eatMemory,
    ownMark,
    foreignMark,
    inventedMark
};

} // namespace rt::grade
