// SPDX-License-Identifier: MIT
// Cells: a curve divided where it crosses the knots of the axes over which it runs.
#pragma once

#include "refine/compose/crossings.h"

#include <array>
#include <vector>

namespace nrb::refine {

// A cell: an interval, from `start` to the start of the next cell, on which the curve is a polynomial and its
// values lie in one span of each axis. Spans shorter than the uncertainty of the values may be missing;
// values in such a span are assigned to a neighbouring one.
struct SpanCell {
    double start;
    size_t piece; // index of the curve's piece
    std::array<int64_t, max_axes> spans;
};

// The cells of all pieces, in order. The cells of a piece together cover its span of the curve. Throws
// Status::outside_domain if the curve leaves the domain of an axis by more than its uncertainty.
std::vector<SpanCell> span_cells(const Spline::Axes &axes, const std::vector<CurvePiece> &pieces);

// The knot of the axis nearest to the value, if it differs by no more than the uncertainty; else the value.
double snapped(const KnotVector &axis, double value, double uncertainty) noexcept;
// The same for coordinate k of a piece at its parameter t. If t is an end of the piece, the smaller
// uncertainty of the two pieces that meet there decides, since one of them may be much steeper.
double snapped_value(const KnotVector &axis, double value, const std::vector<CurvePiece> &pieces,
                     size_t piece, int k, double t) noexcept;

} // namespace nrb::refine
