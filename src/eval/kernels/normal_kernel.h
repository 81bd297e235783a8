// Unit normals of a block of surface points: the part of frames that every point pays for.
#pragma once

#include <cstdint>

namespace nrb::eval {

// du and dv hold three rows of block_size doubles (x, y, z), of which the first `count` are used; so do
// `normals`, which receives S_u x S_v / |S_u x S_v|. Bit i of the result is 1 unless |S_u x S_v| certainly
// exceeds |S_u| error_v + |S_v| error_u, the bound of its rounding error, and its square is in_range(), in
// which case it is 0.
uint64_t unit_normals(const double *du, const double *dv, int64_t count, double error_u, double error_v,
                      double *normals) noexcept;

} // namespace nrb::eval
