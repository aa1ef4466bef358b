// What tests of the box must know of the machine they run on.
#pragma once

#include <string>
#include <vector>

#include <unistd.h>

#include "common/program/process.h"
#include "tests/grade/box/box.h"

namespace rt::grade
{

inline bool isRoot()
{
    return ::geteuid() == 0;
}

/// Those that this user may ask for. chroot is for root, and others are refused (SelfTest.FindsTheFallbackTight); so .ci/run runs
/// what the box is tested with as root too.
inline std::vector<Sandbox> sandboxesHere()
{
    if (isRoot()) return {Sandbox::bubblewrap, Sandbox::chroot, Sandbox::none};
    return {Sandbox::bubblewrap, Sandbox::none};
}

/// Why bubblewrap cannot run here, whatever it is asked for: containers often allow no user namespaces. Empty: it can, and then
/// what the grader asks of it must work.
inline const std::string& noBubblewrap()
{
    static const std::string why = [] {
        std::vector<std::string> words;
        if (isRoot()) words = {"/usr/bin/setpriv", "--reuid", "60580", "--regid", "60580", "--clear-groups"};
        for (const char* word :
             {"/usr/bin/bwrap", "--unshare-user", "--unshare-all", "--ro-bind", "/", "/", "/bin/true"})
            words.push_back(word);
        ProcessLimits limits;
        limits.seconds = 600;
        try
        {
            return describeFailure("bubblewrap cannot run here: it", runProcess(words, limits));
        }
        catch (const std::exception& error)
        {
            return "bubblewrap cannot run here: " + std::string(error.what());
        }
    }();
    return why;
}

} // namespace rt::grade
