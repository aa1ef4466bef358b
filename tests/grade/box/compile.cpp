#include "tests/grade/box/compile.h"

#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "common/program/spawn.h"
#include "tests/grade/box/child.h"
#include "tests/grade/box/compiler_messages.h"
#include "tests/grade/box/source_text.h"
#include "tests/grade/box/temporary_folder.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t largestFile = std::size_t(64) << 20;

Limits compileLimits()
{
    Limits limits;
    limits.cpuSeconds = 20;
    // A compiler waits for nothing but a busy machine, which is no fault of the student's: processor time is its bound.
    limits.wallSeconds = 600;
    limits.memory = std::size_t(2) << 30;
    limits.textBytes = std::size_t(4) << 20;
    return limits;
}

std::vector<std::string> linesOf(const std::string& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    if (lines.empty()) throw std::runtime_error(path + " is missing: build the target grade_kit");
    return lines;
}

std::string nameOf(Kit which, int lesson)
{
    return which == Kit::whole ? "rest" : lesson == 1 ? "01" : lesson == 4 ? "04" : "rest";
}

/// The kit, where the box's user can read it.
std::string kitFor(const Box& box, const std::string& kit)
{
    const std::string built = std::string(GRADE_KIT) + "/" + kit;
    if (canReach(box, built)) return built;
    // The course lies in somebody's home: a copy, once.
    static std::mutex mutex;
    static TemporaryFolder copies;
    const std::lock_guard lock(mutex);
    const auto copy = copies.path + "/" + kit;
    if (!fs::exists(copy)) fs::copy(built, copy, fs::copy_options::recursive);
    return copy;
}

/// Where bubblewrap cannot run: a root folder that holds the compiler, the standard library and the kits, and so nothing that a
/// submission should not read. Copied once; users may read it, and write nowhere in it.
class CompilerRoot
{
public:
    /// Of the kit, made when it is first asked for.
    std::string withKit(const std::string& kit)
    {
        const std::lock_guard lock(mutex);
        if (!hasCompiler)
        {
            for (const auto& file : linesOf(std::string(GRADE_KIT) + "/compiler_files")) add(file, file);
            for (const char* name : {"/bin", "/lib", "/lib64"})
                if (std::error_code error; fs::is_symlink(name)) fs::copy_symlink(name, folder.path + name, error);
            hasCompiler = true;
        }
        const std::string built = std::string(GRADE_KIT) + "/" + kit, inside = "/kit-" + kit;
        if (!fs::exists(folder.path + inside))
            for (const auto& entry : fs::recursive_directory_iterator(built))
                if (entry.is_regular_file()) add(entry.path(), inside / fs::relative(entry.path(), built));
        return folder.path + inside;
    }
    const std::string& path() const { return folder.path; }

private:
    TemporaryFolder folder;
    std::mutex mutex;
    bool hasCompiler = false;

    /// Whatever our umask is, others may read it.
    void add(const fs::path& file, const fs::path& inside)
    {
        const auto to = fs::path(folder.path + inside.string());
        for (auto missing = to.parent_path(); !fs::exists(missing); missing = missing.parent_path())
            made.push_back(missing);
        for (; !made.empty(); made.pop_back())
        {
            fs::create_directory(made.back());
            fs::permissions(made.back(), fs::perms(0755));
        }
        fs::copy_file(file, to);
        fs::permissions(to, fs::perms(0755));
    }
    std::vector<fs::path> made;
};

CompilerRoot& compilerRoot()
{
    static CompilerRoot root;
    return root;
}

void writeFile(const std::string& path, const std::string& text)
{
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error(path + " cannot be written");
}

/// What the box wrote is taken only if it is a plain file, not a link to one of ours.
void take(const std::string& from, const std::string& to)
{
    const Descriptor file(::open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
    struct stat state
    {
    };
    if (file.fd < 0 || ::fstat(file.fd, &state) != 0 || !S_ISREG(state.st_mode) ||
        std::size_t(state.st_size) > largestFile)
        throw std::runtime_error("the compiler wrote no program");
    std::string bytes(std::size_t(state.st_size), '\0');
    for (std::size_t done = 0; done < bytes.size();)
    {
        const auto got = ::read(file.fd, bytes.data() + done, bytes.size() - done);
        if (got <= 0) throw std::runtime_error("the program cannot be read");
        done += std::size_t(got);
    }
    std::error_code ignored;
    fs::remove(to, ignored);
    writeFile(to, bytes);
    constexpr auto mode = fs::perms(0755);
    fs::permissions(to, mode);
}

/// Empty folders for the source and the program; in the fallback below the compiler's root folder, one a worker.
CompilePlaces placesFor(const Box& box, const std::string& kit, const std::string& work)
{
    CompilePlaces places;
    std::string top = work;
    if (box.sandbox == Sandbox::chroot)
    {
        places.kit = compilerRoot().withKit(kit);
        places.root = compilerRoot().path();
        top = fmt::format("{}/work-{}", places.root, box.worker);
        fs::remove_all(top);
        fs::create_directory(top);
        fs::permissions(top, fs::perms(0755));
    }
    else
        places.kit = kitFor(box, kit);
    places.source = top + "/source";
    places.out = top + "/out";
    fs::create_directory(places.source);
    fs::create_directory(places.out);
    return places;
}

/// What the compiler reads and where it writes is its user's, and nobody else's: other workers compile in the same root folder.
void giveTo(const Box& box, const CompilePlaces& places)
{
    const auto user = userOf(box);
    for (const auto& path : {places.source, places.source + "/exercise.h", places.out})
    {
        fs::permissions(path, path.ends_with(".h") ? fs::perms(0600) : fs::perms(0700));
        if (::geteuid() == 0 && ::chown(path.c_str(), user, user) != 0)
            throw std::runtime_error(path + " cannot be given to the compiler");
    }
}

std::vector<std::string> compilerWords(int lesson, Fill fill, const CompilePlaces& in)
{
    const std::string base = GRADE_KIT;
    std::vector<std::string> words = {linesOf(base + "/compiler").front()};
    for (const auto& flag : linesOf(base + "/flags")) words.push_back(flag);
    words.push_back(fill == Fill::zero ? "-ftrivial-auto-var-init=zero" : "-ftrivial-auto-var-init=pattern");
    words.push_back(fmt::format("-DRAYTREE_LESSON={}", lesson));
    words.push_back(fmt::format("-DRAYTREE_EXERCISE=exercise{:02}", lesson));
    for (const auto& word :
         {"-I" + in.kit, "-I" + in.source, in.kit + "/tests/grade/wire/exercise.student.cpp", in.kit + "/runner.o",
          std::string("-static"), std::string("-s"), std::string("-o"), in.out + "/program"})
        words.push_back(word);
    return words;
}

std::string tooMuch(const Child::End& end, const Limits& limits)
{
    if (end.outcome == Outcome::timedOut)
        return fmt::format("compiling exercise.h takes too long: more than {:.0f} s", limits.cpuSeconds);
    if (end.outcome == Outcome::protocol) return "compiling exercise.h prints too much";
    return "";
}

} // namespace

Compiled compileSubmission(const Box& box, int lesson, const std::string& exerciseText, const std::string& folder,
                           Fill fill, Kit kit)
{
    Compiled result;
    result.remarks = remarksOn(exerciseText, lesson);

    const TemporaryFolder work;
    const auto outside = placesFor(box, nameOf(kit, lesson), work.path);
    writeFile(outside.source + "/exercise.h", exerciseText);
    giveTo(box, outside);

    const auto inside = placesInside(box, outside);
    const auto limits = compileLimits();
    Child compiler(compileCommand(box, limits, outside, largestFile, compilerWords(lesson, fill, inside)), limits);
    std::string none;
    compiler.receive(none, 1, limits.wallSeconds); // until it ends
    const auto end = compiler.finish();
    result.cpuSeconds = end.cpuSeconds;
    const auto output = compiler.text();
    if (end.exitCode == 0)
    {
        result.program = fmt::format("{}/exercise{:02}{}", folder, lesson, fill == Fill::zero ? "_zero" : "");
        take(outside.out + "/program", result.program);
        result.ok = true;
        return result;
    }
    result.errors = errorsIn(output, {inside.source, inside.kit, inside.out, "/usr/include", "/usr/bin"});
    result.reason = tooMuch(end, limits);
    if (result.reason.empty()) result.reason = reasonIn(output, lesson);
    return result;
}

} // namespace rt::grade
