// SPDX-License-Identifier: MIT
// What a smoothing spline pays for its derivatives.
#pragma once

#include "fit/least_squares/stencil_matrix.h"

namespace nrb::fit {

// The quadratic form sum_k int (d^order s / dx_k^order)^2 dx over [0, 1]^axes, where x_k is the parameter of axis k as a part
// of its domain, so that it does not depend on how the domain is scaled. An axis of a lower degree contributes nothing. Its
// elements are within 2^-95 of sums of magnitudes, so that polynomials of degree order - 1 still pay nothing beside data
// when the form is multiplied by 2^40.
StencilMatrix penalty(const std::vector<KnotVectorPtr> &axes, int order, const Index &least_reach = {});

// Above it an order penalises nothing.
int highest_degree(const std::vector<KnotVectorPtr> &axes) noexcept;

} // namespace nrb::fit
