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
    int64_t *left =
        nullptr; // patches that may be looked at in all rounds; null: no limit. What is used is taken away
};

// A bicubic polynomial spline within the tolerance of S + d N, with N the unit normal along S_u x S_v. Its patches have the points
// and derivatives of the offset at their corners (Hermite), and are halved where offset_bounds() does not prove the tolerance; they
// join with equal derivatives except along knots where those of the surface, up to the second ones, may jump. Throws
// Status::unsupported where the surface has no normal, or two along a knot; not_converged with the bound that was met. Precondition:
// a surface of dimension 3, d != 0, tolerance > 0.
OffsetSurface offset_surface(const SplinePtr &surface, double distance, const OffsetRule &rule);

} // namespace nrb::fit
