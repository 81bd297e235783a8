// SPDX-License-Identifier: MIT
// Those elements of the inverse of a sparse symmetric matrix where its factor is not 0.
#pragma once

#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <vector>

namespace nrb::inline numeric {

// From the last column to the first one (K. Takahashi, J. Fagan, M.-S. Chin, "Formation of a sparse bus impedance matrix",
// 8th PICA Conference (1973)); the elements that the recurrence reads are among those that it makes. Cost: that of the
// factorisation, twice. Supernodes are treated as dense blocks.
class SelectedInverse {
public:
    template <class Number>
    explicit SelectedInverse(const LdltOf<Number> &factors);

    // sum_ij inverse_ij matrix_ij, for a matrix whose elements lie where those of the factorised one did.
    [[nodiscard]] double trace_of_product(const SparseColumns &matrix) const noexcept;
    // 0 where it is not known.
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
