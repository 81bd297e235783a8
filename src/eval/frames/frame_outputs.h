// SPDX-License-Identifier: MIT
// Writers to the caller's optional output arrays, from the rows of a block or from vectors.
#pragma once

#include "base/records.h"
#include "eval/blocks.h"
#include "numeric/vector3.h"

#include <array>

namespace nrb::eval {

// The bits of a point's status, with the values of NURBS_FRAME_ in nurbs.h.
enum FrameBits : int32_t {
    frame_limit = 0x01,        // the tangent of a curve, or the normal of a surface, is a one-sided limit
    frame_normal_limit = 0x02, // the normal of a curve in space is a one-sided limit
    frame_rule = 0x04,         // nothing distinguishes a direction: a rule chose it
    frame_undefined = 0x08,    // some result does not exist
};

// Writes the first out.width rows of a block to records first, first + 1, ...; does nothing if `out` is not
// wanted.
void write_rows(const double *rows, int64_t first, int64_t count, const Records &out) noexcept;

// Writes the first coordinates of a vector, at most out.width, to record i, beginning with component
// `component`; does nothing if `out` is not wanted.
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

// The vector whose coordinates are in `dim` rows, at index i of a block. A vector of the plane gets z = 0.
inline Vector3 row_vector(const double *rows, int dim, int64_t i) noexcept {
    return {rows[i], rows[block_size + i], dim == 3 ? rows[2 * block_size + i] : 0.0};
}

} // namespace nrb::eval
