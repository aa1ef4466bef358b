// Keys without return, for as long as this object lives; and what the terminal can show.
#pragma once

#include <optional>

namespace rt::grade
{

class Keys
{
public:
    /// Does nothing if standard input is no terminal.
    Keys();
    Keys(const Keys&) = delete;
    Keys& operator=(const Keys&) = delete;
    ~Keys();

    /// The next key, or nothing after so many seconds, at a signal, or if there is no terminal. 'q' when the terminal is gone.
    std::optional<char> read(double seconds);
};

bool isTerminal();    ///< standard input and output are one
bool showsColor();    ///< standard output is a terminal, and neither NO_COLOR nor TERM=dumb asks to do without
bool showsPictures(); ///< 24-bit colours, and room for three small pictures

} // namespace rt::grade
