// SPDX-License-Identifier: MIT
// How far a spline is from a shape, with proof.
#pragma once

#include "pieces/largest_quotient.h"
#include "recognize/shape_model.h"
#include "spline/spline.h"

namespace nrb::recognize {

// The largest distance of a point of the spline from the shape with exactly these numbers (the axis taken for
// a unit vector, and x for its part across it), enclosed. Homogeneous Bezier pieces in the frame of the shape
// are put into its equation: Bernstein coefficients of the numerator over those of a power of the weight
// bound the value of the equation (the mediant inequality), and a bound of the gradient, or of the second
// factor of the equation of a torus, makes a distance of it. Pieces are halved until the bounds agree to a
// factor of 5/4 apart from rounding. All rounding is in the upper bound. The search ends as well when the
// lower bound exceeds the tolerance, or after a number of steps; where the weights have no certain sign the
// upper bound is infinite. Precondition: values near 1 in size, so that fourth powers of lengths neither
// overflow nor underflow.
pieces::Enclosure distance_from(const Spline &spline, const Shape &shape, double tolerance);

} // namespace nrb::recognize
