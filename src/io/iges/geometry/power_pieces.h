// SPDX-License-Identifier: MIT
// Parametric spline curves (entity 112) and surfaces (114): piecewise cubic polynomials in power form.
#pragma once

#include "io/iges/geometry/placement.h"
#include "io/iges/record.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// The spline has the lowest degree that suffices for all pieces, over the given breakpoints. Pieces whose
// ends are at most `tolerance` apart share them, and knots are removed where that changes no more than the
// rounding of the coefficients. Throws Status::syntax, count, knots_decreasing, and what making splines
// throws.
SplinePtr read_spline_pieces(Record &record, const Placement &place, double tolerance);
SplinePtr read_spline_patches(Record &record, const Placement &place, double tolerance);

} // namespace nrb::io::iges
