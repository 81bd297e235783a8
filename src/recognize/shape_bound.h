// SPDX-License-Identifier: MIT
// Proven bounds on how far a spline is from a shape.
#pragma once

#include "pieces/largest_quotient.h"
#include "recognize/shape_model.h"
#include "spline/spline.h"

namespace nrb::recognize {

// Encloses the largest distance of a point of the spline from the shape with exactly the given numbers (z
// normalized, and the part of x orthogonal to it normalized). The homogeneous Bezier pieces in the frame of
// the shape are substituted into its implicit equation. The Bernstein coefficients of the numerator divided
// by those of a power of the weight bound the value of the equation (mediant inequality). A bound on the
// gradient, or on the second factor of the equation of a torus, converts values to distances. Pieces are
// halved until the bounds agree to a factor of 5/4, apart from rounding. The upper bound includes all
// rounding. The search also ends when the lower bound exceeds the tolerance, or after a number of steps. If
// the weights have no certain sign, the upper bound is infinite. Precondition: values near 1 in size, so that
// fourth powers of lengths neither overflow nor underflow.
pieces::Enclosure distance_from(const Spline &spline, const Shape &shape, double tolerance);

} // namespace nrb::recognize
