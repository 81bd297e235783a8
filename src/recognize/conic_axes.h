// SPDX-License-Identifier: MIT
// A conic from its equation.
#pragma once

#include "recognize/conic_type.h"

namespace nrb::recognize {

// Of an ellipse: centre, semi-axes, x along the longer one; of a hyperbola: centre, semi-axes along x and
// across, x towards a vertex; x[0] > 0, or x = (0, 1). Of a parabola: vertex, focal length and 0, x towards
// the focus.
struct ConicAxes {
    int32_t type; // conic_ellipse, conic_parabola or conic_hyperbola
    double origin[2];
    double x[2]; // a unit vector
    double sizes[2];
};

// Of A x^2 + B x y + C y^2 + D x + E y + F = 0, six coefficients in this order. The kind is that of the sign
// of B^2 - 4 A C, without rounding; equations whose determinant is 0 to within about 100 eps^2 of its terms
// describe lines or a point. Values are those of the coefficients as given to a few eps, times the condition
// of the equation in its own scale. Throws Status::factor, conic, not_representable.
ConicAxes conic_axes(const double *coefficients);

// The same without a check of the result; false if there is no such conic, or a coefficient is not finite.
bool find_conic_axes(const double *coefficients, ConicAxes &axes) noexcept;

} // namespace nrb::recognize
