// SPDX-License-Identifier: MIT
// Offsets of surfaces.
#pragma once

#include "spline/spline.h"

namespace nrb::fit {

struct OffsetSurface {
    SplinePtr spline;
    double bound; // of the distance from the offset at equal parameters, proven
};

struct OffsetRule {
    double tolerance;
    int64_t most_patches;
    // Patches that may be looked at in all rounds, where one of a surface of higher degree or with weights counts as more than one;
    // null: no limit. What is used is taken away.
    int64_t *left = nullptr;
};

// A biquintic polynomial spline within the tolerance of S + d N, with N the unit normal along S_u x S_v. Its patches have the points
// and the first two derivatives along each axis of the offset at their corners (Hermite), and are cut where offset_bounds() does not
// prove the tolerance; they join with two equal derivatives except along knots where those of the surface, up to the third ones, may
// jump. Where no more patches are allowed, the nearest one that was met, with a bound above the tolerance. A surface that is as near
// itself, since the distance is not above the tolerance, is its own offset. Throws Status::unsupported where the surface has no normal,
// or two along a knot; not_converged if no bound was met. Precondition: a surface of dimension 3, tolerance > 0.
OffsetSurface offset_surface(const SplinePtr &surface, double distance, const OffsetRule &rule);

} // namespace nrb::fit
