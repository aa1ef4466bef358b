#include "common/files/scene_file.h"

#include <cstring>
#include <filesystem>
#include <unordered_map>

#include "common/files/glass_check.h"
#include "common/files/obj_file.h"
#include "common/files/picture_file.h"
#include "common/files/scene_reader.h"

namespace rt
{

namespace
{

const FileKind sceneKind{"a scene file (.toml)", {".toml"}, false};
const FileKind pictureKind{"a picture (.hdr, .exr, .png)", {".hdr", ".exr", ".png"}};

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

/// What the readers below share.
struct Reading
{
    const std::string& file;
    SceneDescription& scene;
    FieldPlaces& places;
    std::unordered_map<std::string_view, int> materials; ///< index by name
};

/// What the next object of a list is called: "sphere0".
template <class Object>
std::string numbered(const char* kind, const std::vector<Object>& list)
{
    return kind + std::to_string(list.size());
}

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
    table.notePlaces(reading.places, "camera");
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
    table.notePlaces(reading.places, "trace");
    table.read("max_depth", trace.maxDepth, 0, deepestTrace);
    table.read("cutoff", trace.cutoff, notNegative);
    table.read("at_cap", trace.atCap, atCapWords);
    table.read("fresnel", trace.fresnel, fresnelWords);
    table.read("shadow_through_glass", trace.shadowThroughGlass, shadowThroughGlassWords);
    table.finish();
}

/// Calls read(path) for the file that the key names, relative to the scene's folder. What is wrong with that file is told
/// at the key's value, as `scene.toml:2:9: probe.hdr: why`.
template <class Read>
auto readNamedFile(const Reading& reading, const SceneTable& table, std::string_view key, const std::string& name,
                   Read&& read)
{
    if (name.empty()) table.wrong(key, table.place(key), "the name of a file", "''");
    if (const auto odd = std::ranges::find_if(name, [](unsigned char c) { return c < 0x20; }); odd != name.end())
        table.fail(table.place(key),
                   fmt::format("{} in {}: within \"\" a backslash begins an escape, and {} came of it, "
                               "expected / between folders, or the name within ''",
                               inQuotes(key), table.title, inQuotes(std::string(1, *odd))));
    try
    {
        return read((std::filesystem::path(reading.file).parent_path() / name).string());
    }
    catch (const std::runtime_error& error)
    {
        table.fail(table.place(key), onOneLine(error.what(), 500));
    }
}

/// Lossy pictures have values a little below 0, which become 0; what is lower is refused.
void liftToZero(Image& image, const std::string& path, std::vector<std::string>& warnings)
{
    double most = 0;
    for (const auto& c : image.pixels)
        if (isFinite(c)) most = std::max(most, largestChannel(c));
    const double lowest = -most / 1024; // as many digits as half has
    int lifted = 0, firstX = 0, firstY = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
        {
            auto& c = image.at(x, y);
            const double least = std::min({c.x, c.y, c.z});
            if (!isFinite(c) || least < lowest)
                throw SceneError(fmt::format("{}: pixel ({}, {}) is not a finite number of at least 0", path, x, y));
            if (least >= 0) continue;
            c = max(c, Vec3<double>(0));
            if (++lifted > 1) continue;
            firstX = x;
            firstY = y;
        }
    if (lifted > 0)
        warnings.push_back(fmt::format("{}: {} a little below 0 and taken as 0, the first of them ({}, {})", path,
                                       lifted == 1 ? "1 pixel is" : fmt::format("{} pixels are", lifted), firstX,
                                       firstY));
}

void checkShape(const Image& image, const std::string& path, SkyMapping mapping, std::vector<std::string>& warnings)
{
    const bool isSquare = image.width == image.height;
    if (mapping == SkyMapping::latlong && std::abs(image.width - 2 * image.height) > 1)
        warnings.push_back(fmt::format("{} is {}x{}; a lat-long picture is twice as wide as high{}", path, image.width,
                                       image.height,
                                       isSquare ? "; is it an angular probe, mapping = \"angular\"?" : ""));
    if (mapping == SkyMapping::angular && !isSquare)
        warnings.push_back(fmt::format("{} is {}x{}; an angular probe is square{}", path, image.width, image.height,
                                       image.width == 2 * image.height ? "; is it lat-long?" : ""));
}

std::shared_ptr<const Image> readPicture(const std::string& path, SkyMapping mapping,
                                         std::vector<std::string>& warnings)
{
    checkFile(path, pictureKind);
    auto image = readImage(path);
    liftToZero(image, path, warnings);
    checkShape(image, path, mapping, warnings);
    return std::make_shared<const Image>(std::move(image));
}

Sun readSun(const Reading& reading, const toml::table& source)
{
    // A number is greater than 0 if it is at least the smallest one that is.
    constexpr NumberRange aboveZeroTo180{std::numeric_limits<double>::denorm_min(), 180, true,
                                         " greater than 0 and at most 180"};
    Sun sun;
    SceneTable table(reading.file, source, "the sun of [sky]");
    table.notePlaces(reading.places, "sky.sun");
    table.require({"direction", "color"});
    table.read("direction", sun.direction);
    table.read("color", sun.color, notNegative);
    table.read("size", sun.size, aboveZeroTo180);
    table.finish();
    if (sun.direction == Vec3<double>(0))
        table.wrong("direction", table.place("direction"), "a direction", "the zero vector");
    return sun;
}

void readSky(const Reading& reading, const toml::table& source)
{
    auto& sky = reading.scene.sky;
    sky.present = true;
    SceneTable table(reading.file, source, "[sky]");
    table.notePlaces(reading.places, "sky");
    Vec3<double> zenith;
    table.read("color", sky.color, notNegative);
    table.read("horizon", sky.color, notNegative);
    if (table.read("zenith", zenith, notNegative)) sky.zenith = zenith;
    table.read("image", sky.imageFile);
    table.read("mapping", sky.mapping, skyMappingWords);
    const auto* sun = table.child("sun", "{ direction = [x, y, z], color = [r, g, b], size = 5.0 }");
    table.finish();

    using Pair = std::pair<const char*, const char*>;
    for (const auto& [one, other] : {Pair("horizon", "color"), Pair("zenith", "color"), Pair("image", "color"),
                                     Pair("image", "horizon"), Pair("image", "zenith")})
        table.refuseBoth(one, other, "expected either 'color', or 'horizon' and 'zenith', or 'image'");
    table.refuseBoth("sun", "image", "expected no 'sun', since a picture shows its own");
    for (const auto& [one, other] : {Pair("horizon", "zenith"), Pair("zenith", "horizon"), Pair("mapping", "image")})
        table.refuseWithout(one, other, fmt::format("expected {} as well", inQuotes(other)));

    if (sun) sky.sun = readSun(reading, *sun);
    if (!table.has("image")) return;
    std::vector<std::string> warnings;
    sky.image = readNamedFile(reading, table, "image", sky.imageFile,
                              [&](const auto& path) { return readPicture(path, sky.mapping, warnings); });
    for (const auto& warning : warnings) reading.scene.warnings.push_back(table.message(table.place("image"), warning));
}

void readMaterial(const Reading& reading, const std::string& name, const toml::table& source)
{
    Material<double> material{.name = name};
    SceneTable table(reading.file, source, materialTitle(name));
    table.notePlaces(reading.places, "materials." + name);
    table.read("color", material.color, zeroToOne);
    const bool mirrors = table.read("mirror", material.mirror, zeroToOne);
    const bool refracts = table.read("ior", material.ior, positiveNumber);
    table.read("ior_outside", material.iorOutside, positiveNumber);
    const bool glosses = table.read("glossy", material.glossy, zeroToOne);
    table.read("exponent", material.exponent, notNegative);
    table.finish();

    const char* share = mirrors ? "mirror" : "glossy";
    if (refracts && (mirrors || glosses))
        table.fail(table.placeOfKey(share),
                   fmt::format("'{}' in {} beside 'ior': a dielectric's reflected share follows from Fresnel, "
                               "expected only one of the two",
                               share, table.title));
    table.refuseWithout("ior_outside", "ior", "expected both or neither");
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
    auto hint = didYouMean(name, defined);
    if (hint.empty())
        hint = defined.empty() ? ", expected a table [materials.NAME]" : ", expected " + listed(defined, "or");
    table.fail(table.place("material"), fmt::format("material {} is not defined{}", inQuotes(name), hint));
}

void readSphere(const Reading& reading, const toml::table& source)
{
    SphereDescription sphere;
    SceneTable table(reading.file, source, "[[sphere]]");
    table.notePlaces(reading.places, numbered("sphere", reading.scene.spheres));
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
    table.notePlaces(reading.places, numbered("plane", reading.scene.planes) + ".checker");
    table.require({"color"});
    table.read("color", plane.checkerColor, zeroToOne);
    table.read("size", plane.checkerSize, positiveNumber);
    table.finish();
}

void readPlane(const Reading& reading, const toml::table& source)
{
    PlaneDescription plane;
    SceneTable table(reading.file, source, "[[plane]]");
    table.notePlaces(reading.places, numbered("plane", reading.scene.planes));
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

void readTriangle(const Reading& reading, const toml::table& source)
{
    TriangleDescription triangle;
    SceneTable table(reading.file, source, "[[triangle]]");
    table.require({"vertices", "material"});
    table.read("vertices", triangle.vertices);
    triangle.material = materialOf(reading, table);
    if (!isDegenerate(triangle.vertices))
    {
        table.notePlaces(reading.places, numbered("triangle", reading.scene.triangles));
        reading.scene.triangles.push_back(triangle);
    }
    else
        reading.scene.warnings.push_back(
            table.message(table.place("vertices"), "this [[triangle]] has no area and is left out"));
}

void readMesh(const Reading& reading, const toml::table& source)
{
    MeshDescription mesh;
    SceneTable table(reading.file, source, "[[mesh]]");
    table.notePlaces(reading.places, numbered("mesh", reading.scene.meshes));
    table.require({"file", "material"});
    table.read("file", mesh.file);
    mesh.material = materialOf(reading, table);
    std::vector<std::string> warnings;
    mesh.triangles = std::make_shared<const std::vector<MeshTriangle>>(
        readNamedFile(reading, table, "file", mesh.file, [&](const auto& path) { return readObj(path, warnings); }));
    if (reading.scene.materials[std::size_t(mesh.material)].isDielectric())
        if (const auto fault = glassMeshFault(*mesh.triangles); !fault.empty())
            warnings.push_back(fmt::format("{}: {}", onOneLine(mesh.file), fault));
    for (const auto& warning : warnings) reading.scene.warnings.push_back(table.message(table.place("file"), warning));
    reading.scene.meshes.push_back(mesh);
}

void readLight(const Reading& reading, const toml::table& source)
{
    Light<double> light;
    SceneTable table(reading.file, source, "[[light]]");
    table.notePlaces(reading.places, numbered("light", reading.scene.lights));
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
    FieldPlaces places;
    Reading reading{file, scene, places, {}};

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
    for (const auto* mesh : meshes) readMesh(reading, *mesh);
    for (const auto* light : lights) readLight(reading, *light);
    for (const auto& fault : {nestedGlassFault(scene), equalSphereFault(scene)})
        if (!fault.empty()) scene.warnings.push_back(fmt::format("{}: {}", file, fault));
    scene.places = std::make_shared<const FieldPlaces>(std::move(places));
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
        checkTomlText(plain, name);
        return readScene(parseToml(plain, name), name);
    };
    return guarded(name, read);
}

SceneDescription loadScene(const std::string& path)
{
    return guarded(path, [&] { return parseScene(readText(path, sceneKind), path); });
}

} // namespace rt
