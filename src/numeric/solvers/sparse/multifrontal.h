// SPDX-License-Identifier: MIT
// L D L^T by dense blocks.
#pragma once

#include "numeric/solvers/sparse/supernodes.h"

#include <cstdint>
#include <span>

namespace nrb::inline numeric {

// The multifrontal method (I. Duff, J. Reid, ACM Trans. Math. Softw. 9 (1983)): what the columns of a supernode and those of
// its subtree do to the columns behind is one dense matrix, which the parent adds to its own. So all work is done by
// products of dense matrices, which read each number many times while it is in the cache.
// values: of column j of L from starts[j] on, those of its supernode behind it and the rows below. Returns -1, or the first
// element of the diagonal that is not above its floor (none: 0).
int64_t factorise_fronts(const SparseColumns &matrix, const Supernodes &supernodes,
                         std::span<const double> floors, std::span<const int64_t> starts,
                         std::span<double> values, std::span<double> diagonal);

// Solves for `width` right sides side by side, x[size][width], in place.
void solve_fronts(const Supernodes &supernodes, std::span<const int64_t> starts,
                  std::span<const double> values, std::span<const double> diagonal, double *x, int64_t width);

} // namespace nrb::inline numeric
