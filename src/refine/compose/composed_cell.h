// SPDX-License-Identifier: MIT
// A composition over one cell, where both functions are polynomials, as Bernstein coefficients.
#pragma once

#include "basis/bspline.h"
#include "basis/knot_vector.h"
#include "numeric/sum.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::refine {

// The polar values of the inner curve at its Bernstein coefficients 0, ..., q over the cell, coordinate by coordinate,
// and their weights.
struct CellArguments {
    std::array<std::array<double, max_basis>, max_axes> values;
    std::array<std::array<double, max_basis>, max_axes> weights; // 1 of a polynomial curve
};

// With the polar form G of the outer function and coefficients b_j of the inner one, of degree q,
//     c_i = sum of prod_m C(q, j_m) G(b_(j_1), b_(j_2), ...) / C(n, i)   over all j with j_1 + j_2 + ... = i,
// where the arguments of each axis are of its own coordinate (A. DeRose, R. Goldman, H. Hagen, S. Mann, "Functional
// composition algorithms via blossoming", ACM Trans. Graph. 12 (1993)). The arguments of an axis are taken together by
// their sum before the next axis is looked at, since what follows depends on that alone. Terms are positive multiples of
// values of G, added up as if in twice the precision.
class ComposedCell {
public:
    // The axes of the outer function, in which the records of its control points have `width` values.
    ComposedCell(std::span<const KnotVectorPtr> axes, int inner_degree, int width);

    // Coefficients [n + 1][width], n = q times the sum of the degrees. block: the control points of the outer function
    // that are active in the spans of the cell, last axis fastest.
    const std::vector<double> &make(const double *block, std::span<const int64_t> spans,
                                    const CellArguments &arguments);

private:
    // Numbers of coefficients that do not fall, in as many orders as there are; times the binomials.
    struct Choice {
        std::array<int, max_basis> numbers;
        int sum;
        double ways;
    };
    static std::vector<Choice> choices(int degree, int inner_degree);
    void take_axis(size_t k, int64_t span, const CellArguments &arguments);

    std::span<const KnotVectorPtr> axes_;
    int inner_degree_;
    int width_;
    std::vector<std::vector<Choice>> choices_; // of each axis
    int64_t length_ = 0;                       // of a state: the axes that are left
    std::vector<double> states_, contracted_;  // one for each sum so far
    std::vector<CompensatedSum> sums_;
};

} // namespace nrb::refine
