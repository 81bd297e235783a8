// SPDX-License-Identifier: MIT
// The integral of squared derivatives of a spline as a quadratic form of its control points.
#pragma once

#include "numeric/solvers/sparse/sparse_system.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::modify {

// The entries of the energy matrix: for the originals i and j (copies on periodic axes are added to them),
// the sum over the axes of the integral over the domain of N_i^(order) N_j^(order), with derivatives along
// that axis. Axes of a lower degree contribute nothing. On a span of length h, N_i is a polynomial in
// Bernstein form (refine/knots/extraction.h), its derivatives are differences of coefficients, and the
// integral of B_i B_j of degree m is h binomial(m, i) binomial(m, j) / (binomial(2 m, i + j) (2 m + 1)).
// Cost: for each control point the product of 2 degree + 1 over the axes.
std::vector<Entry> energy_entries(const Spline &spline, int order);

} // namespace nrb::modify
