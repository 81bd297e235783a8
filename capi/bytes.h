// SPDX-License-Identifier: MIT
// Serialization of handles: what the functions for each kind of handle share.
#pragma once

#include "outputs.h"

#include <span>

namespace nrb::capi {

// The caller's bytes. Throws NURBS_ERROR_COUNT if size < 0, and NURBS_ERROR_NULL if bytes is NULL although
// size > 0.
std::span<const unsigned char> checked_bytes(const void *bytes, int64_t size);

// Stores `needed` as the length, and has write(span) fill that many bytes if `bytes` is not NULL and cap > 0.
// Throws NURBS_ERROR_SIZE if cap is neither 0 nor at least `needed`.
template <class Write>
void give_bytes(size_t needed, int64_t cap, void *bytes, int64_t *length, Write &&write) {
    const auto size = static_cast<int64_t>(needed);
    if (checked_cap(cap, size) > 0 && bytes != nullptr) {
        check_apart({{"bytes", bytes, size}, memory("length", length, 1)}, {});
        write(std::span(static_cast<unsigned char *>(bytes), needed));
    }
    put(length, size);
}

} // namespace nrb::capi
