// Sizes that cannot overflow silently.
#pragma once

#include "base/error.h"

#include <cstdint>
#include <limits>

namespace nrb {

// Largest number of doubles that an array can hold: its size in bytes must fit a signed 64-bit integer.
inline constexpr int64_t max_doubles =
    std::numeric_limits<int64_t>::max() / static_cast<int64_t>(sizeof(double));

// a * b for a, b >= 0, refused beyond max_doubles. `what` names the array in the message.
inline int64_t checked_product(int64_t a, int64_t b, const char *what) {
    constexpr int64_t surely_small = int64_t{1} << 30; // spares every call the division
    if ((a | b) >= surely_small && b != 0 && a > max_doubles / b) {
        fail(NURBS_ERROR_OVERFLOW, "%s: %lld * %lld values exceed the address space", what,
             static_cast<long long>(a), static_cast<long long>(b));
    }
    return a * b;
}

// a + b for a, b >= 0, refused beyond max_doubles.
inline int64_t checked_sum(int64_t a, int64_t b, const char *what) {
    if (a > max_doubles - b) {
        fail(NURBS_ERROR_OVERFLOW, "%s: %lld + %lld values exceed the address space", what,
             static_cast<long long>(a), static_cast<long long>(b));
    }
    return a + b;
}

} // namespace nrb
