// SPDX-License-Identifier: MIT
// Removal of one copy of a knot: the local system, its residual and its solution (W. Tiller, "Knot-removal
// algorithms for NURBS curves and surfaces", CAD 24 (1992); Piegl & Tiller 5.4).
#pragma once

#include "basis/bspline.h"

#include <cstdint>

namespace nrb::reduce {

// Let P_i be the control points after the removal, and Q_i the given ones. Reinserting the knot u = t_r, the
// last of s copies, gives
//     Q_i = alpha_i P_i + (1 - alpha_i) P_(i-1),   alpha_i = (u - t_i) / (t_(i+p+1) - t_i),
//     r - p <= i <= r - s.
// These are rows = p - s + 1 equations for rows - 1 unknown layers; the neighbours P_(r-p-1) = Q_(r-p-1) and
// P_(r-s) = Q_(r-s+1) are fixed. They are consistent if and only if rho = 0, where n is the left null vector
// of the system and rho = sum n_i (Q_i - the fixed terms of row i). Otherwise the smallest possible residuals
// all have the size gap = |rho| / sum |n_i|, with alternating signs. If the Q_i are changed by these
// residuals, the system is consistent, and its result is g - sum_i +-gap N_i for the given spline g, which is
// within |gap| of g everywhere.
struct RemovalStep {
    int rows;
    int skipped; // the row that the solution does not use
    double alpha[max_basis];
    double beta[max_basis];           // 1 - alpha
    double functional[max_basis + 2]; // gap = sum functional[i] * layer (r - p - 1 + i), i < rows + 2
};

// `last` points to t_r; last[-p], ..., last[p - s + 1] are read. Precondition: 1 <= multiplicity <= degree.
// The alphas decrease with i, so every divisor of the solution is at least 1/2, except for one, which is the
// larger of two candidates. Cost: O(degree).
RemovalStep removal_step(const double *last, int degree, int multiplicity) noexcept;

// Layers r - p - 1, ..., r - s + 1 of the spline, `width` values each.
using RemovalWindow = double *const *;

void removal_gap(const RemovalStep &step, RemovalWindow window, int64_t width, double *gap) noexcept;

// Replaces the layers by those of the result, in place and in order; window[skipped + 1] is not among them.
// Each equation amplifies rounding errors by a factor of at most 2.
void remove_layer(const RemovalStep &step, RemovalWindow window, int64_t width, const double *gap) noexcept;

} // namespace nrb::reduce
