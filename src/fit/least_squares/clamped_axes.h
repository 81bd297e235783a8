// SPDX-License-Identifier: MIT
// Fits over knots whose ends are not clamped, by way of clamped ones.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// The axes with clamped ends, without control points that have no influence; periodic ones as they are. They have the same
// splines on the domain, but functions that the data determine: of those of the others some hardly reach the domain.
std::vector<KnotVectorPtr> clamped_axes(const std::vector<KnotVectorPtr> &axes);

// A spline over clamped_axes(), over the axes themselves. Control points that have no influence are copies of the next ones
// that have.
SplinePtr over_axes(SplinePtr spline, const std::vector<KnotVectorPtr> &axes);

} // namespace nrb::fit
