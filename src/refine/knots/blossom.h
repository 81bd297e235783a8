// SPDX-License-Identifier: MIT
// Values of polar forms (blossoms) of polynomial pieces.
#pragma once

#include "refine/algebra/common_knots.h"
#include "spline/spline.h"

#include <array>
#include <span>

namespace nrb::refine {

// The polar form of the piece on a non-empty span of an axis, at `degree` arguments, as coefficients of its
// control points. Arguments equal to the knots next to the span, without a gap, need no arithmetic. Each of
// the others is one step of de Boor's algorithm over the knots around them. So control points are reproduced
// bit for bit, and factors lie in [0, 1] if the other arguments lie between these knots.
BlossomRow blossom_row(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept;

// Arguments of a polar form, split in two: the knots begin, ..., end - 1 next to the span, without a gap, and
// the first `others` of `values`, which are not among these.
struct KnotArguments {
    int64_t begin, end;
    int others;
    std::array<double, max_basis> values;
};
KnotArguments split_arguments(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept;

// The polar form of the piece on the non-empty spans spans[k] at degree arguments for each axis, one axis
// after the other. Writes width() components of an unscaled homogeneous record: (w x, ..., w), or (x, ...) if
// the spline is polynomial. L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6 (1989).
// Cost: degree^2 / 2 divisions for each axis, and the cost of evaluating a point.
void blossom(const Spline &spline, const int64_t *spans, std::span<const double> arguments, double *out);

} // namespace nrb::refine
