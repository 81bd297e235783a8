// SPDX-License-Identifier: MIT
// The power basis: the monomial coefficients of every polynomial piece of a spline, in the distance of each
// parameter from the lower end of its span.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::refine {

// The pieces in the order of their parameters, last axis fastest. Each piece has the coefficients of (t_0 -
// a_0)^k_0 (t_1 - a_1)^k_1 ..., last axis fastest; those of a rational spline are homogeneous records.
struct PowerForm {
    std::vector<int> degrees;
    std::vector<std::vector<double>> breaks; // for each axis, increasing, one more than pieces
    int width = 0;
    std::vector<double> coefficients;
};

// Forward differences of the Bezier points b of every piece: C(p, k) Delta^k b_0 / h^k on a span of length h.
// On each axis they lose (3 k + 1) / 2 eps of 2^k C(p, k) max |b| / h^k, in addition to the error of b.
// Throws Status::not_representable, overflow. Cost: linear in the number of pieces.
PowerForm to_power(const SplinePtr &spline);

// The spline in which every break has multiplicity degree + 1. Along an axis its points are the sums of C(i,
// k) a_k h^k / C(p, k), each within (3 p + 1) / 2 eps of the sum of the magnitudes of its terms.
// Preconditions: the sizes agree; breaks are finite and strictly increasing. Throws what make_spline()
// throws, and Status::not_representable.
SplinePtr from_power(PowerForm form, bool rational);

} // namespace nrb::refine
