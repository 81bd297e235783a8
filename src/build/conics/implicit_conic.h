// SPDX-License-Identifier: MIT
// Conics from an implicit equation.
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// An arc of A x^2 + B x y + C y^2 + D x + E y + F = 0 in the plane: of an ellipse from one eccentric angle to
// another, of a parabola or hyperbola from one parameter of parabola() or hyperbola() to another. Throws
// Status::form, and what conic_axes() and those functions throw.
SplinePtr implicit_conic(const double *coefficients, double start, double end, int32_t form);

} // namespace nrb::build
