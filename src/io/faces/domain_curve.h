// SPDX-License-Identifier: MIT
// Converts curves in the domain of a surface, as files state them, to the parameters of the spline of the
// surface.
#pragma once

#include "model/shapes/surface_shape.h"

#include <vector>

namespace nrb::io {

// Converts a curve from the parameters of `shape` to those of `spline`, which model::surface_spline() made
// from the shape. Around an axis the two parametrizations differ: there a straight line along one of the axes
// of the domain stays straight, and any other curve is fitted, with a tolerance that is a share of the domain
// near rounding. Throws Status::not_converged, and outside_domain for a curve that is far outside of the
// domain.
SplinePtr in_spline_parameters(const model::SurfaceShape &shape, const Spline &spline,
                               const SplinePtr &curve);

// Moves coordinates of control points to an end of the domain if they are as near to it as the decimals in
// files can tell. Otherwise a loop around a closed surface would overlap itself, or lack a sliver. A curve
// with homogeneous points stays as it is.
SplinePtr snapped_to_ends(const SplinePtr &curve, const Spline &surface);

// The natural range of a surface. Where it is unbounded, as much of it as contains the control points of the
// curves, with a small margin.
model::Rectangle range_under(const model::SurfaceShape &shape, const std::vector<SplinePtr> &curves);

} // namespace nrb::io
