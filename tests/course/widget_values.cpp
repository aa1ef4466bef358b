// What the notes' widgets compute, compiled as the lessons are. Each line of input, `name number ..`, is answered with the
// 16 numbers that the function leaves, in hexadecimal, so that no bit is lost.
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "common/program/guarded_main.h"
#include "slides-notes/site/widgets/formulas.cpp"

namespace
{

using Values = std::vector<double>;

const std::map<std::string, std::pair<std::size_t, void (*)(const Values&)>> functions{
    {"line", {4, [](const Values& v) { line(v[0], v[1], v[2], v[3]); }}},
    {"cosine", {2, [](const Values& v) { cosine(v[0], v[1]); }}},
    {"reflect", {2, [](const Values& v) { reflect(v[0], v[1]); }}},
    {"partial", {1, [](const Values& v) { partial(v[0]); }}},
    {"bowling", {2, [](const Values& v) { bowling(v[0], v[1]); }}},
    {"refract", {3, [](const Values& v) { refract(v[0], v[1], v[2]); }}},
    {"fresnel", {3, [](const Values& v) { fresnel(v[0], v[1], v[2]); }}},
    {"cap", {3, [](const Values& v) { cap(v[0], v[1], v[2]); }}},
    {"phong", {4, [](const Values& v) { phong(v[0], v[1], v[2], v[3]); }}},
};

int run()
{
    for (std::string text; std::getline(std::cin, text);)
    {
        std::istringstream words(text);
        std::string name;
        Values values;
        words >> name;
        for (std::string word; words >> word;) values.push_back(std::stod(word));
        const auto function = functions.find(name);
        if (function == functions.end() || function->second.first != values.size())
        {
            std::cerr << "widget_values: \"" << text << "\" is not a function of formulas.cpp with its numbers\n";
            return 2;
        }
        function->second.second(values);
        for (int i = 0; i < 16; ++i) std::printf("%a ", results()[i]);
        std::printf("\n");
    }
    return 0;
}

} // namespace

int main(int, char** argv)
{
    return rt::guarded(argv, [] { return run(); });
}
