// SPDX-License-Identifier: MIT
// Bernstein spans: the homogeneous Bezier points of a span, in scaled Bernstein form. Spans of curves are
// evaluated in this form if their degree is high or their weights differ widely.
//
// Let c_i = binomial(p, i) (w_i x_i, w_i), and q = (t - a) / (b - t) on a span [a, b]. C(t) is the quotient
// of the coordinate and weight parts of the sum of c_i q^i: the common factor, a power of b - t, cancels. For
// t beyond the middle, q is inverted and the order reversed, so that q <= 1 (the scheme of L. Schumaker, W.
// Volk, Comput. Aided Geom. Design 3 (1986)). Where the weights are positive, the weight sum does not cancel:
// every c_i q^i has a relative error of about i eps, whatever the other weights are.
#pragma once

#include "basis/power_spans.h"

namespace nrb::inline basis {

// Takes the place of a power span in a table of power spans. Its head begins with NaN bounds, between which
// no parameter lies; then come a and b, which are NaN if the span has neither form. Its lanes hold dim
// coordinates and the weight.
struct BernsteinSpan {
    enum Head { a = PowerSpan::middle, b = PowerSpan::scale, head_size = PowerSpan::head_size };
};

// Writes the Bernstein span of span `span`. points: [degree + 1][lanes], the control points of N_(span-p),
// ..., N_span, with 1 as component dim; all are multiplied by `weights`. Each value is the exact one, rounded
// once up to an error of about 2^-98. Preconditions: degree >= 1; the lengths of the supports have finite
// inverses; products with 2^31 do not overflow.
void make_bernstein_span(const double *knots, int degree, int64_t span, const double *weights,
                         const double *points, int lanes, double *out) noexcept;

} // namespace nrb::inline basis
