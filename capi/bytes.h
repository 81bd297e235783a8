// SPDX-License-Identifier: MIT
// Handles as bytes: what the functions for each kind of handle share.
#pragma once

#include "outputs.h"

#include <span>

namespace nrb::capi {

// size >= 0, and bytes if it is > 0.
std::span<const unsigned char> checked_bytes(const void *bytes, int64_t size);

// Writes `needed` bytes by write(span) if they are wanted.
template <class Write>
void give_bytes(size_t needed, int64_t cap, void *bytes, int64_t *length, Write &&write) {
    const auto size = static_cast<int64_t>(needed);
    if (checked_cap(cap, size) > 0 && bytes != nullptr) {
        check_apart({{"bytes", bytes, cap}, memory("length", length, 1)}, {});
        write(std::span(static_cast<unsigned char *>(bytes), needed));
    }
    put(length, size);
}

} // namespace nrb::capi
