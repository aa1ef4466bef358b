#include "viz/state/listing.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "common/program/program.h"
#include "lessons/programs/registry.h"

namespace rt::viz
{

namespace
{

namespace fs = std::filesystem;

/// A project folder with a file beside it that must not be read.
struct Folder
{
    fs::path base, root;

    Folder() : base(fs::temp_directory_path() / ("listing_test_" + std::to_string(getpid()))), root(base / "project")
    {
        fs::create_directories(root / "lessons");
        write(root / "lessons/trace.h", "int a;\nint b;\n");
        write(base / "outside.h", "secret\n");
    }
    ~Folder() { fs::remove_all(base); }

    static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
    Listing read(const std::string& source) const { return readListing(source, root.string()); }
};

std::vector<InkedText> inked(const std::string& line)
{
    return listingOf(line).inked.at(0);
}

TEST(Listing, ReadsTheLinesOfAFileInTheProject)
{
    const Folder folder;
    const auto listing = folder.read("lessons/trace.h");
    EXPECT_EQ(listing.missing, "");
    EXPECT_EQ(listing.source, "lessons/trace.h");
    EXPECT_EQ(listing.lines, (std::vector<std::string>{"int a;", "int b;"}));
}

TEST(Listing, ReadsNothingOutsideOfTheProject)
{
    const Folder folder;
    const auto outside = (folder.base / "outside.h").string();
    fs::create_symlink(folder.base / "outside.h", folder.root / "link.h");
    fs::create_directory_symlink(folder.base, folder.root / "up");
    fs::create_directories(folder.base / "project2");
    Folder::write(folder.base / "project2/near.h", "secret\n");
    for (const auto& source : {std::string("../outside.h"), outside, std::string("lessons/../../outside.h"),
                               std::string("link.h"), std::string("up/outside.h"), std::string("../project2/near.h")})
    {
        const auto listing = folder.read(source);
        EXPECT_TRUE(listing.lines.empty()) << source;
        EXPECT_NE(listing.missing.find("outside of the project"), std::string::npos)
            << source << ": " << listing.missing;
    }
}

TEST(Listing, ReadsOnlyFilesOfSourceText)
{
    const Folder folder;
    Folder::write(folder.root / "key.pem", "secret\n");
    Folder::write(folder.root / "noext", "secret\n");
    fs::create_directories(folder.root / "folder.h");
    Folder::write(folder.root / "large.h", std::string((1 << 20) + 1, 'x'));
    for (const char* source : {"key.pem", "noext", "folder.h", "large.h", "lessons", ".", "missing.h"})
    {
        const auto listing = folder.read(source);
        EXPECT_TRUE(listing.lines.empty()) << source;
        EXPECT_NE(listing.missing.find(source), std::string::npos) << listing.missing;
    }
}

TEST(Listing, SaysThatNoSourceIsKnownWhateverTheNameIs)
{
    const Folder folder;
    using namespace std::string_literals;
    for (const auto& source :
         {""s, "a\0b.h"s, std::string(100000, 'x') + ".h", "\xff\xfe.h"s, "a\nb.h"s, "/dev/zero"s, "/"s})
    {
        const auto listing = folder.read(source);
        EXPECT_TRUE(listing.lines.empty());
        EXPECT_FALSE(listing.missing.empty());
        EXPECT_LT(listing.missing.size(), 600U);
        EXPECT_EQ(listing.missing.find('\n'), std::string::npos);
    }
    EXPECT_EQ(readListing("trace.h", "/no/such/folder").missing, "No source is known for this tree.");
}

TEST(Listing, MakesAnyBytesPrintable)
{
    const auto listing = listingOf("\ta\x01"
                                   "b\xff\r\n\xce\xb8\n" +
                                   std::string(5000, 'x'));
    ASSERT_EQ(listing.lines.size(), 3U);
    EXPECT_EQ(listing.lines[0], "    a?b?");
    EXPECT_EQ(listing.lines[1], "θ");
    EXPECT_LE(listing.lines[2].size(), 400U);
    EXPECT_LE(listingOf(std::string(100000, '\n')).lines.size(), 20000U);
}

TEST(Listing, ColoursWords)
{
    EXPECT_EQ(inked("    if (x < 1.5f) return; // why"), (std::vector<InkedText>{{Ink::plain, "    "},
                                                                                 {Ink::keyword, "if "},
                                                                                 {Ink::plain, "(x < "},
                                                                                 {Ink::literal, "1.5f"},
                                                                                 {Ink::plain, ") "},
                                                                                 {Ink::keyword, "return"},
                                                                                 {Ink::plain, "; "},
                                                                                 {Ink::comment, "// why"}}));
    EXPECT_EQ(inked("f(\"a // \\\" b\")").at(1), (InkedText{Ink::literal, "\"a // \\\" b\""}));
    EXPECT_EQ(inked("ifs"), (std::vector<InkedText>{{Ink::plain, "ifs"}}));
    EXPECT_EQ(inked("const Color c").at(1).ink, Ink::type);
    EXPECT_EQ(inked("    rec.color(color); // \"x\"").at(0).ink, Ink::instrument);
    EXPECT_EQ(inked("\"open").at(0).text, "\"open");
}

TEST(Listing, CommentsGoOnUntilTheyEnd)
{
    const auto listing = listingOf("a /* b\nint c\nd */ int e");
    EXPECT_EQ(listing.inked[1], (std::vector<InkedText>{{Ink::comment, "int c"}}));
    ASSERT_EQ(listing.inked[2].size(), 3U);
    EXPECT_EQ(listing.inked[2][0], (InkedText{Ink::comment, "d */ "}));
    EXPECT_EQ(listing.inked[2][1].ink, Ink::type);
}

TEST(Listing, PiecesMakeUpTheLine)
{
    for (const auto* lesson : lessons())
    {
        const auto listing = readListing(lesson->source, projectFile(""));
        ASSERT_EQ(listing.missing, "") << lesson->source;
        for (std::size_t i = 0; i < listing.lines.size(); ++i)
        {
            std::string all;
            for (const auto& piece : listing.inked[i]) all += piece.text;
            ASSERT_EQ(all, listing.lines[i]);
        }
    }
}

constexpr const char* program = R"(#include <x>
namespace a
{

template <class T> struct Tracer
{
    int cap = f({1});

    // First.
    Color trace(const Ray& ray)
    {
        if (x) { return "}"; } // {
        return y;
    }

    static int other() { return 1; }
};

void free(struct Ray ray)
{
    while (true)
    {
    }
}

} // namespace a
)";

TEST(Listing, FindsTheFunctionAroundALine)
{
    const auto listing = listingOf(program);
    const auto range = [&](int line) {
        const auto found = functionAround(listing, line);
        return std::pair{found.first, found.last};
    };
    for (int line = 10; line <= 14; ++line) EXPECT_EQ(range(line), (std::pair{10, 14})) << line;
    EXPECT_EQ(range(16), (std::pair{16, 16}));
    EXPECT_EQ(range(21), (std::pair{19, 24}));
    for (const int line : {1, 3, 9, 15, 17, 18, 26, 0, -5, 1000})
        EXPECT_FALSE(functionAround(listing, line).contains(line)) << line;
}

TEST(Listing, FindsTheFunctionsThatTraceInEachLesson)
{
    for (const auto* lesson : lessons())
    {
        const auto listing = readListing(lesson->source, projectFile(""));
        for (std::size_t i = 0; i < listing.lines.size(); ++i)
            if (listing.lines[i].find("rec.ray(ray, hit);") != std::string::npos)
            {
                const auto found = functionAround(listing, int(i) + 1);
                ASSERT_TRUE(found.contains(int(i) + 1)) << lesson->source;
                const auto& head = listing.lines[std::size_t(found.first) - 1];
                EXPECT_TRUE(head.starts_with("    Color ") && head.ends_with("(const Ray& ray)")) << head;
                EXPECT_EQ(listing.lines[std::size_t(found.last) - 1], "    }") << lesson->source;
            }
    }
}

} // namespace

} // namespace rt::viz
