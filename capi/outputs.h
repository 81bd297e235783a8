// SPDX-License-Identifier: MIT
// Writing to the caller's output arrays. An output that is NULL is not wanted.
#pragma once

#include "checks.h"

#include <algorithm>
#include <array>
#include <span>

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
// Copies a whole range.
template <class T, class Range>
void put_all(T *out, const Range &values) noexcept {
    if (out != nullptr) {
        std::copy(values.begin(), values.end(), out);
    }
}

// The status of bounds that were proven to within the tolerance, or not.
inline int32_t bounds_status(bool certified) noexcept {
    return certified ? NURBS_CLOSEST_CERTIFIED : NURBS_CLOSEST_BUDGET;
}

// The number of values to be written to arrays of length `cap`: none if cap is 0, which asks for the number
// only, otherwise all. Throws NURBS_ERROR_SIZE if they do not fit.
inline int64_t checked_cap(int64_t cap, int64_t needed) {
    check_length(cap, "cap");
    if (cap != 0 && cap < needed) {
        fail(Status::size, "cap = %lld, expected 0 or at least %lld", static_cast<long long>(cap),
             static_cast<long long>(needed));
    }
    return cap == 0 ? 0 : needed;
}

// Stores the number of knots and, unless cap is 0, the knots.
inline void give_knots(std::span<const double> own, int64_t cap, double *knots, int64_t *count) {
    const int64_t filled = checked_cap(cap, std::ssize(own));
    check_apart({memory("knots", knots, filled), memory("count", count, 1)}, {});
    put_all(knots, own.first(static_cast<size_t>(filled)));
    put(count, std::ssize(own));
}

// An output array as the caller describes it: records of `width` values.
struct Wanted {
    const char *name;
    double *data;
    int64_t width;
    int64_t stride;
    int64_t component_stride;
};

// The strided outputs of a batch, and its array `status`. None may overlap another one or an input. The
// strides of outputs that are NULL are ignored.
class Outputs {
public:
    Outputs(int64_t count, const int32_t *status);

    // A view of the output, after a check that it overlaps none of the outputs before it. Precondition: at
    // most 6 are added.
    Records add(const Wanted &wanted);
    // Checks that no output overlaps an input.
    void check(const char *name, const ConstRecords &input) const;
    void check(const Memory &input) const;

private:
    struct Named {
        const char *name;
        Records records;

        [[nodiscard]] Memory memory() const noexcept {
            return capi::memory(name, records.data, records.extent());
        }
    };

    int64_t count_;
    Memory status_;
    size_t size_ = 0;
    std::array<Named, 6> outputs_{};
};

} // namespace nrb::capi
