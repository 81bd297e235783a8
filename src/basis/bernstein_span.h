// SPDX-License-Identifier: MIT
// Bernstein spans: homogeneous Bezier points of a span, the form in which spans of curves are evaluated whose degree is
// high, or whose weights lie far apart.
//
// With c_i = binomial(p, i) (w_i x_i, w_i) and q = (t - a) / (b - t) on a span [a, b], C(t) is the quotient of the
// parts of the sum of c_i q^i: the power of b - t that is left out cancels. For t beyond the middle q is inverted and
// the order reversed, so that q <= 1 (the scheme of L. Schumaker, W. Volk, Comput. Aided Geom. Design 3 (1986)). Where
// weights are positive, no sum cancels: every c_i q^i has a relative error of some i eps, whatever the other weights
// are.
#pragma once

#include "basis/power_spans.h"

namespace nrb::inline basis {

// Stands in a table of power spans in place of one: its head begins with NaN bounds, which no parameter lies between;
// then come a and b, NaN if the span has neither form. Its lanes hold dim coordinates, and the weight.
struct BernsteinSpan {
    enum Head { a = PowerSpan::middle, b = PowerSpan::scale, head_size = PowerSpan::head_size };
};

// Writes the Bernstein span of span `span`. points: [degree + 1][lanes], those of N_(span-p), ..., N_span with 1 as
// component dim, all times `weights`. Each value is that of exact arithmetic, rounded once but for about 2^-98.
// Preconditions: degree >= 1; lengths of supports of functions have inverses; products with 2^31 do not overflow.
void make_bernstein_span(const double *knots, int degree, int64_t span, const double *weights,
                         const double *points, int lanes, double *out) noexcept;

} // namespace nrb::inline basis
