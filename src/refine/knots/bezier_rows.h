// SPDX-License-Identifier: MIT
// The Bezier points of every piece of an axis as rows of coefficients.
#pragma once

#include "basis/knot_vector.h"
#include "spline/layer_table.h"

#include <span>
#include <vector>

namespace nrb::refine {

// Row e (p + 1) + i gives Bezier point i of non-empty span e of the domain: the polar form at p - i times the
// start of the span and i times its end. Arguments for which the end of the span already occurs often enough
// as a knot cost nothing. The others are de Boor's steps, as in rows_of() and with the same bits.
LayerTable bezier_rows(const KnotVector &axis);
// The rows of spans first, ..., end - 1.
LayerTable bezier_rows(const KnotVector &axis, int64_t first, int64_t end);

// The ends of the spans of the domain.
std::vector<double> breaks_of(const KnotVector &axis);

// Every break degree + 1 times: the knots of all pieces side by side.
KnotVectorPtr bezier_knots(int degree, std::span<const double> breaks);

} // namespace nrb::refine
