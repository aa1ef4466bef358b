#include "tests/grade/package/package.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <archive.h>
#include <archive_entry.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/grade/box/temporary_folder.h"
#include "tests/grade/package/text.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

const std::string six = "// Exercise 06, Fresnel.\nnamespace rt::exercise06\n{\n}\n";
const std::string five = "// Exercise 05, refraction.\nnamespace rt::exercise05\n{\n}\n";

struct Entry
{
    std::string path, text;
    mode_t type = AE_IFREG;
    std::string link = "", hardLink = "";
};

class Package : public testing::Test
{
protected:
    TemporaryFolder folder;

    std::string at(const std::string& name) const { return folder.path + "/" + name; }

    void write(const std::string& name, const std::string& text)
    {
        fs::create_directories(fs::path(at(name)).parent_path());
        std::ofstream(at(name), std::ios::binary) << text;
    }

    std::string packed(const std::string& name, const std::vector<Entry>& entries, const char* options = nullptr)
    {
        archive* out = ::archive_write_new();
        if (name.find(".zip") != std::string::npos)
            ::archive_write_set_format_zip(out);
        else
            ::archive_write_set_format_pax_restricted(out);
        if (name.find("gz") != std::string::npos) ::archive_write_add_filter_gzip(out);
        if (options)
        {
            EXPECT_EQ(::archive_write_set_options(out, options), ARCHIVE_OK);
            ::archive_write_set_passphrase(out, "secret");
        }
        ::archive_write_open_filename(out, at(name).c_str());
        for (const auto& one : entries)
        {
            archive_entry* entry = ::archive_entry_new();
            ::archive_entry_set_pathname(entry, one.path.c_str());
            ::archive_entry_set_filetype(entry, one.type);
            ::archive_entry_set_perm(entry, 0644);
            if (!one.link.empty()) ::archive_entry_set_symlink(entry, one.link.c_str());
            if (!one.hardLink.empty()) ::archive_entry_set_hardlink(entry, one.hardLink.c_str());
            const bool hasData = one.type == AE_IFREG && one.hardLink.empty();
            ::archive_entry_set_size(entry, hasData ? la_int64_t(one.text.size()) : 0);
            ::archive_write_header(out, entry);
            if (hasData) ::archive_write_data(out, one.text.data(), one.text.size());
            ::archive_entry_free(entry);
        }
        ::archive_write_close(out);
        ::archive_write_free(out);
        return at(name);
    }

    Taken taken(const std::string& path, int lesson = 6) { return takeExercise({"anna", path}, lesson); }
    std::string refusal(const std::string& path)
    {
        const auto result = taken(path);
        EXPECT_EQ(result.state, State::refused) << result.reason;
        EXPECT_EQ(result.text, "");
        return result.reason;
    }
};

} // namespace

TEST_F(Package, IsFoundAtEveryPlace)
{
    for (const char* place :
         {"exercise.h", "exercise06.h", "06_fresnel/exercise.h", "lessons/06_fresnel/exercise.h", "top/exercise.h",
          "top/exercise06.h", "top/06_fresnel/exercise.h", "top/lessons/06_fresnel/exercise.h", "./exercise.h"})
    {
        for (const char* kind : {"a.zip", "a.tar", "a.tar.gz", "a.tgz"})
        {
            const auto result =
                taken(packed(kind, {{"README.md", "x"}, {place, six}, {"lessons/05_refraction/exercise.h", five}}));
            EXPECT_EQ(result.state, State::graded) << place << " in " << kind << ": " << result.reason;
            EXPECT_EQ(result.text, six);
        }
        fs::remove_all(at("student"));
        write(std::string("student/") + place, six);
        const auto result = taken(at("student"));
        EXPECT_EQ(result.state, State::graded) << place << ": " << result.reason;
        EXPECT_EQ(result.text, six);
        EXPECT_EQ(taken(at("student"), 7).state, State::missing);
    }
    write("anna.h", six);
    EXPECT_EQ(taken(at("anna.h")).text, six);
    EXPECT_EQ(taken(at("anna.h"), 5).state, State::missing);
    EXPECT_EQ(taken(packed("mac.zip", {{"__MACOSX/exercise.h", six}})).state, State::missing);
}

TEST_F(Package, IsFoundByTheNamesThatDownloadsMake)
{
    for (const char* place :
         {"exercise-1.h", "exercise (1).h", "exercise(2).h", "Exercise.h", "EXERCISE.H", "exercise.h.txt",
          "Copy of exercise.h", "exercise - Copy.h", "exercise6.h", "ann_1234_5678_exercise-2.h",
          "a/b/06_fresnel/exercise.h", "a/b/c/d/Exercise06.H", "fresnel.h", ".exercise.h"})
    {
        for (const char* kind : {"a.zip", "a.tar.gz", "A.ZIP", "A.Tgz"})
        {
            const auto result = taken(packed(kind, {{"README.md", "x"}, {place, six}, {"exercise05.h", five}}));
            EXPECT_EQ(result.text, six) << place << " in " << kind << ": " << result.reason;
        }
        fs::remove_all(at("student"));
        write(std::string("student/") + place, six);
        EXPECT_EQ(taken(at("student")).text, six) << place;
        EXPECT_EQ(taken(at("student")).remarks.size(), 1U) << place;
    }
    for (const char* name : {"Anna.H", "anna-1.h", "anna.h.txt"})
    {
        write(name, six);
        EXPECT_EQ(taken(at(name)).text, six) << name;
    }
    // The right name comes first; of copies that differ none is guessed; other headers may be anything.
    EXPECT_EQ(taken(packed("a.zip", {{"exercise (1).h", six + "// old\n"}, {"exercise.h", six}})).text, six);
    EXPECT_EQ(refusal(packed("b.zip", {{"exercise (1).h", six + "// old\n"}, {"exercise (2).h", six}})),
              "there are two different files for lesson 06: exercise (1).h and exercise (2).h");
    const std::string large((std::size_t(256) << 10) + 1, ' ');
    EXPECT_EQ(taken(packed("c.zip", {{"image.h", large}, {"exercise-1.h", six}})).text, six);
}

TEST_F(Package, IsFoundInAnArchiveInAFolder)
{
    fs::create_directories(at("anna/inner"));
    for (const char* name : {"anna/homework.zip", "anna/inner/Homework.ZIP", "anna/inner/homework.tgz"})
    {
        fs::rename(packed(fs::path(name).filename().string(), {{"top/exercise.h", six}}), at(name));
        EXPECT_EQ(taken(at("anna")).text, six) << name;
        fs::remove(at(name));
    }
}

TEST_F(Package, ThatIsMissingSaysWhatWasFound)
{
    const std::string none = "there is no exercise.h for lesson 06; found ",
                      wanted = ", expected exercise.h with namespace rt::exercise06 in it";
    const auto reason = [&](const std::string& path) {
        const auto result = taken(path);
        EXPECT_EQ(result.state, State::missing);
        return result.reason;
    };
    fs::create_directory(at("empty"));
    EXPECT_EQ(reason(at("empty")), none + "nothing" + wanted);
    write("five/exercise.h", five);
    EXPECT_EQ(reason(at("five")), none + "exercise.h" + wanted);
    write("five.h", five);
    EXPECT_EQ(reason(at("five.h")), none + "five.h, which says that it is exercise 05" + wanted);
    write("cy.cpp", six);
    EXPECT_EQ(reason(at("cy.cpp")), none + "cy.cpp" + wanted);
    write("packed/homework.rar", "Rar!");
    EXPECT_EQ(reason(at("packed")), none + "homework.rar" + wanted);
    EXPECT_EQ(reason(packed("many.zip", {{"1", ""}, {"2", ""}, {"3", ""}, {"4", ""}, {"5", ""}, {"6", ""}, {"7", ""}})),
              none + "1, 2, 3, 4, 5 and 2 more" + wanted);
    for (const char* name : {"a.rar", "a.7z", "a.tar.xz", "a.RAR"})
    {
        write(name, "x");
        EXPECT_NE(refusal(at(name)).find(std::string("cannot be opened; found ") + name + ", expected a folder, .zip"),
                  std::string::npos);
    }
}

TEST_F(Package, HasOneFileOfALesson)
{
    EXPECT_EQ(taken(packed("same.zip", {{"exercise.h", six}, {"exercise06.h", six}})).text, six);
    EXPECT_EQ(refusal(packed("two.zip", {{"exercise.h", six}, {"06_fresnel/exercise.h", six + "// more\n"}})),
              "there are two different files for lesson 06: exercise.h and 06_fresnel/exercise.h");
    EXPECT_EQ(refusal(packed("wrong.zip", {{"06_fresnel/exercise.h", five}})),
              "06_fresnel/exercise.h says that it is exercise 05, not 06");
}

TEST_F(Package, TriesToEscapeAreRefused)
{
    for (const char* path : {"../exercise.h", "a/../../exercise.h", "/etc/cron.d/x", "..\\exercise.h", "C:\\x", "a/.."})
        for (const char* kind : {"a.zip", "a.tar"})
            EXPECT_EQ(
                refusal(packed(kind, {{"exercise.h", six}, {path, "x"}})).rfind("the archive has an entry outside", 0),
                0U)
                << path << " in " << kind;
}

TEST_F(Package, LinksAndDevicesAreNotFollowed)
{
    const Entry link{"exercise.h", "", AE_IFLNK, "/etc/passwd"};
    EXPECT_EQ(refusal(packed("a.zip", {link})), "exercise.h is a link, not a file");
    EXPECT_EQ(refusal(packed("a.tar", {link})), "exercise.h is a link, not a file");
    EXPECT_EQ(refusal(packed("b.tar", {{"x", six}, {"exercise.h", "", AE_IFREG, "", "x"}})),
              "exercise.h is a link, not a file");
    EXPECT_EQ(refusal(packed("c.tar", {{"exercise.h", "", AE_IFIFO}})), "exercise.h is something special, not a file");
    const auto harmless = taken(packed("d.tar", {{"exercise.h", six}, {"other", "", AE_IFLNK, "/etc/passwd"}}));
    EXPECT_EQ(harmless.text, six);
    EXPECT_EQ(harmless.remarks, std::vector<std::string>{"a link or special file is passed over: other"});

    fs::create_directory(at("linked"));
    fs::create_symlink("/etc/passwd", at("linked/exercise.h"));
    EXPECT_EQ(refusal(at("linked")), "exercise.h is a link, or it cannot be opened");
    fs::create_directory(at("piped"));
    ::mkfifo(at("piped/exercise.h").c_str(), 0600);
    EXPECT_EQ(refusal(at("piped")), "exercise.h is not a file");
    write("elsewhere/06_fresnel/exercise.h", six);
    fs::create_directory(at("through"));
    fs::create_directory_symlink(at("elsewhere/06_fresnel"), at("through/06_fresnel"));
    EXPECT_EQ(taken(at("through")).state, State::missing);
    fs::create_directory_symlink(at("elsewhere"), at("self"));
    EXPECT_EQ(refusal(at("self")),
              "the submission is a link; found self, expected a folder, .zip, .tar, .tar.gz, .tgz or .h");
    fs::create_directory_symlink("..", at("elsewhere/loop"));
    EXPECT_EQ(taken(at("elsewhere")).text, six);
}

TEST_F(Package, BombsAreRefused)
{
    const std::string large((std::size_t(256) << 10) + 1, ' ');
    EXPECT_EQ(refusal(packed("a.zip", {{"exercise.h", large}})), "exercise.h is larger than 256 KiB");
    write("folder/exercise.h", large);
    EXPECT_EQ(refusal(at("folder")), "exercise.h is larger than 256 KiB");
    const std::string zeros(std::size_t(65) << 20, '\0');
    for (const char* kind : {"bomb.zip", "bomb.tar.gz"})
        EXPECT_EQ(refusal(packed(kind, {{"picture.png", zeros}, {"exercise.h", six}})),
                  "the archive is larger than 64 MiB when it is unpacked")
            << kind;
    std::vector<Entry> many(10'001, Entry{"x", ""});
    EXPECT_EQ(refusal(packed("many.zip", many)), "the archive has more than 10,000 entries");
}

TEST_F(Package, EncryptedAndDamagedArchivesAreRefused)
{
    EXPECT_EQ(refusal(packed("a.zip", {{"exercise.h", six}}, "zip:encryption=zipcrypt")), "exercise.h is encrypted");
    write("b.zip", "no archive at all");
    EXPECT_EQ(refusal(at("b.zip")), "the archive cannot be read: it is neither zip nor tar, or it is damaged");
    write("empty.zip", "");
    EXPECT_NE(taken(at("empty.zip")).state, State::graded);
    const auto whole = packed("c.tar.gz", {{"a", std::string(1000, 'a')}, {"exercise.h", six}});
    fs::resize_file(whole, fs::file_size(whole) / 2);
    EXPECT_NE(refusal(whole), "");
}

TEST_F(Package, OddNamesArePassedOver)
{
    const auto result =
        taken(packed("a.tar", {{"exercise.h", six}, {"a\nb", "x"}, {"\x1b[31m", "x"}, {"caf\xE9", "x"}}));
    EXPECT_EQ(result.text, six) << result.reason;
    ASSERT_EQ(result.remarks.size(), 3U);
    EXPECT_EQ(result.remarks[0], "a file with an odd name is passed over: a?b");
    EXPECT_EQ(taken(packed("b.tar", {{std::string(100'000, 'a') + "/exercise.h", six}})).state, State::missing);
}

TEST_F(Package, EveryEditorsTextIsRead)
{
    const auto read = [&](const std::string& bytes) {
        write("one.h", bytes);
        return taken(at("one.h"));
    };
    EXPECT_EQ(read("\xEF\xBB\xBF// Exercise 06\r\nint a;\r\n").text, "// Exercise 06\nint a;\n");
    EXPECT_EQ(read("// Exercise 06\rint a;").text, "// Exercise 06\nint a;\n");
    const auto latin = read("// Exercise 06: L\xF6sung\n");
    EXPECT_EQ(latin.text, "// Exercise 06: L\xC3\xB6sung\n");
    EXPECT_EQ(latin.remarks.size(), 1U);
    EXPECT_EQ(read(std::string("\xFF\xFE/\0/\0 \0\xF6\0\n\0", 12)).text, "// \xC3\xB6\n");
    EXPECT_EQ(read(std::string("\xFE\xFF\xD8\x3D\xDE\x00\0\n", 8)).text, "\xF0\x9F\x98\x80\n");
    EXPECT_EQ(read(std::string("int\0a;", 6)).reason, "it has zero bytes: it is no text");
    EXPECT_EQ(read(std::string("int\0a;", 6)).state, State::refused);
    EXPECT_EQ(read("").text, "");
}

TEST_F(Package, AFileSaysItsLessonHoweverItIsSpaced)
{
    EXPECT_EQ(lessonOf("namespace  \t rt ::  exercise06\n{"), 6);
    EXPECT_EQ(lessonOf("namespace\n/* x */ exercise07 {"), 7);
    EXPECT_EQ(lessonOf("// namespace rt::exercise06"), std::nullopt);
    EXPECT_EQ(lessonOf("\n// Exercise 05, refraction"), 5);
}

TEST_F(Package, NothingInATextExhaustsUs)
{
    constexpr std::size_t most = 250'000;
    for (const auto& filler :
         {std::string(most, ' '), std::string(most, '\n'), std::string(most, 'a'), std::string(most, '/'),
          std::string(most, '"'), "namespace " + std::string(most, 'g') + " = glm;"})
    {
        write("one.h", filler + "\nnamespace rt::exercise06 {}\n");
        EXPECT_NE(taken(at("one.h")).state, State::missing);
    }
}

TEST_F(Package, AStudentIsNamedByTheEntry)
{
    fs::create_directories(at("ada.b"));
    write("dora.tar.gz", "");
    write("eve.h", "");
    EXPECT_EQ(studentOf(at("ada.b")), "ada.b"); // a folder has no ending
    EXPECT_EQ(studentOf(at("dora.tar.gz")), "dora");
    EXPECT_EQ(studentOf(at("eve.h")), "eve");
    EXPECT_EQ(studentOf(at("bob.ZIP")), "bob");
    EXPECT_EQ(studentOf(at("cy.cpp")), "cy");
    EXPECT_EQ(studentOf(at("dan.tar.xz")), "dan");
    EXPECT_EQ(studentOf(at("fay.h.txt")), "fay");
    EXPECT_EQ(studentOf(at(".gus")), ".gus");
}

TEST_F(Package, EachEntryIsAStudent)
{
    write("class/anna/exercise.h", six);
    write("class/bob.zip", "");
    write("class/carol.tar.gz", "");
    write("class/dora.h", "");
    write("class/notes.txt", "");
    write("class/.DS_Store", "");
    write("class/._bob.zip", "");
    write("class/.hidden/exercise.h", six);
    std::string names;
    for (const auto& one : listSubmissions(at("class"))) names += one.student + " ";
    EXPECT_EQ(names, ".hidden anna bob carol dora notes ");
    fs::create_directory_symlink(at("class/anna"), at("class/linked"));
    write("class/anna.pdf", "");
    write("class/ed.RAR", "");
    names.clear();
    for (const auto& one : listSubmissions(at("class"))) names += one.student + " ";
    EXPECT_EQ(names, ".hidden anna anna.pdf bob carol dora ed linked notes ") << "somebody vanished, or came twice";
    write("class/anna.zip", "");
    EXPECT_THROW(listSubmissions(at("class")), std::runtime_error);
    EXPECT_THROW(listSubmissions(at("nowhere")), std::runtime_error);
}

} // namespace rt::grade
