/* SPDX-License-Identifier: MIT */
#include "random/held.h"

#include <cerrno>
#include <cstddef>
#include <malloc.h>

namespace held {

int64_t now = 0, peak = 0;

namespace {

void *added(void *place) {
    now += static_cast<int64_t>(malloc_usable_size(place));
    peak = now > peak ? now : peak;
    return place;
}

void removed(void *place) {
    now -= static_cast<int64_t>(malloc_usable_size(place));
}

} // namespace

} // namespace held

extern "C" {

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *place, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *place);

void *malloc(size_t size) {
    return held::added(__libc_malloc(size));
}

void *calloc(size_t count, size_t size) {
    return held::added(__libc_calloc(count, size));
}

void *realloc(void *place, size_t size) {
    held::removed(place);
    void *moved = __libc_realloc(place, size);
    held::added(moved == nullptr && size > 0 ? place : moved);
    return moved;
}

void *memalign(size_t alignment, size_t size) {
    return held::added(__libc_memalign(alignment, size));
}

void *aligned_alloc(size_t alignment, size_t size) {
    return held::added(__libc_memalign(alignment, size));
}

int posix_memalign(void **place, size_t alignment, size_t size) {
    *place = held::added(__libc_memalign(alignment, size));
    return *place == nullptr ? ENOMEM : 0;
}

void free(void *place) {
    held::removed(place);
    __libc_free(place);
}
}
