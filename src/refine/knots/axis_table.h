// SPDX-License-Identifier: MIT
// The result of refinement on one axis: its knots, and the table that gives the new layers from the old ones.
#pragma once

#include "refine/knots/refinement.h"
#include "spline/layer_table.h"

#include <functional>
#include <span>
#include <vector>

namespace nrb::refine {

struct AxisTable {
    KnotVectorPtr axis;
    LayerTable table;
};

// Rows [first, end) of a refinement.
LayerTable rows_of(const Refinement &refinement, int64_t first, int64_t end);

// The layers over knots that contain all knots of the axis, which is treated as a plain one.
LayerTable rows_over(const KnotVector &axis, std::span<const double> fine);

// The axis with more knots, which are sorted and lie in its domain. On a periodic axis they lie below the
// upper end, they bring their copies in all periods, and the wrapped layers are the same rows. Precondition:
// no knot will occur more than degree + 1 times. Throws Status::periodic_knots, not_representable.
AxisTable refine_axis(const KnotVector &axis, std::span<const double> knots);

// The knots of a sorted list together with those of another sorted list.
std::vector<double> merged(std::span<const double> knots, std::span<const double> more);

// The spline with one axis replaced. Throws what apply_along() and make_result() throw.
SplinePtr with_axis(const Spline &spline, int k, const AxisTable &made);
// The axes of the spline with one of them replaced.
Spline::Axes with_axis(const Spline &spline, int k, KnotVectorPtr axis);
// The spline with one axis replaced, with the table in parts: rows(first, end) are those of layers first,
// ..., end - 1. Boundaries of parts are multiples of `unit`.
using RowSource = std::function<LayerTable(int64_t first, int64_t end)>;
SplinePtr with_axis(const Spline &spline, int k, KnotVectorPtr axis, int64_t unit, const RowSource &rows);

} // namespace nrb::refine
