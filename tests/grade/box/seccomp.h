// The system calls that a static, single-threaded program needs to compute, and no others.
#pragma once

#include <string>

namespace rt::grade
{

/// A BPF program in the kernel's binary form, for bubblewrap's --seccomp or PR_SET_SECCOMP. What it does not list kills the
/// process (SIGSYS); opening files and starting processes or threads is refused with an error, as a library may try them
/// without being asked to. Throws std::runtime_error.
const std::string& seccompFilter();

} // namespace rt::grade
