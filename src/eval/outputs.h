// The caller's optional output arrays, filled from the rows of a block.
#pragma once

#include "base/records.h"
#include "eval/blocks.h"
#include "eval/vector3.h"

#include <array>

namespace nrb {

// Bits of a point's status.
enum FrameBits : int32_t {
    frame_limit = NURBS_FRAME_LIMIT,
    frame_normal_limit = NURBS_FRAME_NORMAL_LIMIT,
    frame_rule = NURBS_FRAME_RULE,
    frame_undefined = NURBS_FRAME_UNDEFINED,
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

} // namespace nrb
