// A power of two changes no digit: whole pictures of scenes times 2^k have the same bits. Any hidden length, an epsilon
// above all, fails this.
#include <filesystem>

#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

const std::string lessonFolder = std::string(RAYTREE_SOURCE_DIR) + "/lessons";

/// Every scene file that comes with the lessons.
std::vector<std::string> shippedScenes()
{
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(lessonFolder))
        if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() == "scenes")
            files.push_back(std::filesystem::relative(entry.path(), lessonFolder).string());
    std::sort(files.begin(), files.end());
    return files;
}

/// A mesh, a triangle and a checker under a picture of a sky: what the shipped scenes may not have together.
SceneDescription meshUnderAPicture(SkyMapping mapping)
{
    auto scene = Build().material(grey(0.8)).plane({0, -1, 0}, {0.1, 1, 0.05}).light({3, 5, 4}, {40, 30, 20}).scene;
    scene.planes[0].hasChecker = true;
    scene.planes[0].checkerSize = 0.7;
    scene.materials.push_back(mirrorOf(0.9, 0.5));
    scene.materials.push_back(glassOf(1.5));
    scene.meshes.push_back(ballMesh({-1.1, 0.2, 0}, 0.9, 2));
    scene.meshes[0].material = 1;
    scene.meshes.push_back(ballMesh({1.2, 0.1, 0.3}, 0.8, 1));
    scene.meshes[1].material = 2;
    scene.triangles.push_back({{V(-3, -1, -2), V(3, -0.7, -2.2), V(0.3, 3, -1.7)}, 1});
    Image picture(16, 8);
    Random random(1);
    for (auto& pixel : picture.pixels) pixel = random.vector(0, 2);
    scene.sky.present = true;
    scene.sky.mapping = mapping;
    scene.sky.image = std::make_shared<const Image>(picture);
    scene.camera = {.eye = {0.3, 1, 5}, .target = {0, 0, 0}, .width = 64, .height = 48};
    return scene;
}

template <class Real>
void expectTheSameBitsAtEveryScale(const SceneDescription& scene, const std::string& name)
{
    const Image picture = pictureOf<Real>(scene);
    EXPECT_FALSE(std::all_of(picture.pixels.begin(), picture.pixels.end(), [](const auto& p) { return p == V(0); }))
        << name << " is black";
    for (const int k : {-30, -10, 10, 30})
    {
        const Image other = pictureOf<Real>(scaled(scene, std::ldexp(1.0, k)));
        int different = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) different += !(picture.pixels[i] == other.pixels[i]);
        EXPECT_EQ(different, 0) << name << " times 2^" << k << ": pixels differ";
    }
}

class ShippedScene : public testing::TestWithParam<std::string>
{
};

TEST_P(ShippedScene, HasTheSameBitsAtEveryScale)
{
    const auto scene = cases::smallScene("lessons/" + GetParam());
    expectTheSameBitsAtEveryScale<float>(scene, GetParam());
    expectTheSameBitsAtEveryScale<double>(scene, GetParam());
}

std::string nameOf(const testing::TestParamInfo<std::string>& info)
{
    std::string name = info.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(shippedScenes()), nameOf);

template <class Real>
class Scale : public testing::Test
{
};
TYPED_TEST_SUITE(Scale, Precisions);

TYPED_TEST(Scale, MeshesUnderAPictureHaveTheSameBitsAtEveryScale)
{
    for (const auto mapping : {SkyMapping::latlong, SkyMapping::angular})
        expectTheSameBitsAtEveryScale<TypeParam>(meshUnderAPicture(mapping), "mesh");
}

TYPED_TEST(Scale, AnyNumberOfThreadsGivesTheSameBits)
{
    using Real = TypeParam;
    for (const char* file : {"08_phong/scenes/everything.toml", "07_recursion_caps/scenes/mirror_box.toml"})
    {
        auto description = cases::smallScene(std::string("lessons/") + file);
        description.camera.width = 100; // tiles of 32: some are not full
        description.camera.height = 70;
        const Scene<Real> scene(description);
        const auto with = [&](int threads) {
            RenderOptions options;
            options.spp = 2;
            options.threads = threads;
            return render<lesson08::Tracer<Real>>(scene, 100, 70, options).pixels;
        };
        const auto one = with(1);
        EXPECT_TRUE(one == with(2)) << file;
        EXPECT_TRUE(one == with(7)) << file;
    }
}

} // namespace

} // namespace rt::numerics
