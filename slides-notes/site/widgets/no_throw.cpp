// In a browser nothing throws: the only exceptions of common/ are for numbers that do not fit their type. Here they stop.
#include <cstddef>

extern "C" void* __cxa_allocate_exception(std::size_t)
{
    __builtin_trap();
}

extern "C" void __cxa_throw(void*, void*, void*)
{
    __builtin_trap();
}
