// What starting a process needs: descriptors that close themselves, pipes, the start itself.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <sys/types.h>
#include <unistd.h>

namespace rt
{

/// A file descriptor that closes itself.
struct Descriptor
{
    int fd = -1;

    Descriptor() = default;
    explicit Descriptor(int given) : fd(given) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    void close()
    {
        if (fd >= 0) ::close(fd);
        fd = -1;
    }
};

/// Both ends are 16 or above, so that putting one into the place of 0, 1, 2 or another small number overwrites no other; not
/// inherited. Throws std::runtime_error, naming the program that it is for.
struct Pipe
{
    Descriptor read, write;

    explicit Pipe(const std::string& program);
};

/// Makes reading and writing return at once.
void setNonBlocking(const Descriptor& descriptor);

/// Starts argv[0], searched in PATH, as the leader of a process group of its own, without our signal mask and handlers. Its
/// descriptor i is descriptors[i] (16 or above), or /dev/null for -1, which only 0 may be; it has no others. Its group ends with
/// us, even if we are killed: call forgetProcess() before waiting for it. `environment`:
/// NAME=value, or our own if null. Throws std::runtime_error with one sentence.
pid_t startProcess(const std::vector<std::string>& argv, std::span<const int> descriptors,
                   const std::vector<std::string>* environment = nullptr);

/// It is about to be waited for, and its number may then go to another. Until then its group ends when we do, however that is.
void forgetProcess(pid_t pid);

/// "segmentation fault".
std::string signalText(int number);

} // namespace rt
