// SPDX-License-Identifier: MIT
// Values of polar forms.
#pragma once

#include "refine/algebra/common_knots.h"
#include "spline/spline.h"

#include <array>
#include <span>

namespace nrb::refine {

// The polar form of the piece on a non-empty span of an axis at degree arguments, as coefficients of its
// control points. Arguments that are the knots next to the span, without a gap, fix as many parameters of the
// polar form; the others follow by de Boor's algorithm with the knots around them. So control points come out
// bit for bit, and factors lie in [0, 1] for arguments between these knots.
BlossomRow blossom_row(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept;

// Arguments of a polar form: the knots begin, ..., end - 1 next to the span, without a gap, and `others`, which are not.
struct KnotArguments {
    int64_t begin, end;
    int others;
    std::array<double, max_basis> values;
};
KnotArguments split_arguments(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept;

// The polar form of the piece on the non-empty spans `spans`, one for each axis, at degree arguments for each
// axis, one axis after the other: `width()` components of an unscaled homogeneous record, (w x, ..., w) or
// (x, ...). L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6 (1989). Cost: degree^2
// / 2 divisions for each axis, and the cost of a point.
void blossom(const Spline &spline, const int64_t *spans, std::span<const double> arguments, double *out);

} // namespace nrb::refine
