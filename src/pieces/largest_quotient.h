// SPDX-License-Identifier: MIT
// Encloses the largest value of |N(t)| / W(t), or of N(t) / W(t), over Bernstein pieces by branch and bound.
#pragma once

#include "bernstein/products.h"
#include "pieces/branch_and_bound.h"

#include <functional>
#include <vector>

namespace nrb::pieces {

// A vector polynomial N and a scalar polynomial W of the same degrees, with bounds of their rounding errors:
// for the exact coefficients N*, W*
//     |N_i - N*_i| <= numerator_error + quotient_error |W_i|,
//     |W_i - W*_i| <= denominator_error + denominator_factor |W_i|.
struct QuotientPiece {
    BernsteinShape shape;
    std::vector<double> numerators;
    std::vector<double> denominators; // empty: all 1
    double numerator_error = 0;
    double quotient_error = 0;
    double denominator_error = 0;
    double denominator_factor = 0;
    int last_axis = -1;                           // the axis along which it was halved last
    std::array<double, max_axes> start{};         // the part of the original piece that this one covers;
    std::array<double, max_axes> extent{1, 1, 1}; // that piece covers [0, 1] along every axis
};

// Bounds of |N| / W over one piece, in the Euclidean norm and including all rounding: it is at most the
// largest quotient of coefficients if all W_i > 0 (the mediant inequality), and at least that at the corners.
// The upper bound is infinite where W cannot be shown to have one sign throughout.
Enclosure quotient_bounds(const QuotientPiece &piece);

// Halves a piece along the next axis after last_axis that has a degree; `piece` becomes the upper half, the
// lower half is returned.
QuotientPiece halve(QuotientPiece &piece);
// The same along a given axis.
QuotientPiece halve(QuotientPiece &piece, int axis);

// The search ends when the bounds agree to a factor of 1 + ratio, apart from rounding, or after `steps`
// subdivisions.
struct SearchLimits {
    double ratio = 0.25;
    int steps = 600;
};

// Fills in piece i; may be called more than once for each piece.
using PieceSource = std::function<void(int64_t, QuotientPiece &)>;

// Encloses the largest value over pieces 0, 1, ..., whose upper bounds are given. Both bounds are proven.
Enclosure largest_quotient(std::span<const double> uppers, const PieceSource &source,
                           const SearchLimits &limits = {});
// An upper bound for each piece, obtained by subdivision where its own coefficients give none.
std::vector<double> quotient_uppers(int64_t count, const PieceSource &source);

// The largest value of N / W for a scalar N, and where the lower bound is attained: in piece `piece`, at a
// local parameter in [0, 1] on each of the three axes; piece is -1 if W cannot be shown to have a sign
// anywhere. The search ends when the bounds agree to `gap`, apart from rounding, or after `steps`
// subdivisions. Fewer steps are made where pieces have more than some thousands of coefficients, so that
// memory does not run out.
struct LargestValue {
    Enclosure bounds;
    int64_t piece = -1;
    std::array<double, max_axes> place{};
};
LargestValue largest_value(int64_t count, const PieceSource &source, double gap, int steps);

} // namespace nrb::pieces
