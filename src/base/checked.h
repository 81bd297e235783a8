// SPDX-License-Identifier: MIT
// Checked sizes: array lengths whose sums and products cannot overflow silently.
#pragma once

#include "base/error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace nrb::inline base {

// The largest number of doubles an array may hold. Its size in bytes must fit std::ptrdiff_t, and no
// processor gives a program more than 2^56 bytes of address space. Sizes below both limits can be added and
// converted to bytes without a check.
inline constexpr int64_t max_doubles =
    std::min((int64_t{1} << 53) - 1,
             int64_t{std::numeric_limits<std::ptrdiff_t>::max()} / static_cast<int64_t>(sizeof(double)));

// Returns the length n of an array; fails with Status::overflow if n exceeds max_doubles. `what` names the
// array in the message.
inline int64_t checked_array(int64_t n, const char *what) {
    if (n > max_doubles) {
        fail(Status::overflow, "%s: %lld values exceed the address space", what, static_cast<long long>(n));
    }
    return n;
}

// a * b for a, b >= 0; fails with Status::overflow if the product exceeds max_doubles.
inline int64_t checked_product(int64_t a, int64_t b, const char *what) {
    // two factors below this need no division
    constexpr int64_t surely_small = sizeof(std::ptrdiff_t) == 8 ? int64_t{1} << 26 : int64_t{1} << 14;
    if ((a | b) >= surely_small && b != 0 && a > max_doubles / b) {
        fail(Status::overflow, "%s: %lld * %lld values exceed the address space", what,
             static_cast<long long>(a), static_cast<long long>(b));
    }
    return a * b;
}

// a + b for a, b >= 0; fails with Status::overflow if the sum exceeds max_doubles.
inline int64_t checked_sum(int64_t a, int64_t b, const char *what) {
    if (a > max_doubles - b) {
        fail(Status::overflow, "%s: %lld + %lld values exceed the address space", what,
             static_cast<long long>(a), static_cast<long long>(b));
    }
    return a + b;
}

} // namespace nrb::inline base
