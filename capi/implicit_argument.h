// SPDX-License-Identifier: MIT
// Implicit polynomials as arguments: f(x) = 0 is a line, a plane, a conic, a quadric, and so on.
#pragma once

#include "intersect/implicit_form.h"

namespace nrb::capi {

// The polynomial in `dim` variables with the caller's coefficients. Throws NURBS_ERROR_NULL, _DEGREE,
// _POINT_NOT_FINITE; _DIRECTION if all but the last coefficient are 0.
intersect::ImplicitForm checked_form(int dim, int32_t degree, const double *coefficients);

} // namespace nrb::capi
