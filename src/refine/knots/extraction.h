// SPDX-License-Identifier: MIT
// Bezier extraction: M. J. Borden, M. A. Scott, J. A. Evans, T. J. R. Hughes, "Isogeometric finite element
// data structures based on Bezier extraction of NURBS", International Journal for Numerical Methods in
// Engineering 87 (2011).
#pragma once

#include "basis/knot_vector.h"
#include "numeric/double_double.h"

namespace nrb::refine {

// The extraction matrix C[j][k], [degree + 1][degree + 1], of a span: N_(span - degree + j) = sum_k C[j][k]
// B_k over [knots[span], knots[span + 1]], with the Bernstein polynomials B_k. Column k is the polar form
// with degree - k arguments equal to the start and k equal to the end of the span, as coefficients of the
// control points (Ramshaw 1989). All factors lie in [0, 1] and all terms are >= 0, so an entry has a relative
// error of at most 3 p eps, as in basis_values(). Preconditions: knots[span] < knots[span + 1], degree <=
// span, and span + degree is a valid index. Cost: O(p^3), with p^3 / 6 divisions.
void bezier_extraction(const double *knots, int degree, int64_t span, double *matrix) noexcept;

// The same in double-double arithmetic. Entries have an absolute error of at most 2^-98 p; they are at most
// 1.
void bezier_extraction(const double *knots, int degree, int64_t span, DoubleDouble *matrix) noexcept;

// For all non-empty spans of the domain: the matrix, the index of the first active function, and the two
// ends. Each output may be null.
void bezier_extraction(const KnotVector &axis, double *matrices, int64_t *firsts, double *domains);

} // namespace nrb::refine
