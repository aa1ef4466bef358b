#include "common/scene_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <unordered_map>

#include "common/scene_reader.h"

namespace rt
{

namespace
{

namespace fs = std::filesystem;

// ---- the file ------------------------------------------------------------------------------------------------------

/// ", did you mean 'glass.toml'?", from the scene files in the folder of `path`.
std::string similarFile(const fs::path& path)
{
    constexpr std::size_t most = 10000;
    std::vector<std::string> names;
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end && names.size() < most;
         entry.increment(error))
        if (entry->path().extension() == ".toml") names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::string name = path.filename().string();
    return SceneTable::didYouMean(name, {names.begin(), names.end()});
}

struct Text
{
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;
    operator std::string_view() const { return {bytes.get(), size}; }
};

/// The whole file, or at most one byte more than the limit: size and kind of a file may lie, as those of /dev/zero do.
Text readText(const std::string& path)
{
    const auto refuse = [&](const std::string& why) { throw SceneError(fmt::format("{}: {}", path, why)); };
    const auto tooLarge = fmt::format("too large, expected at most {} MiB", largestSceneFile >> 20);

    std::error_code error;
    const auto status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) refuse("no such file" + similarFile(path));
    if (status.type() == fs::file_type::directory) refuse("this is a folder, expected a scene file (.toml)");
    if (status.type() == fs::file_type::regular && fs::file_size(path, error) > largestSceneFile && !error)
        refuse(tooLarge);

    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) refuse(fmt::format("cannot be opened: {}", std::strerror(errno)));
    std::setvbuf(file.get(), nullptr, _IONBF, 0);

    // Few and large steps, and memory that is not cleared first: the limit is reached well within a second.
    Text text;
    for (std::size_t room = std::size_t(1) << 16; text.size <= largestSceneFile; room *= 16)
    {
        room = std::min(room, largestSceneFile + 1);
        auto larger = std::make_unique_for_overwrite<char[]>(room);
        std::copy_n(text.bytes.get(), text.size, larger.get());
        text.bytes = std::move(larger);
        errno = 0;
        const std::size_t before = text.size;
        text.size += std::fread(text.bytes.get() + text.size, 1, room - text.size, file.get());
        const auto* zero = static_cast<const char*>(std::memchr(text.bytes.get() + before, 0, text.size - before));
        if (zero)
            refuse(fmt::format("not a text file, byte {} is zero; expected TOML in UTF-8, at most {} MiB",
                               zero - text.bytes.get() + 1, largestSceneFile >> 20));
        if (std::ferror(file.get())) refuse(fmt::format("cannot be read: {}", std::strerror(errno)));
        if (text.size < room) return text;
    }
    refuse(tooLarge);
    return text;
}

// ---- TOML ----------------------------------------------------------------------------------------------------------

[[noreturn]] void failAt(std::string_view text, std::size_t offset, const std::string& name, std::string_view sentence)
{
    const auto before = text.substr(0, offset);
    const auto lineStart = before.rfind('\n') + 1; // npos + 1 is 0, the first line
    const auto startsLetter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    throw SceneError(fmt::format(
        "{}:{}:{}: {}", name, 1 + std::count(before.begin(), before.end(), '\n'),
        1 + std::count_if(before.begin() + std::ptrdiff_t(lineStart), before.end(), startsLetter), sentence));
}

/// toml++ 3.3 notices, but gives the place of the letter before, which may be on another line.
void refuseOtherThanUtf8(std::string_view text, const std::string& name)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    for (std::size_t i = 0; i < text.size();)
    {
        const unsigned first = byte(i), second = byte(i + 1);
        const std::size_t length = first < 0x80   ? 1
                                   : first < 0xC2 ? 0
                                   : first < 0xE0 ? 2
                                   : first < 0xF0 ? 3
                                   : first < 0xF5 ? 4
                                                  : 0;
        // Neither longer than need be, nor half of a surrogate pair, nor beyond U+10FFFF.
        bool good = length > 0 && !(first == 0xE0 && second < 0xA0) && !(first == 0xED && second > 0x9F) &&
                    !(first == 0xF0 && second < 0x90) && !(first == 0xF4 && second > 0x8F);
        for (std::size_t k = 1; k < length; ++k) good = good && (byte(i + k) & 0xC0) == 0x80;
        if (!good) failAt(text, i, name, fmt::format("byte {:#04x} is not UTF-8, expected TOML in UTF-8", first));
        i += length;
    }
}

/// How many times, from the dot at `i` on, a name and one more dot follow. Bare names and both kinds of quoted ones count.
int dotsInChain(std::string_view text, std::size_t i, int most)
{
    const auto skipWhile = [&](auto isSkipped) {
        while (i < text.size() && isSkipped(text[i])) ++i;
    };
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    const auto isBare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };

    int dots = 0;
    while (i < text.size() && text[i] == '.' && dots < most)
    {
        ++dots;
        ++i;
        skipWhile(isBlank);
        if (i >= text.size()) break;
        if (const char quote = text[i]; quote == '"' || quote == '\'')
        {
            for (++i; i < text.size() && text[i] != quote && text[i] != '\n'; ++i)
                if (quote == '"' && text[i] == '\\') ++i;
            ++i;
        }
        else if (isBare(text[i]))
            skipWhile(isBare);
        else
            break;
        skipWhile(isBlank);
    }
    return dots;
}

/// toml++ 3.3 limits how deep values nest, but not how many names a key joins by dots, and each of them costs it stack:
/// `a.a.a` and so on for some ten thousand names would end the process. No scene joins more than three. Every dot is
/// tried, whatever it means where it stands, so that this need not know TOML.
void refuseLongKeys(std::string_view text, const std::string& name)
{
    constexpr int mostDots = 16;
    for (std::size_t dot = text.find('.'); dot != text.npos; dot = text.find('.', dot + 1))
        if (dotsInChain(text, dot, mostDots) == mostDots)
            failAt(text, dot, name, fmt::format("more than {} names are joined by dots, expected at most 3", mostDots));
}

toml::table parseToml(std::string_view text, const std::string& name)
{
    try
    {
        return toml::parse(text);
    }
    catch (const toml::parse_error& error)
    {
        std::string why(error.description());
        if (why.starts_with("Error ")) why.erase(0, std::strlen("Error "));
        const auto& place = error.source().begin;
        throw SceneError(
            fmt::format("{}:{}:{}: not valid TOML: {}", name, place.line, place.column, onOneLine(why, 500)));
    }
}

/// "[materials.glass]"
std::string materialTitle(const std::string& name)
{
    return fmt::format("[materials.{}]", onOneLine(name));
}

// ---- the scene -----------------------------------------------------------------------------------------------------

/// What the readers below share.
struct Reading
{
    const std::string& file;
    SceneDescription& scene;
    std::unordered_map<std::string_view, int> materials; ///< index by name
};

void checkView(const SceneTable& table, const CameraDescription& camera)
{
    // A camera that looks along `up` has no left and right, and one that nearly does has only the rounding of a float
    // tracer's directions for it.
    constexpr double parallel = 8 * double(std::numeric_limits<float>::epsilon());
    const auto placeOfView = table.place(table.has("target") ? "target" : "eye");

    if (camera.eye == camera.target)
        table.fail(placeOfView, "the camera's eye and target are the same point, expected two different ones");
    if (!isFinite(camera.target - camera.eye))
        table.fail(placeOfView, "the camera's eye and target are too far apart, expected smaller numbers");
    if (camera.up == Vec3<double>(0))
        table.fail(table.place("up"), "'up' in [camera]: expected a direction, got the zero vector");
    const auto across = cross(unit(camera.target - camera.eye), unit(camera.up));
    if (!(length(across) > parallel))
        table.fail(table.has("up") ? table.place("up") : placeOfView,
                   fmt::format("'up' in [camera]: expected a direction that is not parallel to the view from eye to "
                               "target, got [{}, {}, {}]",
                               tomlNumber(camera.up.x), tomlNumber(camera.up.y), tomlNumber(camera.up.z)));
}

void readCamera(const Reading& reading, const toml::table& source)
{
    auto& camera = reading.scene.camera;
    SceneTable table(reading.file, source, "[camera]");
    table.read("eye", camera.eye);
    table.read("target", camera.target);
    table.read("up", camera.up);
    table.read("vertical_fov", camera.verticalFov, {0, 180, false, " between 0 and 180, neither included"});
    table.read("size", camera.width, camera.height, 1, largestSide, largestSide);
    if (std::int64_t(camera.width) * camera.height > mostPixels)
        table.fail(table.place("size"),
                   fmt::format("'size' in [camera]: expected at most {} pixels in all, got {} x {}", mostPixels,
                               camera.width, camera.height));
    table.read("pixel", camera.pixelX, camera.pixelY, 0, camera.width - 1, camera.height - 1);
    table.finish();
    checkView(table, camera);
}

void readTrace(const Reading& reading, const toml::table& source)
{
    auto& trace = reading.scene.trace;
    SceneTable table(reading.file, source, "[trace]");
    table.read("max_depth", trace.maxDepth, 0, deepestTrace);
    table.read("cutoff", trace.cutoff, notNegative);
    table.read("at_cap", trace.atCap, atCapWords);
    table.read("fresnel", trace.fresnel, fresnelWords);
    table.read("shadow_through_glass", trace.shadowThroughGlass, shadowThroughGlassWords);
    table.finish();
}

void readSky(const Reading& reading, const toml::table& source)
{
    auto& sky = reading.scene.sky;
    sky.present = true;
    SceneTable table(reading.file, source, "[sky]");
    table.read("color", sky.color, notNegative);
    table.finish();
}

void readMaterial(const Reading& reading, const std::string& name, const toml::table& source)
{
    Material<double> material{.name = name};
    SceneTable table(reading.file, source, materialTitle(name));
    table.read("color", material.color, zeroToOne);
    const bool mirrors = table.read("mirror", material.mirror, zeroToOne);
    const bool refracts = table.read("ior", material.ior, positiveNumber);
    const bool hasOutside = table.read("ior_outside", material.iorOutside, positiveNumber);
    const bool glosses = table.read("glossy", material.glossy, zeroToOne);
    table.read("exponent", material.exponent, notNegative);
    table.finish();

    const char* share = mirrors ? "mirror" : "glossy";
    if (refracts && (mirrors || glosses))
        table.fail(table.placeOfKey(share),
                   fmt::format("'{}' in {} beside 'ior': a dielectric's reflected share follows from Fresnel, "
                               "expected only one of the two",
                               share, table.title));
    if (hasOutside && !refracts)
        table.fail(table.placeOfKey("ior_outside"),
                   fmt::format("'ior_outside' in {} without 'ior', expected both or neither", table.title));
    reading.scene.materials.push_back(material);
}

void readMaterials(Reading& reading, const toml::table& source)
{
    // toml++ sorts by name; materials are numbered as the file has them.
    std::vector<std::pair<const toml::key*, const toml::node*>> entries;
    for (const auto& [key, value] : source) entries.emplace_back(&key, &value);
    std::sort(entries.begin(), entries.end(),
              [](const auto& a, const auto& b) { return a.first->source().begin < b.first->source().begin; });

    SceneTable table(reading.file, source, "[materials]");
    for (const auto& [key, value] : entries)
    {
        const std::string name(key->str());
        readMaterial(reading, name, *table.child(key->str(), materialTitle(name)));
        reading.materials.emplace(key->str(), int(reading.materials.size()));
    }
}

/// The index of the table's material.
int materialOf(const Reading& reading, SceneTable& table)
{
    std::string name;
    table.read("material", name);
    table.finish();
    if (const auto found = reading.materials.find(name); found != reading.materials.end()) return found->second;

    std::vector<std::string_view> defined;
    for (const auto& material : reading.scene.materials) defined.push_back(material.name);
    auto hint = SceneTable::didYouMean(name, defined);
    if (hint.empty())
        hint = defined.empty() ? ", expected a table [materials.NAME]" : ", expected " + listed(defined, "or");
    table.fail(table.place("material"), fmt::format("material {} is not defined{}", inQuotes(name), hint));
}

void readSphere(const Reading& reading, const toml::table& source)
{
    SphereDescription sphere;
    SceneTable table(reading.file, source, "[[sphere]]");
    table.require({"center", "radius", "material"});
    table.read("center", sphere.center);
    table.read("radius", sphere.radius, positiveNumber);
    sphere.material = materialOf(reading, table);
    reading.scene.spheres.push_back(sphere);
}

void readChecker(const Reading& reading, const toml::table& source, PlaneDescription& plane)
{
    plane.hasChecker = true;
    SceneTable table(reading.file, source, "the checker of a [[plane]]");
    table.require({"color"});
    table.read("color", plane.checkerColor, zeroToOne);
    table.read("size", plane.checkerSize, positiveNumber);
    table.finish();
}

void readPlane(const Reading& reading, const toml::table& source)
{
    PlaneDescription plane;
    SceneTable table(reading.file, source, "[[plane]]");
    table.require({"point", "normal", "material"});
    table.read("point", plane.point);
    table.read("normal", plane.normal);
    const auto* checker = table.child("checker", "{ color = [r, g, b], size = 1.0 }");
    plane.material = materialOf(reading, table);
    if (plane.normal == Vec3<double>(0))
        table.fail(table.place("normal"), "'normal' in [[plane]]: expected a direction, got the zero vector");
    if (checker) readChecker(reading, *checker, plane);
    reading.scene.planes.push_back(plane);
}

/// True if the corners lie on one line, up to the rounding of the two directions.
bool isDegenerate(const TriangleDescription& triangle)
{
    const auto& [a, b, c] = triangle.vertices;
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    return !(length(cross(unit(b - a), unit(c - a))) > rounding);
}

void readTriangle(const Reading& reading, const toml::table& source)
{
    TriangleDescription triangle;
    SceneTable table(reading.file, source, "[[triangle]]");
    table.require({"vertices", "material"});
    table.read("vertices", triangle.vertices);
    triangle.material = materialOf(reading, table);
    if (!isDegenerate(triangle))
        reading.scene.triangles.push_back(triangle);
    else
        reading.scene.warnings.push_back(
            table.message(table.place("vertices"), "this [[triangle]] has no area and is left out"));
}

void readLight(const Reading& reading, const toml::table& source)
{
    Light<double> light;
    SceneTable table(reading.file, source, "[[light]]");
    table.require({"position", "color"});
    table.read("position", light.position);
    table.read("color", light.color, notNegative);
    table.finish();
    reading.scene.lights.push_back(light);
}

SceneDescription readScene(const toml::table& source, const std::string& file)
{
    SceneDescription scene;
    scene.file = file;
    Reading reading{file, scene, {}};

    SceneTable table(file, source, "the scene");
    table.read("title", scene.title);
    const auto* camera = table.child("camera", "[camera]");
    const auto* trace = table.child("trace", "[trace]");
    const auto* sky = table.child("sky", "[sky]");
    const auto* materials = table.child("materials", "[materials.NAME]");
    const auto spheres = table.children("sphere");
    const auto planes = table.children("plane");
    const auto triangles = table.children("triangle");
    const auto meshes = table.children("mesh");
    const auto lights = table.children("light");
    table.finish();

    if (camera) readCamera(reading, *camera);
    if (trace) readTrace(reading, *trace);
    if (sky) readSky(reading, *sky);
    if (materials) readMaterials(reading, *materials);
    for (const auto* sphere : spheres) readSphere(reading, *sphere);
    for (const auto* plane : planes) readPlane(reading, *plane);
    for (const auto* triangle : triangles) readTriangle(reading, *triangle);
    if (!meshes.empty())
        table.fail(meshes.front()->source().begin,
                   "[[mesh]] cannot be read yet, expected [[sphere]], [[plane]] or [[triangle]]");
    for (const auto* light : lights) readLight(reading, *light);
    return scene;
}

/// Runs `read`; whatever goes wrong becomes a SceneError.
template <class Read>
SceneDescription guarded(const std::string& name, Read&& read)
{
    try
    {
        return read();
    }
    catch (const SceneError&)
    {
        throw;
    }
    catch (const std::bad_alloc&)
    {
        throw SceneError(fmt::format("{}: needs more memory than there is", name));
    }
    catch (const std::exception& error)
    {
        throw SceneError(fmt::format("{}: {}", name, error.what()));
    }
}

} // namespace

SceneDescription parseScene(std::string_view text, const std::string& name)
{
    const auto read = [&] {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        const auto plain = text.substr(text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0);
        refuseOtherThanUtf8(plain, name);
        refuseLongKeys(plain, name);
        return readScene(parseToml(plain, name), name);
    };
    return guarded(name, read);
}

SceneDescription loadScene(const std::string& path)
{
    return guarded(path, [&] { return parseScene(readText(path), path); });
}

} // namespace rt
