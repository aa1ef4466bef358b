// An OpenGL library that fails at its first call on the display that RAYTREE_BROKEN_DISPLAY names, as RAYTREE_BROKEN_HOW
// says; elsewhere the real one is called. To be preloaded.
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <unistd.h>

extern "C" int glXQueryExtension(void* display, int* error, int* event)
{
    const char *broken = std::getenv("RAYTREE_BROKEN_DISPLAY"), *name = std::getenv("DISPLAY");
    if (broken && name && std::strcmp(broken, name) == 0)
    {
        const char* how = std::getenv("RAYTREE_BROKEN_HOW");
        if (how && std::strcmp(how, "crash") == 0) std::raise(SIGSEGV);
        if (how && std::strcmp(how, "abort") == 0) std::abort();
        if (how && std::strcmp(how, "exit") == 0) std::exit(0);
        while (true) pause();
    }
    using Function = int (*)(void*, int*, int*);
    const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glXQueryExtension"));
    return real ? real(display, error, event) : 0;
}
