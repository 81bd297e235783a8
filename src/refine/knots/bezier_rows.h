// SPDX-License-Identifier: MIT
// Decomposition of an axis into Bezier pieces, as rows of coefficients (Bezier extraction).
#pragma once

#include "basis/knot_vector.h"
#include "spline/layer_table.h"

#include <span>
#include <vector>

namespace nrb::refine {

// Row e (p + 1) + i gives Bezier point i of non-empty span e of the domain: the polar form with p - i
// arguments equal to the start of the span and i equal to its end. As many of these as are knots there need
// no step. Each of the others is one step of de Boor's algorithm, as in rows_of() and with the same bits.
LayerTable bezier_rows(const KnotVector &axis);
// The rows of spans first, ..., end - 1.
LayerTable bezier_rows(const KnotVector &axis, int64_t first, int64_t end);

// The breaks of an axis: the ends of the non-empty spans of its domain.
std::vector<double> breaks_of(const KnotVector &axis);

// The knots of all Bezier pieces side by side: every break degree + 1 times.
KnotVectorPtr bezier_knots(int degree, std::span<const double> breaks);

} // namespace nrb::refine
