// SPDX-License-Identifier: MIT
// Bounds of the distances of a point from many discs, vectorised.
#pragma once

#include <cstdint>

namespace nrb::pieces {

struct DiscBounds {
    double *bounds;  // lower bounds of sign * distance
    double *centres; // upper bounds of sign * distance from a point of the surface near the centre
};

// A family of `width` discs is stored as an array of columns [width]: the coordinates of the centres c, the
// radii, and, with normals, the three coordinates of the normals n, |n| <= 1, and the least and the largest
// height n . (p - c) of the points p. The component of p - c across n has the length
// sqrt(|p - c|^2 - height^2), at most the radius. For every v, the pair (n . v, its length across n) has the
// length of v, as (n . v, (I - n n^T)^(1/2) v) has, so that a normal shorter than 1 gives valid bounds, too.
struct FloatDiscs {
    const float *columns;
    double apart; // the largest distance of a centre from a point of the surface
};
int64_t disc_columns(int dim, bool normals) noexcept;
void bound_discs(const FloatDiscs &family, int64_t width, int dim, bool normals, const double *x,
                 bool farthest, const DiscBounds &out) noexcept;

// The same with integers q: centres are frame[c] + frame[dim] q, radii frame[dim + 1] (q + 127), heights
// frame[dim + 2] q, and normals normal_unit q.
struct ByteDiscs {
    const int8_t *columns; // without the normals
    const int16_t *normals;
    const float *frame;
    double apart;
};
constexpr int64_t disc_frame(int dim) noexcept {
    return dim + 3;
}
inline constexpr double normal_unit = 0x1p-15;
// Reads and writes up to 7 elements beyond `width`, whatever they contain.
void bound_discs(const ByteDiscs &family, int64_t width, int dim, bool normals, const double *x,
                 bool farthest, const DiscBounds &out) noexcept;

} // namespace nrb::pieces
