// SPDX-License-Identifier: MIT
// Multifrontal L D L^T factorisation.
#pragma once

#include "numeric/solvers/sparse/supernodes.h"

#include <cstdint>
#include <span>

namespace nrb::inline numeric {

// The multifrontal method (I. Duff, J. Reid, ACM Trans. Math. Softw. 9 (1983)): the updates that the columns
// of a supernode and of its subtree make to later columns form one dense matrix, which the parent adds to its
// own front. So all work is done by products of dense matrices, which read each number many times while it is
// in the cache.
//
// values: column j of L starts at starts[j], with the later columns of its supernode first, then the rows
// below. Returns -1, or the index of the first pivot that is not above its floor (no floors: 0).
int64_t factorise_fronts(const SparseColumns &matrix, const Supernodes &supernodes,
                         std::span<const double> floors, std::span<const int64_t> starts,
                         std::span<double> values, std::span<double> diagonal);

// Solves for `width` right-hand sides stored side by side, x[size][width], in place.
void solve_fronts(const Supernodes &supernodes, std::span<const int64_t> starts,
                  std::span<const double> values, std::span<const double> diagonal, double *x, int64_t width);

} // namespace nrb::inline numeric
