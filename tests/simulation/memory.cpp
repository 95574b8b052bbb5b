#include "simulation/memory.hpp"

#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {
thread_local std::ptrdiff_t live{};

void* take(void* memory) noexcept {
    if (memory != nullptr) live += static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
    return memory;
}
void give(void* memory) noexcept {
    if (memory != nullptr) live -= static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
    std::free(memory);
}
} // namespace

std::ptrdiff_t simulation::live_bytes() noexcept { return live; }

// The form that throws nothing is replaced too: under a sanitizer its own would not go through this one.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size) {
    if (void* memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept { give(memory); }
void operator delete(void* memory, std::size_t) noexcept { give(memory); }
