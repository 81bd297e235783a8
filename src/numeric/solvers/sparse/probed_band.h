// SPDX-License-Identifier: MIT
// Factors of the band around the diagonal of a symmetric matrix that is known only through products: a banded
// preconditioner.
#pragma once

#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace nrb::inline numeric {

// Recovers the elements within `reach` of the diagonal, for a matrix whose other elements are small. One
// product yields every (2 reach + 1)-th column (A. Curtis, M. Powell, J. Reid, J. Inst. Math. Appl. 13
// (1974)), with errors of the size of the other elements; a matrix without others is recovered exactly. Empty
// if the band is not positive definite.
std::optional<SparseLdlt>
probed_band(int64_t size, int64_t reach,
            const std::function<std::vector<double>(const std::vector<double> &)> &product);

} // namespace nrb::inline numeric
