#include "tests/grade/box/compile.h"

#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "common/spawn.h"
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

/// The kit, where the box's user can read it.
std::string kitFor(const Box& box, int lesson, Kit which)
{
    const std::string kit = which == Kit::whole ? "rest" : lesson == 1 ? "01" : lesson == 4 ? "04" : "rest";
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
    if (box.sandbox == Sandbox::chroot) result.reason = unsafeToCompile(exerciseText);
    if (!result.reason.empty()) return result;

    const TemporaryFolder work;
    const CompilePlaces outside{kitFor(box, lesson, kit), work.path + "/source", work.path + "/out"};
    fs::create_directory(outside.source);
    fs::create_directory(outside.out);
    constexpr mode_t readable = 0755;
    if (::chmod(outside.source.c_str(), readable) != 0 || ::chmod(outside.out.c_str(), readable) != 0 ||
        (::geteuid() == 0 && ::chown(outside.out.c_str(), userOf(box), userOf(box)) != 0))
        throw std::runtime_error(work.path + " cannot be given to the compiler");
    writeFile(outside.source + "/exercise.h", exerciseText);
    constexpr mode_t plain = 0644;
    ::chmod((outside.source + "/exercise.h").c_str(), plain);

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
