// Prints "WIDTH HEIGHT COLOURS" of a picture.
#include <iostream>
#include <set>
#include <tuple>

#include "common/base/image.h"
#include "common/files/picture_file.h"
#include "common/program/guarded_main.h"

namespace
{

int run(int argc, char** argv)
{
    if (argc != 2) return 2;
    const rt::Image image = rt::readImage(argv[1]);
    std::set<std::tuple<double, double, double>> colors;
    for (const auto& p : image.pixels) colors.emplace(p.x, p.y, p.z);
    std::cout << image.width << ' ' << image.height << ' ' << colors.size() << '\n';
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
