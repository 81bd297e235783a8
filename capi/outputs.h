// Outputs, of which those that are NULL are not wanted.
#pragma once

#include "checks.h"

#include <algorithm>

namespace nrb::capi {

template <class T>
void put(T *out, T value) noexcept {
    if (out != nullptr) {
        *out = value;
    }
}
template <class T>
void put(T *out, size_t i, T value) noexcept {
    if (out != nullptr) {
        out[i] = value;
    }
}
// All of a range.
template <class T, class Range>
void put_all(T *out, const Range &values) noexcept {
    if (out != nullptr) {
        std::copy(values.begin(), values.end(), out);
    }
}

// The length of arrays for as many values: 0, which asks for the number, or enough; else NURBS_ERROR_SIZE.
inline void check_cap(int64_t cap, int64_t needed) {
    check_length(cap, "cap");
    if (cap != 0 && cap < needed) {
        fail(NURBS_ERROR_SIZE, "cap = %lld, expected 0 or at least %lld", static_cast<long long>(cap),
             static_cast<long long>(needed));
    }
}

} // namespace nrb::capi
