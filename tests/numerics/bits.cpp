// Prints a checksum of random pictures in every precision. check_arithmetic.py builds on it: the bits may not depend on how
// the compiler optimises.
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "common/program/guarded_main.h"
#include "common/scene/pixel.h"
#include "lessons/08_phong/trace.h"
#include "tests/common/random_scene.h"

namespace
{

template <class Real>
std::uint64_t checksum()
{
    using namespace rt;
    const FeatureSet all{Feature::direct,     Feature::mirror,  Feature::partial,  Feature::sky,
                         Feature::refraction, Feature::fresnel, Feature::policies, Feature::phong};
    std::uint64_t sum = 14695981039346656037ULL; // FNV-1a
    for (unsigned seed = 0; seed < 12; ++seed)
    {
        const Scene<Real> scene(randomScene(seed, all));
        lesson08::Tracer<Real> tracer{scene};
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x)
            {
                const Vec3<Real> color = renderPixel(scene, tracer, x, y, 1);
                for (int c = 0; c < 3; ++c)
                {
                    // A long double has padding: its value is cut into two doubles.
                    const double high = double(color[c]), parts[] = {high, double(color[c] - Real(high))};
                    unsigned char bytes[sizeof parts];
                    std::memcpy(bytes, parts, sizeof parts);
                    for (const unsigned char byte : bytes) sum = (sum ^ byte) * 1099511628211ULL;
                }
            }
    }
    return sum;
}

int run()
{
    std::printf("float %016" PRIx64 ", double %016" PRIx64 ", long double %016" PRIx64 "\n", checksum<float>(),
                checksum<double>(), checksum<long double>());
    return 0;
}

} // namespace

int main(int, char** argv)
{
    return rt::guarded(argv, [] { return run(); });
}
