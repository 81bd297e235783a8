// SPDX-License-Identifier: MIT
// Integrals over faces of functions of the place and the first derivatives.
#pragma once

#include "face/face.h"
#include "measure/tensor_integral.h"
#include "pieces/frame.h"

#include <span>

namespace nrb::face {

// A surface that is trimmed as a face is. Seen from the other side its integrals change their sign.
struct TrimmedSurface {
    const Spline *surface;
    const TrimMap *trims;
    bool other_side = false;
};

// The sum over all of them, by Gauss rules on the rectangles and curved trapezoids of which they consist (D. Gunderman, K. Weiss,
// J. A. Evans, "Spectral mesh-free quadrature for planar regions bounded by rational parametric curves", CAD 130 (2021)), those
// with the largest error first, by higher rules or halved. Errors of values are relative to the integral of the first one,
// those of independent ones are left to themselves. A tolerance of 0 asks for the best that rounding and a limit of work allow.
// Throws Status::orientation for loops that cross.
measure::Integrals integrate(std::span<const TrimmedSurface> surfaces, const measure::Integrand &integrand,
                             const pieces::Frame &frame, double relative_tolerance);

} // namespace nrb::face
