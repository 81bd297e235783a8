// SPDX-License-Identifier: MIT
// Curves on a surface along which a function has given values.
#pragma once

#include "intersect/implicit_form.h"
#include "intersect/levels/level_meet.h"

#include <span>

namespace nrb::intersect {

// Where an implicit polynomial of space vanishes on a surface: a quadric, an algebraic surface. tolerance > 0.
Meet implicit_level(const Spline &surface, const ImplicitForm &form, double tolerance);

// Where a scalar spline over the domain of a surface has values, one after the other. tolerance > 0: in space. Throws
// Status::incompatible if the domains differ or one is periodic where the other is not, and what refinement throws.
Meet scalar_levels(const SplinePtr &surface, const SplinePtr &scalar, std::span<const double> values,
                   double tolerance);

} // namespace nrb::intersect
