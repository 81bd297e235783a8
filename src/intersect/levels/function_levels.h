// SPDX-License-Identifier: MIT
// Level curves of functions on a surface.
#pragma once

#include "intersect/implicit_form.h"
#include "intersect/levels/level_meet.h"

#include <span>

namespace nrb::intersect {

// Where an implicit polynomial in space, such as a quadric or another algebraic surface, vanishes on a
// surface. tolerance > 0.
Meet implicit_level(const Spline &surface, const ImplicitForm &form, double tolerance);

// Where a scalar spline over the domain of a surface has given values, one level for each of them.
// tolerance > 0, in space. Throws Status::incompatible if the domains differ or only one of them is periodic,
// and what refinement throws.
Meet scalar_levels(const SplinePtr &surface, const SplinePtr &scalar, std::span<const double> values,
                   double tolerance);

} // namespace nrb::intersect
