// Texts as coverage, each drawn by the font only once: for pictures with thousands of labels.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "viz/window/fonts.h"

namespace rt::viz
{

class Words
{
public:
    struct Word
    {
        int width = 0, height = 0;
        std::vector<unsigned char> coverage; ///< cropped to its ink, from the lower left
    };

    /// `size` in pixels.
    const Word& operator()(const std::string& text, Font font, int size);

private:
    std::unordered_map<std::string, Word> words;
};

} // namespace rt::viz
