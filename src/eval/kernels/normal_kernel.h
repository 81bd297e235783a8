// SPDX-License-Identifier: MIT
// Unit normals of a block of surface points: the part of the frames that every point needs.
#pragma once

#include <cstdint>

namespace nrb::eval {

// du and dv hold three rows of block_size doubles (x, y, z), of which the first `count` are used. So do
// `normals`, which receive S_u x S_v / |S_u x S_v|. Bit i of the result is 0 if |S_u x S_v| certainly exceeds
// |S_u| error_v + |S_v| error_u, the bound of its rounding error, and its square is in_range(); otherwise it
// is 1.
uint64_t unit_normals(const double *du, const double *dv, int64_t count, double error_u, double error_v,
                      double *normals) noexcept;

} // namespace nrb::eval
