// From homogeneous derivatives to Cartesian ones.
#pragma once

#include "base/scratch.h"

#include <cstddef>

namespace nrb {

// The quotient rule in several variables (Leibniz; Piegl & Tiller 4.3, 4.5): with A = w C,
//   C^a = (A^a - sum over 0 < b <= a of binomial(a, b) w^b C^(a-b)) / w.
class QuotientRule {
public:
    [[nodiscard]] static size_t scratch_size(int order) noexcept;
    QuotientRule(int axes, int dim, int order, Scratch &scratch) noexcept;

    // homogeneous: [slots][dim + 1]; cartesian: [slots][dim], slots in graded order.
    void operator()(const double *homogeneous, double *cartesian) const noexcept;

private:
    [[nodiscard]] double binomial(int n, int k) const noexcept;
    void subtract_products(int i, int j, int k, const double *homogeneous, const double *cartesian,
                           double *sum) const noexcept;

    int axes_;
    int dim_;
    int order_;
    double *binomials_; // Pascal's triangle, row n from n (n + 1) / 2 on
};

} // namespace nrb
