// SPDX-License-Identifier: MIT
// The caller's optional output arrays, filled from the rows of a block.
#pragma once

#include "base/records.h"
#include "eval/blocks.h"
#include "numeric/vector3.h"

#include <array>

namespace nrb::eval {

// Bits of a point's status.
enum FrameBits : int32_t {
    frame_limit = 0x01,        // the tangent of a curve, or the normal of a surface, is a one-sided limit
    frame_normal_limit = 0x02, // the normal of a curve in space is a one-sided limit
    frame_rule = 0x04,         // nothing distinguishes a direction: a rule chose it
    frame_undefined = 0x08,    // some result does not exist
};

// The first out.width rows of a block, written to records first, ...; nothing if `out` is not wanted.
void write_rows(const double *rows, int64_t first, int64_t count, const Records &out) noexcept;

// The first out.width coordinates of a vector as record i.
inline void write_vector(const Vector3 &vector, int64_t i, const Records &out,
                         int64_t component = 0) noexcept {
    if (out.data == nullptr) {
        return;
    }
    const std::array<double, 3> values{vector.x, vector.y, vector.z};
    for (int64_t c = 0; c < std::min<int64_t>(3, out.width); ++c) {
        out(i, component + c) = values[static_cast<size_t>(c)];
    }
}

inline void write_value(double value, int64_t i, const Records &out) noexcept {
    if (out.data != nullptr) {
        out(i, 0) = value;
    }
}

inline void write_status(int32_t value, int64_t i, int32_t *out) noexcept {
    if (out != nullptr) {
        out[i] = value;
    }
}

// The vector of dim rows at place i of a block; in the plane z = 0.
inline Vector3 row_vector(const double *rows, int dim, int64_t i) noexcept {
    return {rows[i], rows[block_size + i], dim == 3 ? rows[2 * block_size + i] : 0.0};
}

} // namespace nrb::eval
