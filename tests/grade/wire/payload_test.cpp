// Everything that is sent comes back with its bits, and no other bytes do harm.
#include "tests/grade/wire/payload.h"

#include <random>
#include <tuple>

#include <sys/resource.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "common/files/scene_file.h"
#include "tests/cases/cases.h"
#include "tests/grade/wire/frames.h"

namespace rt::grade
{

namespace
{

using Random = std::mt19937_64;

// The members of each struct, taken apart by the compiler: one that is added and not sent does not compile here, or comes back
// as it was made.

auto members(CameraDescription& c)
{
    auto& [eye, target, up, fov, width, height, pixelX, pixelY] = c;
    (void)pixelX, (void)pixelY; // not sent: nobody clicks
    return std::tie(eye, target, up, fov, width, height);
}
auto members(TraceSettings& t)
{
    auto& [maxDepth, cutoff, atCap, fresnel, shadow] = t;
    return std::tie(maxDepth, cutoff, atCap, fresnel, shadow);
}
auto members(Sun& s)
{
    auto& [direction, color, size] = s;
    return std::tie(direction, color, size);
}
auto members(SkyDescription& s)
{
    auto& [present, color, zenith, sun, file, mapping, image] = s;
    (void)file; // not sent
    return std::tie(present, color, zenith, sun, mapping, image);
}
auto members(Material<double>& m)
{
    auto& [name, color, mirror, ior, outside, glossy, exponent] = m;
    return std::tie(name, color, mirror, ior, outside, glossy, exponent);
}
auto members(SphereDescription& s)
{
    auto& [center, radius, material] = s;
    return std::tie(center, radius, material);
}
auto members(PlaneDescription& p)
{
    auto& [point, normal, material, has, color, size] = p;
    return std::tie(point, normal, material, has, color, size);
}
auto members(TriangleDescription& t)
{
    auto& [vertices, material] = t;
    return std::tie(vertices, material);
}
auto members(MeshDescription& m)
{
    auto& [file, triangles, material] = m;
    return std::tie(file, triangles, material);
}
auto members(Light<double>& l)
{
    auto& [position, color] = l;
    return std::tie(position, color);
}
auto members(SceneDescription& s)
{
    auto& [file, title, camera, trace, sky, materials, spheres, planes, triangles, meshes, lights, warnings, places] =
        s;
    (void)file, (void)title, (void)warnings, (void)places; // not sent
    return std::tie(camera, trace, sky, materials, spheres, planes, triangles, meshes, lights);
}
auto members(Image& i)
{
    auto& [width, height, pixels] = i;
    return std::tie(width, height, pixels);
}
auto members(RayTree::Hit& h)
{
    auto& [t, point, normal, primitive, material, inside, color] = h;
    return std::tie(t, point, normal, primitive, material, inside, color);
}
auto members(RayTree::Node& n)
{
    auto& [id, parent, kind, depth, origin, direction, hit, n1, n2, fresnel, weight, throughput, radiance, own,
           contribution, end, tir, orphan, line, returnLine, step, returnStep] = n;
    return std::tie(id, parent, kind, depth, origin, direction, hit, n1, n2, fresnel, weight, throughput, radiance, own,
                    contribution, end, tir, orphan, line, returnLine, step, returnStep);
}
auto members(RayTree::Shadow::Blocker& b)
{
    auto& [primitive, point] = b;
    return std::tie(primitive, point);
}
auto members(RayTree::Shadow& s)
{
    auto& [node, light, direction, distance, visible, tint, blocker, line, step] = s;
    return std::tie(node, light, direction, distance, visible, tint, blocker, line, step);
}
auto members(RayTree::Capped& c)
{
    auto& [node, kind, direction, weight, radiance, reason, line, step] = c;
    return std::tie(node, kind, direction, weight, radiance, reason, line, step);
}
auto members(RayTree& t)
{
    auto& [version, lesson, scene, source, real, pixel, maxDepth, nodes, shadows, capped] = t;
    return std::tie(version, lesson, scene, source, real, pixel, maxDepth, nodes, shadows, capped);
}
template <class A, class B>
auto members(std::pair<A, B>& p)
{
    auto& [first, second] = p;
    return std::tie(first, second);
}
auto members(lesson00::Implicit& l)
{
    auto& [A, B, C] = l;
    return std::tie(A, B, C);
}

template <class T>
inline constexpr bool isShared = false;
template <class T>
inline constexpr bool isShared<std::shared_ptr<const T>> = true;
template <class T>
inline constexpr bool isVector = std::is_same_v<T, Vec3<double>> || std::is_same_v<T, glm::dvec2>;

int below(Random& random, int count)
{
    return std::uniform_int_distribution<int>(0, count - 1)(random);
}

/// Anything: doubles of any bits, NaN too.
template <class T>
void fill(Random& random, T& value)
{
    if constexpr (std::is_same_v<T, double>)
        value = std::bit_cast<double>(random());
    else if constexpr (std::is_same_v<T, int>)
        value = int(random());
    else if constexpr (std::is_same_v<T, bool>)
        value = random() % 2;
    else if constexpr (std::is_enum_v<T>)
        value = T(below(random, 2)); // all have at least two
    else if constexpr (std::is_same_v<T, std::string>)
    {
        value.resize(std::size_t(below(random, 9)));
        for (auto& c : value) c = char(random());
    }
    else if constexpr (isVector<T>)
        for (int i = 0; i < int(T::length()); ++i) fill(random, value[i]);
    else if constexpr (detail::isArray<T>)
        for (auto& one : value) fill(random, one);
    else if constexpr (detail::isOptional<T>)
    {
        value.reset();
        if (random() % 2) fill(random, value.emplace());
    }
    else if constexpr (detail::isList<T>)
    {
        value.resize(std::size_t(below(random, 4)));
        for (auto& one : value) fill(random, one);
    }
    else if constexpr (isShared<T>)
    {
        auto made = std::make_shared<std::remove_const_t<typename T::element_type>>();
        fill(random, *made);
        value = made;
    }
    else
        std::apply([&](auto&... each) { (fill(random, each), ...); }, members(value));
}

/// Bit for bit.
template <class T>
bool same(T& a, T& b)
{
    if constexpr (std::is_same_v<T, double>)
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>)
        return a == b;
    else if constexpr (isVector<T>)
    {
        for (int i = 0; i < int(T::length()); ++i)
            if (!same(a[i], b[i])) return false;
        return true;
    }
    else if constexpr (detail::isOptional<T>)
        return a.has_value() == b.has_value() && (!a || same(*a, *b));
    else if constexpr (detail::isList<T> || detail::isArray<T>)
    {
        if (a.size() != b.size()) return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!same(a[i], b[i])) return false;
        return true;
    }
    else if constexpr (isShared<T>)
    {
        using Value = std::remove_const_t<typename T::element_type>;
        return bool(a) == bool(b) && (!a || same(const_cast<Value&>(*a), const_cast<Value&>(*b)));
    }
    else
        return [&]<std::size_t... i>(std::index_sequence<i...>)
        {
            auto one = members(a), other = members(b);
            return (same(std::get<i>(one), std::get<i>(other)) && ...);
        }
    (std::make_index_sequence<std::tuple_size_v<decltype(members(a))>>());
}

// What the checks ask for.

void repair(Random& random, Image& image)
{
    image = Image(below(random, 4), below(random, 4));
    for (auto& pixel : image.pixels) fill(random, pixel);
}

void repair(Random& random, SceneDescription& scene)
{
    scene.camera.width = 1 + below(random, largestPictureSide);
    scene.camera.height = 1 + below(random, largestPictureSide);
    Image image(2, 3);
    for (auto& pixel : image.pixels) fill(random, pixel);
    scene.sky.image = random() % 2 ? std::make_shared<const Image>(image) : nullptr;
    scene.materials.resize(scene.materials.size() + 1);
    const auto choose = [&](auto& objects) {
        for (auto& object : objects) object.material = below(random, int(scene.materials.size()));
    };
    choose(scene.spheres);
    choose(scene.planes);
    choose(scene.triangles);
    choose(scene.meshes);
}

void repair(Random& random, RayTree& tree)
{
    const auto whole = [&](auto&... numbers) { ((numbers = below(random, 1 << 20)), ...); };
    for (int id = 0; id < int(tree.nodes.size()); ++id)
    {
        auto& node = tree.nodes[std::size_t(id)];
        node.id = id;
        node.parent = below(random, id + 1) - 1;
        whole(node.depth, node.line, node.returnLine, node.step, node.returnStep);
        if (!node.n1 || !node.n2) node.n1 = node.n2 = std::nullopt;
    }
    if (tree.nodes.empty())
    {
        tree.shadows.clear();
        tree.capped.clear();
    }
    for (auto& shadow : tree.shadows)
    {
        shadow.node = below(random, int(tree.nodes.size()));
        whole(shadow.light, shadow.line, shadow.step);
    }
    for (auto& capped : tree.capped)
    {
        capped.node = below(random, int(tree.nodes.size()));
        whole(capped.line, capped.step);
    }
}

template <class T>
void repair(Random&, T&)
{
}

template <class T>
T some(std::uint64_t seed)
{
    Random random(seed);
    T value{};
    fill(random, value);
    repair(random, value);
    return value;
}

/// At most so much more memory while this lives: what is refused must not be allocated first.
class LittleMemory
{
public:
    LittleMemory()
    {
#ifndef __SANITIZE_ADDRESS__ // which needs all of it
        ::getrlimit(RLIMIT_AS, &before);
        long pages = 0;
        if (auto* file = std::fopen("/proc/self/statm", "r"))
        {
            if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
            std::fclose(file);
        }
        rlimit little = before;
        little.rlim_cur = rlim_t(pages) * 4096 + (rlim_t(64) << 20);
        if (pages > 0) ::setrlimit(RLIMIT_AS, &little);
        limited = pages > 0;
#endif
    }
    LittleMemory(const LittleMemory&) = delete;
    LittleMemory& operator=(const LittleMemory&) = delete;
    ~LittleMemory()
    {
        if (limited) ::setrlimit(RLIMIT_AS, &before);
    }

private:
    rlimit before{};
    bool limited = false;
};

/// True if it was refused; anything but a value or FrameError ends the test.
template <class T>
bool refuses(std::string_view bytes)
{
    try
    {
        const T value = decode<T>(bytes);
        EXPECT_TRUE(encode(value) == bytes) << "what was taken is told again otherwise";
        return false;
    }
    catch (const FrameError& error)
    {
        EXPECT_STRNE(error.what(), "");
        return true;
    }
}

template <class T>
class Payload : public testing::Test
{
};

using Payloads =
    testing::Types<SceneDescription, RayTree, Image, Vec3<double>, std::optional<Vec3<double>>, std::array<double, 2>,
                   std::pair<glm::dvec2, glm::dvec2>, lesson00::Implicit, std::string, double>;
TYPED_TEST_SUITE(Payload, Payloads);

TYPED_TEST(Payload, ComesBackWithItsBits)
{
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        auto sent = some<TypeParam>(seed);
        auto got = decode<TypeParam>(encode(sent));
        RC_ASSERT(encode(got) == encode(sent));
        RC_ASSERT(same(sent, got));
    }));
}

TYPED_TEST(Payload, IsRefusedWhenItIsCutOrTooLong)
{
    for (std::uint64_t seed = 0; seed < 5; ++seed)
    {
        const auto bytes = encode(some<TypeParam>(seed));
        for (std::size_t size = 0; size < bytes.size(); ++size)
            ASSERT_THROW(decode<TypeParam>(std::string_view(bytes).substr(0, size)), FrameError) << size;
        ASSERT_THROW(decode<TypeParam>(bytes + '\0'), FrameError);
    }
}

TYPED_TEST(Payload, DoesNoHarmWithAnyBitFlipped)
{
    const LittleMemory guard;
    for (std::uint64_t seed = 0; seed < 3; ++seed)
    {
        auto bytes = encode(some<TypeParam>(seed));
        for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit)
        {
            bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
            refuses<TypeParam>(bytes);
            bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
        }
    }
}

TYPED_TEST(Payload, DoesNoHarmWhateverStandsInIt)
{
    const LittleMemory guard;
    constexpr int times = 5000;
    int refused = 0;
    for (int i = 0; i < times; ++i)
    {
        Random random{std::uint64_t(i)};
        auto bytes = encode(some<TypeParam>(random()));
        for (int changes = 1 + below(random, 8); changes > 0 && !bytes.empty(); --changes)
        {
            const auto at = std::size_t(below(random, int(bytes.size())));
            const char values[] = {char(random()), '\0', '\xff', '\x7f', '\x01'};
            // One byte, or four: as the high bytes of counts.
            for (std::size_t k = at; k < std::min(at + (random() % 2 ? 1 : 4), bytes.size()); ++k)
                bytes[k] = values[below(random, 5)];
        }
        if (random() % 4 == 0) bytes.resize(std::size_t(below(random, int(bytes.size()) + 1)));
        if (random() % 4 == 0) bytes += std::string(std::size_t(below(random, 9)), char(random()));
        refused += refuses<TypeParam>(bytes);
    }
    EXPECT_GT(refused, times / 10);
}

TEST(Pictures, WithoutTheirPixelsAreRefusedBeforeThereIsRoomForThem)
{
    const LittleMemory guard;
    for (const int side : {1, 2000, largestPictureSide, 1 << 30, -1})
        EXPECT_TRUE(refuses<Image>(encode(std::array{side, side}))) << side;
}

TEST(Heads, ComeBackAndRefuseEverythingElse)
{
    const auto question = frame(RequestHead{7, Function::unitNormal, 0}, "abc");
    const auto head = requestHead(std::string_view(question).substr(0, RequestHead::bytes));
    EXPECT_EQ(head.sequence, 7U);
    EXPECT_EQ(head.function, Function::unitNormal);
    EXPECT_EQ(head.size, 3U); // of the payload, whatever the head said
    EXPECT_EQ(question.substr(RequestHead::bytes), "abc");

    const auto answer = frame(AnswerHead{9, Status::outOfMemory, 0}, "ab").substr(0, AnswerHead::bytes);
    EXPECT_EQ(answerHead(answer).sequence, 9U);
    EXPECT_EQ(answerHead(answer).status, Status::outOfMemory);
    EXPECT_EQ(answerHead(answer).size, 2U);

    EXPECT_THROW(requestHead(answer), FrameError);
    EXPECT_THROW(answerHead(answer.substr(1)), FrameError);
    EXPECT_THROW(answerHead(answer + "x"), FrameError);
    EXPECT_THROW(answerHead("PASSED  PASSED  "), FrameError);
    const auto with = [&](std::size_t word, std::uint32_t value) {
        auto bytes = answer;
        std::memcpy(bytes.data() + 4 * word, &value, 4);
        return bytes;
    };
    EXPECT_THROW(answerHead(with(2, 4)), FrameError);
    EXPECT_NO_THROW(answerHead(with(3, std::uint32_t(largestAnswer))));
    EXPECT_THROW(answerHead(with(3, std::uint32_t(largestAnswer) + 1)), FrameError);
    for (std::size_t bit = 0; bit < 32; ++bit) EXPECT_THROW(answerHead(with(0, answerMagic ^ (1U << bit))), FrameError);
}

TEST(Scenes, KeepAllThatASceneIsMadeOfAndNoTitle)
{
    // One with a picture as its sky, and one with the most settings.
    for (const char* file : {"lessons/04_hdr_sky/scenes/probe.toml", "lessons/08_phong/scenes/everything.toml"})
    {
        const auto scene = cases::smallScene(file);
        auto sent = scene, got = decode<SceneDescription>(encode(scene));
        EXPECT_TRUE(same(sent, got)) << file;
        EXPECT_EQ(got.title, "") << "titles may tell what a scene is for";
    }
}

TEST(Trees, WhoseIndicesLeadNowhereAreRefused)
{
    const auto refused = [](auto&& change) {
        RayTree tree;
        tree.nodes.resize(2);
        tree.nodes[1].id = 1;
        tree.nodes[1].parent = 0;
        tree.shadows.resize(1);
        tree.capped.resize(1);
        EXPECT_NO_THROW(decode<RayTree>(encode(tree)));
        change(tree);
        return refuses<RayTree>(encode(tree));
    };
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes[1].parent = 1; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes[0].parent = -2; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes[1].id = 0; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes[1].depth = -1; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes[1].n1 = 1; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes[1].line = -1; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.shadows[0].node = 2; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.shadows[0].light = -1; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.capped[0].node = -1; }));
    EXPECT_TRUE(refused([](RayTree& t) { t.nodes.clear(); }));
}

} // namespace

} // namespace rt::grade
