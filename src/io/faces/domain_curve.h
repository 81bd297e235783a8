// SPDX-License-Identifier: MIT
// Curves in the domain of a surface as files state them, in the parameters of the surface's spline.
#pragma once

#include "model/shapes/surface_shape.h"

#include <vector>

namespace nrb::io {

// `spline` is that of model::surface_spline(). Around axes the two have other parameters: straight lines along an axis stay
// straight, other curves are fitted, to a part of the domain that is near to rounding. Throws
// Status::not_converged, and outside_domain for curves that are far outside.
SplinePtr in_spline_parameters(const model::SurfaceShape &shape, const Spline &spline,
                               const SplinePtr &curve);

// The curve with control points at the ends of the domain where they are as near to them as decimals of files are: else a loop
// around a closed surface would overlap itself, or lack a sliver.
SplinePtr snapped_to_ends(const SplinePtr &curve, const Spline &surface);

// The range of a surface; where it has no ends, as much of it as contains the curves, and a little more.
model::Rectangle range_under(const model::SurfaceShape &shape, const std::vector<SplinePtr> &curves);

} // namespace nrb::io
