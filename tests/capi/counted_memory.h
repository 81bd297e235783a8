/* SPDX-License-Identifier: MIT */
// Replaces malloc and its family in this program, for the libraries that it loads too, by functions that count bytes: how many are held
// at most, however many blocks these are (allocations.h knows each of a few). glibc's own allocator stays underneath.
#ifndef NURBS_TESTS_CAPI_COUNTED_MEMORY_H
#define NURBS_TESTS_CAPI_COUNTED_MEMORY_H

#include "sanitized.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <malloc.h>

namespace counted_memory {

inline int64_t held = 0, peak = 0;

inline void *add(void *place) {
    held += static_cast<int64_t>(malloc_usable_size(place)); // 0 for null
    peak = held > peak ? held : peak;
    return place;
}
inline void remove(void *place) {
    held -= static_cast<int64_t>(malloc_usable_size(place));
}

inline int64_t at_begin = 0;
inline void begin() {
    at_begin = peak = held;
}
// The most that was held at once since begin(), beyond what was held then.
inline int64_t end() {
    return peak - at_begin;
}

} // namespace counted_memory

#ifndef ALLOCATIONS_BELONG_TO_A_SANITIZER
extern "C" {
void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t n, size_t bytes);
void *__libc_realloc(void *place, size_t bytes);
void *__libc_memalign(size_t alignment, size_t bytes);
void __libc_free(void *place);

void *malloc(size_t bytes) noexcept {
    return counted_memory::add(__libc_malloc(bytes));
}
void *calloc(size_t n, size_t bytes) noexcept {
    return counted_memory::add(__libc_calloc(n, bytes));
}
void *realloc(void *place, size_t bytes) noexcept {
    const auto before = static_cast<int64_t>(malloc_usable_size(place));
    void *moved = __libc_realloc(place, bytes);
    if (moved != nullptr || bytes == 0) {
        counted_memory::held -= before;
    }
    return counted_memory::add(moved);
}
void *aligned_alloc(size_t alignment, size_t bytes) noexcept {
    return counted_memory::add(__libc_memalign(alignment, bytes));
}
int posix_memalign(void **place, size_t alignment, size_t bytes) noexcept {
    void *block = aligned_alloc(alignment, bytes);
    if (block == nullptr) {
        return ENOMEM;
    }
    *place = block;
    return 0;
}
void free(void *place) noexcept {
    counted_memory::remove(place);
    __libc_free(place);
}
}
#endif

#endif
