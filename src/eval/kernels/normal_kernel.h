// SPDX-License-Identifier: MIT
// Unit normals of a block of surface points: the part of surface frames that every point needs.
#pragma once

#include <cstdint>

namespace nrb::eval {

// Computes the unit normals S_u x S_v / |S_u x S_v| of `count` points. du, dv and `normals` consist of three
// rows of block_size doubles (x, y, z), of which the first `count` are used. Bit i of the result is 0 if
// normal i is certainly regular: |S_u x S_v| exceeds |S_u| error_v + |S_v| error_u, the bound of its rounding
// error, and its square is in_range(). Otherwise the bit is 1.
uint64_t unit_normals(const double *du, const double *dv, int64_t count, double error_u, double error_v,
                      double *normals) noexcept;

} // namespace nrb::eval
