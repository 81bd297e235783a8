// SPDX-License-Identifier: MIT
// The power basis: monomial coefficients of every polynomial piece of a spline, in the distances from the
// lower ends of its spans.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::refine {

// Pieces in the order of their parameters, last axis fastest; in each the coefficients of
// (t_0 - a_0)^k_0 (t_1 - a_1)^k_1 ..., last axis fastest, of homogeneous records if `rational`.
struct PowerForm {
    std::vector<int> degrees;
    std::vector<std::vector<double>> breaks; // of each axis, rising, one more than it has pieces
    int width = 0;
    std::vector<double> coefficients;
};

// Forward differences of the Bezier points b of every piece: C(p, k) Delta^k b_0 / h^k on a span of length h.
// They lose (3 k + 1) / 2 eps of 2^k C(p, k) max |b| / h^k on each axis, in addition to what b has lost.
// Throws Status::not_representable, overflow. Cost: linear in the number of pieces.
PowerForm to_power(const SplinePtr &spline);

// The spline over breaks that all have multiplicity degree + 1. Its points are the sums of C(i, k) a_k h^k /
// C(p, k), within (3 p + 1) / 2 eps of the sum of the terms' magnitudes on each axis. Preconditions: sizes
// agree; breaks are finite and rise. Throws what make_spline() throws, and Status::not_representable.
SplinePtr from_power(PowerForm form, bool rational);

} // namespace nrb::refine
