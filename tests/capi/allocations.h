/* SPDX-License-Identifier: MIT */
// Replaces malloc and its family in this program, for the libraries that it loads too: counts what is live,
// and fails allocations on demand. glibc's own allocator stays underneath.
//
// libstdc++ allocates exception objects with malloc as well; where that fails it takes them from a pool set
// aside at start-up, so that std::bad_alloc arrives all the same.
#ifndef NURBS_TESTS_CAPI_ALLOCATIONS_H
#define NURBS_TESTS_CAPI_ALLOCATIONS_H

#include "sanitized.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace allocations {

struct Block {
    void *place;
    size_t bytes;
};

// Blocks allocated since tracking began and not yet freed. No container: this runs inside malloc.
struct Log {
    bool tracking = false;
    int64_t count = 0;    // allocations since tracking began
    int64_t fail_at = 0;  // number of the allocation that fails, 0: none
    bool fail_on = false; // whether the later ones fail too
    bool failed = false;
    size_t held = 0; // bytes of the live blocks
    size_t peak = 0; // the largest `held`
    size_t live = 0;
    std::array<Block, 8192> blocks{};
};

inline Log log;

inline bool refuses() {
    if (!log.tracking) {
        return false;
    }
    ++log.count;
    const bool now =
        log.fail_at != 0 && (log.count == log.fail_at || (log.fail_on && log.count > log.fail_at));
    log.failed = log.failed || now;
    if (now) {
        errno = ENOMEM;
    }
    return now;
}

inline void *add(void *place, size_t bytes) {
    if (log.tracking && place != nullptr) {
        if (log.live == log.blocks.size()) {
            std::abort();
        }
        log.blocks[log.live++] = {place, bytes};
        log.held += bytes;
        log.peak = log.held > log.peak ? log.held : log.peak;
    }
    return place;
}

inline void remove(const void *place) {
    for (size_t i = log.live; log.tracking && i-- > 0;) {
        if (log.blocks[i].place == place) {
            log.held -= log.blocks[i].bytes;
            log.blocks[i] = log.blocks[--log.live];
            return;
        }
    }
}

inline void begin() {
    log.count = 0;
    log.live = 0;
    log.held = 0;
    log.peak = 0;
    log.tracking = true;
}

inline void end() {
    log.tracking = false;
}

// The next allocations are numbered from 1; number `k` fails, and with `on` all that follow.
inline void fail(int64_t k, bool on) {
    log.count = 0;
    log.fail_at = k;
    log.fail_on = on;
    log.failed = false;
}

} // namespace allocations

#ifndef ALLOCATIONS_BELONG_TO_A_SANITIZER
extern "C" {
void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t n, size_t bytes);
void *__libc_realloc(void *place, size_t bytes);
void *__libc_memalign(size_t alignment, size_t bytes);
void __libc_free(void *place);

void *malloc(size_t bytes) noexcept {
    return allocations::refuses() ? nullptr : allocations::add(__libc_malloc(bytes), bytes);
}

void *calloc(size_t n, size_t bytes) noexcept {
    return allocations::refuses() ? nullptr : allocations::add(__libc_calloc(n, bytes), n * bytes);
}

void *realloc(void *place, size_t bytes) noexcept {
    if (allocations::refuses()) {
        return nullptr;
    }
    allocations::remove(place);
    return allocations::add(__libc_realloc(place, bytes), bytes);
}

void *aligned_alloc(size_t alignment, size_t bytes) noexcept {
    return allocations::refuses() ? nullptr : allocations::add(__libc_memalign(alignment, bytes), bytes);
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
    allocations::remove(place);
    __libc_free(place);
}
}
#endif

#endif
