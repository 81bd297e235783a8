// SPDX-License-Identifier: MIT
// Fits over knots with unclamped ends, by way of clamped ones.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// The axes with clamped ends and without control points that have no influence; periodic axes as they are.
// They have the same splines on the domain, but basis functions that the data determine: of the functions
// over unclamped knots some hardly reach into the domain.
std::vector<KnotVectorPtr> clamped_axes(const std::vector<KnotVectorPtr> &axes);

// Converts a spline over clamped_axes() to the axes themselves. Control points without influence are copies
// of the nearest ones that have some.
SplinePtr over_axes(SplinePtr spline, const std::vector<KnotVectorPtr> &axes);

} // namespace nrb::fit
