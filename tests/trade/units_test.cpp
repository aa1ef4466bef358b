#include "lessons/10_speed_and_accuracy/study/units.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace rt::lesson10
{

TEST(Units, TimesAreReadInMillisecondsAndSeconds)
{
    EXPECT_DOUBLE_EQ(parseTime("100ms"), 0.1);
    EXPECT_DOUBLE_EQ(parseTime("2s"), 2);
    EXPECT_DOUBLE_EQ(parseTime("1.5 s"), 1.5);
    EXPECT_DOUBLE_EQ(parseTime("1e3 ms"), 1);
}

TEST(Units, DecibelsAreRead)
{
    EXPECT_EQ(parseDecibels("60dB"), 60);
    EXPECT_EQ(parseDecibels("60.5 dB"), 60.5);
}

TEST(Units, WhatIsNoQuantityIsRefusedWithAnExample)
{
    for (const char* text : {"", "ms", "100", "100 m", "100msx", "0ms", "-1s", "nans", "infs", "1e400s", "1e-323ms",
                             "60dB", "+1s", "1,5s"})
        EXPECT_THROW(parseTime(text), std::invalid_argument) << text;
    for (const char* text : {"", "dB", "60", "60db", "60 dBm", "0dB", "-3dB", "nandB", "infdB", "60ms"})
        EXPECT_THROW(parseDecibels(text), std::invalid_argument) << text;
    try
    {
        parseTime("soon");
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_STREQ(error.what(), "expected a time greater than 0 in ms or s, as in 100ms, got \"soon\"");
    }
}

TEST(Units, TextsHaveThreeDigitsAndTheUnitThatSuits)
{
    EXPECT_EQ(timeText(0.1), "100 ms");
    EXPECT_EQ(timeText(0.01234), "12.3 ms");
    EXPECT_EQ(timeText(0.001234), "1.23 ms");
    EXPECT_EQ(timeText(2.5), "2.50 s");
    EXPECT_EQ(timeText(0.9999), "1.00 s");
    EXPECT_EQ(decibelText(61.27), "61.3 dB");
    EXPECT_EQ(decibelText(std::numeric_limits<double>::infinity()), "same bits");
}

} // namespace rt::lesson10
