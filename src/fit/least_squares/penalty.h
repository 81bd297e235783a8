// SPDX-License-Identifier: MIT
// The roughness penalty of smoothing splines.
#pragma once

#include "fit/least_squares/stencil_matrix.h"

namespace nrb::fit {

// The quadratic form sum_k int (d^order s / dx_k^order)^2 dx over [0, 1]^axes. x_k is the parameter of axis k
// relative to its domain, so that the form does not depend on the scale of the domain. An axis of a lower
// degree contributes nothing. The elements are within 2^-95 of the sums of the magnitudes of their terms, so
// that polynomials of degree order - 1 still have no penalty beside the data when the form is multiplied by
// 2^40.
StencilMatrix penalty(const std::vector<KnotVectorPtr> &axes, int order, const Index &least_reach = {});

// The highest degree of the axes; a penalty of a higher order vanishes.
int highest_degree(const std::vector<KnotVectorPtr> &axes) noexcept;

} // namespace nrb::fit
