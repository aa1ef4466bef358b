// What every `main` of the project is made of: no program ends by an uncaught exception. check_sources.py looks at each main.
#pragma once

#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

namespace rt
{

/// Runs a program: guarded(argv, [&] { return run(argc, argv); }). An exception becomes one sentence on standard error and
/// exit code 2, and the stack is unwound, so that temporary files go. runMain does the same for what stands inside it; what
/// comes before, as reading the manifest that the options are made of, needs this.
template <class Work>
int guarded(char** argv, Work&& work)
{
    const char* path = argv && argv[0] ? argv[0] : "raytree";
    const char* slash = std::strrchr(path, '/');
    const char* program = slash ? slash + 1 : path;
    try
    {
        return work();
    }
    catch (const std::bad_alloc&)
    {
        std::fprintf(stderr, "%s: out of memory\n", program);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s: %s\n", program, error.what());
    }
    catch (...)
    {
        std::fprintf(stderr, "%s: stopped by something that is no std::exception\n", program);
    }
    return 2;
}

} // namespace rt
