// SPDX-License-Identifier: MIT
// The centre, axes and sizes of a conic from its implicit equation.
#pragma once

#include "recognize/conic_type.h"

namespace nrb::recognize {

// An ellipse is given by its centre and semi-axes, with x along the longer one; a hyperbola by its centre and
// its semi-axes along x and across it, with x towards a vertex. For both, x[0] > 0 or x = (0, 1). A parabola
// is given by its vertex, its focal length and 0, with x towards the focus.
struct ConicAxes {
    int32_t type; // conic_ellipse, conic_parabola or conic_hyperbola
    double origin[2];
    double x[2]; // unit vector
    double sizes[2];
};

// The axes of A x^2 + B x y + C y^2 + D x + E y + F = 0, six coefficients in this order. The type follows
// from the sign of B^2 - 4 A C, which is computed exactly. Equations whose determinant is 0 to within about
// 100 eps^2 of its terms describe lines or a point. The values are accurate to a few eps for the coefficients
// as given, times the condition number of the equation in its own scale. Throws Status::factor, conic,
// not_representable.
ConicAxes conic_axes(const double *coefficients);

// The same without checking the result; false if there is no such conic, or a coefficient is not finite.
bool find_conic_axes(const double *coefficients, ConicAxes &axes) noexcept;

} // namespace nrb::recognize
