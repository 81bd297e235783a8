// SPDX-License-Identifier: MIT
// How the Bezier points of a piece of an axis come from its control points.
#pragma once

#include "spline/layer_table.h"

#include <vector>

namespace nrb::pieces {

// Rows [e * (degree + 1), ...) give the Bezier points of the piece after break e. Breaks rise, in the domain,
// all knots between the first and the last among them.
LayerTable piece_rows(const KnotVector &axis, const std::vector<double> &breaks);

// The first of the degree + 1 layers that are active after each break but the last.
std::vector<int64_t> first_layers(const KnotVector &axis, const std::vector<double> &breaks);

} // namespace nrb::pieces
