// SPDX-License-Identifier: MIT
// The elements of the inverse of a sparse symmetric matrix at the nonzero positions of its factor.
#pragma once

#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <vector>

namespace nrb::inline numeric {

// Takahashi's recurrence, from the last column to the first (K. Takahashi, J. Fagan, M.-S. Chin, "Formation
// of a sparse bus impedance matrix", 8th PICA Conference (1973)); it reads only elements that it has itself
// computed. Cost: twice that of the factorisation. Supernodes are treated as dense blocks.
class SelectedInverse {
public:
    template <class Number>
    explicit SelectedInverse(const LdltOf<Number> &factors);

    // sum_ij inverse_ij matrix_ij, for a matrix with the pattern of the factorised one.
    [[nodiscard]] double trace_of_product(const SparseColumns &matrix) const noexcept;
    // 0 where the element is not known.
    [[nodiscard]] double element(int64_t i, int64_t j) const noexcept;

private:
    template <class Number>
    void invert_columns(const LdltOf<Number> &factors);

    std::vector<int64_t> starts_;
    std::vector<int32_t> rows_;
    std::vector<double> values_; // below the diagonal
    std::vector<double> diagonal_;
};

} // namespace nrb::inline numeric
