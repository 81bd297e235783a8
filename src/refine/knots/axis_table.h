// SPDX-License-Identifier: MIT
// A change of one axis: the new knots, and the table that gives the new layers from the old ones.
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

// Rows first, ..., end - 1 of a refinement.
LayerTable rows_of(const Refinement &refinement, int64_t first, int64_t end);

// The table for a refinement of the axis, which is treated as not periodic. `fine` contains all of its knots.
LayerTable rows_over(const KnotVector &axis, std::span<const double> fine);

// The axis with additional knots, which are sorted and lie in its domain; those of a periodic axis lie below
// its upper end. There the copies in all periods are inserted too, and the wrapped layers have the rows of
// the layers that they repeat. Precondition: no knot will occur more than degree + 1 times. Throws
// Status::periodic_knots, not_representable.
AxisTable refine_axis(const KnotVector &axis, std::span<const double> knots);

// Two sorted lists of knots merged.
std::vector<double> merged(std::span<const double> knots, std::span<const double> more);

// The spline with one axis replaced and its layers made from the table. Throws what apply_along() and
// make_result() throw.
SplinePtr with_axis(const Spline &spline, int k, const AxisTable &made);
// The axes of the spline, with one of them replaced.
Spline::Axes with_axis(const Spline &spline, int k, KnotVectorPtr axis);
// The same with a table that is made in parts: rows(first, end) returns the rows of layers first, ..., end -
// 1. All parts begin at multiples of `unit`.
using RowSource = std::function<LayerTable(int64_t first, int64_t end)>;
SplinePtr with_axis(const Spline &spline, int k, KnotVectorPtr axis, int64_t unit, const RowSource &rows);

} // namespace nrb::refine
