// SPDX-License-Identifier: MIT
// Factors of what is near the diagonal of a symmetric matrix of which only products are known.
#pragma once

#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace nrb::inline numeric {

// The elements at most `reach` from the diagonal of a matrix whose others are small: one product shows those of every column
// number 2 reach + 1 (A. Curtis, M. Powell, J. Reid, J. Inst. Math. Appl. 13 (1974)), with errors of the size of the others.
// All elements of a matrix that has no others. Nothing where they are no positive matrix.
std::optional<SparseLdlt>
probed_band(int64_t size, int64_t reach,
            const std::function<std::vector<double>(const std::vector<double> &)> &product);

} // namespace nrb::inline numeric
