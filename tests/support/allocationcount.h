// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// Counts what this thread takes from the heap, in our code and in the libraries. Included by one file of a
/// program: it stands before the C library's allocator, or hooks into the sanitizer's.
class AllocationCount
{
public:
    [[nodiscard]] static long now() { return counter(); }
    static long &counter()
    {
        static thread_local long count = 0;
        return count;
    }
};

#if defined(__SANITIZE_ADDRESS__)

// Of the sanitizer's allocator interface, whose header GCC does not bring.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void *,
                                                                           std::size_t),
                                                         void (*freed)(const volatile void *));

inline const int allocationHook = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void *, std::size_t) { ++AllocationCount::counter(); }, [](const volatile void *) {});

#else

extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t count, std::size_t size);
void *__libc_realloc(void *block, std::size_t size);

void *malloc(std::size_t size) noexcept
{
    ++AllocationCount::counter();
    return __libc_malloc(size);
}

void *calloc(std::size_t count, std::size_t size) noexcept
{
    ++AllocationCount::counter();
    return __libc_calloc(count, size);
}

void *realloc(void *block, std::size_t size) noexcept
{
    ++AllocationCount::counter();
    return __libc_realloc(block, size);
}
}

#endif
