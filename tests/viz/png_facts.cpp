// Prints "WIDTH HEIGHT COLOURS" of a picture.
#include <iostream>
#include <set>
#include <tuple>

#include "common/image.h"

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    try
    {
        const rt::Image image = rt::readImage(argv[1]);
        std::set<std::tuple<double, double, double>> colors;
        for (const auto& p : image.pixels) colors.emplace(p.x, p.y, p.z);
        std::cout << image.width << ' ' << image.height << ' ' << colors.size() << '\n';
    }
    catch (const std::exception& error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
