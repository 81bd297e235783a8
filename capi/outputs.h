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

// How many values go into arrays of a stated length: none if it is 0, which asks for the number, else all that there
// are. Throws NURBS_ERROR_SIZE if they do not fit.
inline int64_t checked_cap(int64_t cap, int64_t needed) {
    check_length(cap, "cap");
    if (cap != 0 && cap < needed) {
        fail(Status::size, "cap = %lld, expected 0 or at least %lld", static_cast<long long>(cap),
             static_cast<long long>(needed));
    }
    return cap == 0 ? 0 : needed;
}

} // namespace nrb::capi
