// SPDX-License-Identifier: MIT
// One copy of a knot taken out: the local system, its residual and its solution (W. Tiller, "Knot-removal
// algorithms for NURBS curves and surfaces", CAD 24 (1992); Piegl & Tiller 5.4).
#pragma once

#include "basis/bspline.h"

#include <cstdint>

namespace nrb::reduce {

// Putting knot u = t_r, the last of s copies, back into the result gives
//     Q_i = alpha_i P_i + (1 - alpha_i) P_(i-1),   alpha_i = (u - t_i) / (t_(i+p+1) - t_i),
//     r - p <= i <= r - s.
// These are rows = p - s + 1 equations for one unknown layer less; the neighbours P_(r-p-1) = Q_(r-p-1) and
// P_(r-s) = Q_(r-s+1) are fixed. With the left null vector n of the system, rho = sum n_i (Q_i - what is
// fixed in it) has to vanish. If it does not, the smallest residuals have alternating signs and the one size
// |rho| / sum |n_i|. Moved by them the system is consistent, and the result is g - sum_i +-gap N_i, so that
// it is within |gap| of g everywhere.
struct RemovalStep {
    int rows;
    int skipped; // the row that the solution does not use
    double alpha[max_basis];
    double beta[max_basis];           // 1 - alpha
    double functional[max_basis + 2]; // gap = sum functional[i] * layer (r - p - 1 + i), i < rows + 2
};

// `last` points to t_r; last[-p], ..., last[p - s + 1] are read. Precondition: 1 <= multiplicity <= degree.
// The alphas fall with i, which makes every divisor of the solution at least 1/2, except for one, which is
// the larger of two. Cost: O(degree).
RemovalStep removal_step(const double *last, int degree, int multiplicity) noexcept;

// Layers r - p - 1, ..., r - s + 1 of the spline, `width` values each.
using RemovalWindow = double *const *;

void removal_gap(const RemovalStep &step, RemovalWindow window, int64_t width, double *gap) noexcept;

// Replaces the layers by those of the result, in place and in order; window[skipped + 1] is not among them.
// Rounding is multiplied by up to 2 in each equation.
void remove_layer(const RemovalStep &step, RemovalWindow window, int64_t width, const double *gap) noexcept;

} // namespace nrb::reduce
