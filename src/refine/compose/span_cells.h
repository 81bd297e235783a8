// SPDX-License-Identifier: MIT
// The pieces of a curve between the knots of the axes that it runs over.
#pragma once

#include "refine/compose/crossings.h"

#include <array>
#include <vector>

namespace nrb::refine {

// An interval, up to the start of the next one, on which a curve is a polynomial and its values lie in one
// span of each axis. Spans that are shorter than the uncertainty of the values may be left out; values there
// count as if they lay in a neighbouring span.
struct SpanCell {
    double start;
    size_t piece; // of the curve
    std::array<int64_t, max_axes> spans;
};

// The cells of all pieces; together the cells of a piece cover one span of the curve. Throws
// Status::outside_domain if the curve leaves the domain of an axis by more than its uncertainty.
std::vector<SpanCell> span_cells(const Spline::Axes &axes, const std::vector<CurvePiece> &pieces);

// The knot of an axis that a value equals to within its uncertainty, or the value.
double snapped(const KnotVector &axis, double value, double uncertainty) noexcept;
// The same for coordinate k of a piece at its parameter t. The pieces on both sides count: one of them may be much steeper.
double snapped_value(const KnotVector &axis, double value, const std::vector<CurvePiece> &pieces,
                     size_t piece, int k, double t) noexcept;

} // namespace nrb::refine
