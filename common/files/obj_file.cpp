// Why not tinyobjloader? 2.0.0rc10 was tried on broken files. It reads `v 0 0 abc`, `v 0 0` and `v 0 0 nan` as 0, `v 0 0 1e999`
// as infinity, `v 1,5 0 0` as (1, 0, 0), `f 1.5 2 3x` as `f 1 2 3`, `f 1 2 -9` of three vertices as index -6, and any text as
// an empty mesh, all without a word; `f 1 2 99999999999` wraps around. To check all that, the file would have to be read
// a second time, and positions and faces alone are little more than that.
#include "common/files/obj_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "common/files/polygon.h"
#include "common/files/scene_text.h"

namespace rt
{

namespace
{

/// Lines that say nothing about polygons: directions and coordinates of textures, curves and surfaces, groups, materials.
constexpr std::string_view ignoredWords[] = {
    "vn",       "vt",   "vp",         "vw",        "g",      "o",   "s",    "mg",    "usemtl", "mtllib", "usemap",
    "maplib",   "p",    "l",          "t",         "cstype", "deg", "bmat", "step",  "curv",   "curv2",  "surf",
    "parm",     "trim", "hole",       "scrv",      "sp",     "end", "con",  "ctech", "stech",  "bevel",  "c_interp",
    "d_interp", "lod",  "shadow_obj", "trace_obj", "bsp",    "bzp", "cdc",  "cdp",   "res"};

const FileKind objKind{"an OBJ file (.obj)", {".obj"}};

/// Any bytes, for a message in ASCII.
std::string quoted(std::string_view word)
{
    std::string ascii;
    for (const char c : word.substr(0, 64))
        if (const auto byte = static_cast<unsigned char>(c); byte < 0x80)
            ascii += c;
        else
            ascii += fmt::format("\\x{:02x}", byte);
    return inQuotes(ascii);
}

class ObjReader
{
public:
    ObjReader(const std::string& path, std::string_view wholeText) : file(path), text(wholeText) {}

    std::vector<MeshTriangle> read(std::vector<std::string>& warnings)
    {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        const bool isEmpty = text.empty();
        if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
        if (text.find('\n') == text.npos) lineEnd = '\r';
        text = text.substr(0, text.find_last_not_of(" \t\r\n\x1A") + 1); // DOS ended files by ^Z
        while (nextLine()) readLine();
        if (faces == 0)
            throw SceneError(fmt::format("{}: {}, expected at least one line such as 'f 1 2 3'", file,
                                         isEmpty ? "the file is empty" : "there are no faces"));
        if (flat == 1)
            warnings.push_back(fmt::format("{}:{}: a triangle has no area and is left out", file, firstFlat));
        else if (flat > 1)
            warnings.push_back(fmt::format("{}:{}: {} triangles have no area and are left out, the first of them here",
                                           file, firstFlat, flat));
        if (crossed > 0)
            warnings.push_back(fmt::format(
                "{}:{}: {} no polygon that could be cut into triangles, since it crosses "
                "itself; it is filled by a fan",
                file, firstCrossed,
                crossed == 1 ? "a face is" : fmt::format("{} faces, the first of them here, are", crossed)));
        return std::move(triangles);
    }

private:
    template <class... Values>
    [[noreturn]] void fail(fmt::format_string<Values...> sentence, Values&&... values) const
    {
        throw SceneError(fmt::format("{}:{}: {}", file, line, fmt::format(sentence, std::forward<Values>(values)...)));
    }

    /// Cuts a line off `text`.
    std::string_view cutLine()
    {
        auto cut = text.substr(0, text.find(lineEnd));
        text.remove_prefix(std::min(text.size(), cut.size() + 1));
        if (cut.ends_with('\r')) cut.remove_suffix(1);
        return cut;
    }

    /// Where the backslash stands that joins the line to the next one; npos if it is not joined. In a comment a backslash
    /// may end a Windows path. A next line that begins with a keyword is one of its own: here it ends a name.
    std::size_t joint(std::string_view cut) const
    {
        const auto last = cut.find_last_not_of(blanks);
        if (last == cut.npos || cut[last] != '\\' || cut.find('#') < last || text.empty()) return cut.npos;
        auto next = text.substr(0, text.find(lineEnd));
        next.remove_prefix(std::min(next.size(), next.find_first_not_of(blanks)));
        return isKeyword(next.substr(0, next.find_first_of(blanks))) ? cut.npos : last;
    }

    static bool isKeyword(std::string_view word)
    {
        return word == "v" || word == "f" || word == "fo" || std::ranges::count(ignoredWords, word);
    }

    bool nextLine()
    {
        line += linesInOne;
        linesInOne = 1;
        if (text.empty()) return false;
        rest = cutLine();
        if (joint(rest) == rest.npos) return true;

        joined = rest;
        for (auto end = joint(joined); end != joined.npos; end = joint(joined), ++linesInOne)
        {
            joined.resize(end);
            joined += ' ';
            joined += cutLine();
        }
        rest = joined;
        return true;
    }

    /// The next word of the line, or "" at its end or at a comment.
    std::string_view nextWord()
    {
        rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(blanks)));
        if (rest.starts_with('#')) rest = {};
        if (rest == "\\") rest = {}; // it joins nothing
        const auto word = rest.substr(0, rest.find_first_of(blanks));
        rest.remove_prefix(word.size());
        return word;
    }

    void readLine()
    {
        const auto keyword = nextWord();
        if (keyword == "v")
            readVertex();
        else if (keyword == "f" || keyword == "fo") // the old name
            readFace();
        else if (!keyword.empty() && !isKeyword(keyword))
            fail("unknown keyword {}, expected 'v', 'f' or another one of OBJ", quoted(keyword));
    }

    void readVertex()
    {
        Vec3<double> position;
        int count = 0;
        for (auto word = nextWord(); !word.empty(); word = nextWord(), ++count)
        {
            const double x = number(word);
            if (count < 3) position[count] = x;
        }
        if (count < 3 || count > 7) // a weight and a colour may follow
            fail("a vertex of {} numbers, expected 3: 'v x y z'", count);
        vertices.push_back(position);
    }

    double number(std::string_view word) const
    {
        auto digits = word;
        if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
        double x = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
        if (error == std::errc::result_out_of_range && end == digits.data() + digits.size())
            fail("{} is beyond the range of double, expected a number nearer to 1", quoted(word));
        if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(x))
            fail("{} is not a finite number, expected 'v x y z'", quoted(word));
        return x;
    }

    void readFace()
    {
        corners.clear();
        for (auto word = nextWord(); !word.empty(); word = nextWord()) corners.push_back(corner(word));
        if (corners.empty()) fail("a face of 0 corners, expected at least 3");
        ++faces;
        if (corners.size() < 3)
            noteFlat();
        else if (corners.size() > 3)
            addPolygon();
        else
            addFan();
    }

    void addFan()
    {
        for (std::size_t i = 2; i < corners.size(); ++i) add({corners[0], corners[i - 1], corners[i]});
    }

    void addPolygon()
    {
        const auto polygon = flattened(corners);
        if (isConvex(polygon)) return addFan();
        constexpr std::size_t most = 1000; // it takes time that grows with the square
        if (corners.size() > most)
            fail("a face of {} corners that is not convex, expected at most {}", corners.size(), most);
        if (const auto ears = earsOf(polygon); !ears.empty())
        {
            for (const auto& [i, j, k] : ears) add({corners[i], corners[j], corners[k]});
            return;
        }
        if (++crossed == 1) firstCrossed = line;
        addFan();
    }

    /// The vertex of `7`, `7/1`, `7//2` or `7/1/2`: the first number, from 1, or from -1 for the last vertex backwards.
    const Vec3<double>& corner(std::string_view word) const
    {
        std::int64_t index = 0, unused = 0;
        const char *at = word.data(), *const end = at + word.size();
        at = std::from_chars(at, end, index).ptr;
        for (int slashes = 0; at != word.data() && at != end && *at == '/' && slashes < 2; ++slashes)
            at = std::from_chars(at + 1, end, unused).ptr;
        if (at == word.data() || at != end)
            fail("{} is not a corner, expected a vertex's number, as in 7, 7/1, 7//2 or 7/1/2", quoted(word));

        const auto count = std::int64_t(vertices.size());
        const bool exists = index != 0 && index >= -count && index <= count; // it stays 0 if it does not fit
        if (!exists && count == 0)
            fail("there is no vertex {} above this line, expected 'v x y z' first", quoted(word));
        if (!exists)
            fail("there is no vertex {} above this line, expected 1 to {} or -{} to -1", quoted(word), count, count);
        return vertices[std::size_t(index > 0 ? index - 1 : count + index)];
    }

    void add(const MeshTriangle& triangle)
    {
        if (triangles.size() + flat == mostMeshTriangles)
            fail("too many triangles, expected at most {}", mostMeshTriangles);
        if (isDegenerate(triangle))
            noteFlat();
        else
            triangles.push_back(triangle);
    }

    void noteFlat()
    {
        if (++flat == 1) firstFlat = line;
    }

    static constexpr const char* blanks = " \t\r\v\f";

    const std::string& file;
    std::string_view text; ///< what is still to be read
    std::string_view rest; ///< of the current line
    std::string joined;    ///< the current line, if it goes over several
    std::size_t line = 0, linesInOne = 1;

    std::vector<Vec3<double>> vertices;
    std::vector<MeshTriangle> triangles;
    std::size_t faces = 0;
    std::size_t flat = 0, firstFlat = 0;       ///< triangles without area, and the line of the first
    std::size_t crossed = 0, firstCrossed = 0; ///< the same of polygons that cross themselves
    std::vector<Vec3<double>> corners;         ///< of the current face
    char lineEnd = '\n';                       ///< a file without it has lines that end in CR only
};

} // namespace

bool isDegenerate(const MeshTriangle& triangle)
{
    const auto& [a, b, c] = triangle;
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    return !(length(cross(unit(b - a), unit(c - a))) > rounding);
}

std::vector<MeshTriangle> readObj(const std::string& path, std::vector<std::string>& warnings)
{
    const auto text = readText(path, objKind);
    return ObjReader(path, text).read(warnings);
}

} // namespace rt
