// SPDX-License-Identifier: MIT
// Bounds of the distances of a point from many discs, in vectors.
#pragma once

#include <cstdint>

namespace nrb::closest {

// Discs: a family of `width` of them is an array of columns [width]: the coordinates of the
// centres, the radii, and, with normals, the three coordinates of the unit normals and the least and the
// largest height over the plane through the centre.
struct DiscBounds {
    double *bounds;  // of sign * distance, from below
    double *centres; // sign * distance of the centre
};
int64_t disc_columns(int dim, bool normals) noexcept;
void bound_discs(const double *family, int64_t width, int dim, bool normals, const double *x, bool farthest,
                 const DiscBounds &out) noexcept;

// The same in bytes q: centres are frame[c] + frame[dim] q, radii frame[dim + 1] q, heights frame[dim + 2] q,
// and normals frame[dim + 3 + c] + frame[dim + 6] q divided by their length, which is not near 0.
struct ByteDiscs {
    const int8_t *columns;
    const float *frame;
};
int64_t disc_frame(int dim, bool normals) noexcept; // numbers in it
inline constexpr double unit_length = 1 - 0x1p-50;  // of such a normal, so that it is not above 1
// Up to 7 more than `width` are read and written, whatever stands there.
void bound_discs(const ByteDiscs &family, int64_t width, int dim, bool normals, const double *x,
                 bool farthest, const DiscBounds &out) noexcept;

} // namespace nrb::closest
