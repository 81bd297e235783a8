// SPDX-License-Identifier: MIT
// Integrals over faces of functions of the point and the first derivatives.
#pragma once

#include "face/face.h"
#include "measure/tensor_integral.h"
#include "pieces/frame.h"

#include <span>

namespace nrb::face {

// A surface with the loops that trim it. Seen from the other side, its integrals change their sign.
struct TrimmedSurface {
    const Spline *surface;
    const TrimMap *trims;
    bool other_side = false;
};

// The sum of the integrals over all surfaces. Each is divided into rectangles and curved trapezoids with
// Gauss rules (D. Gunderman, K. Weiss, J. A. Evans, "Spectral mesh-free quadrature for planar regions bounded
// by rational parametric curves", CAD 130 (2021)). The panels with the largest error are refined first, by a
// higher rule or by halving. Errors are relative to the integral of the first value; those of independent
// values do not count. A tolerance of 0 asks for the best that rounding and the limit of work allow. Throws
// Status::orientation for loops that cross.
measure::Integrals integrate(std::span<const TrimmedSurface> surfaces, const measure::Integrand &integrand,
                             const pieces::Frame &frame, double relative_tolerance);

} // namespace nrb::face
