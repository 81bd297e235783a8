// Unit normals of a block of surface points: the part of frames that every point pays for.
#pragma once

#include <cstdint>

namespace nrb {

// Squared lengths between these can be divided by without loss; other vectors are scaled first.
inline constexpr double least_square = 0x1p-900;
inline constexpr double largest_square = 0x1p900;

// du and dv hold three rows of block_size doubles (x, y, z), of which the first `count` are used; so do
// `normals`, which receives S_u x S_v / |S_u x S_v|. doubtful[i] is 1 unless |S_u x S_v| certainly exceeds
// |S_u| error_v + |S_v| error_u, the bound of its rounding error, and its square is in the range above, in
// which case it is 0. Returns the number of doubtful points.
int64_t unit_normals(const double *du, const double *dv, int64_t count, double error_u, double error_v,
                     double *normals, double *doubtful) noexcept;

} // namespace nrb
