// SPDX-License-Identifier: MIT
// Approximation of offsets of surfaces, with proof.
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
    // The number of patches that may be looked at in all rounds, where one of a surface of higher degree or
    // with weights counts as more than one; null: no limit. Those used are subtracted.
    int64_t *left = nullptr;
};

// A biquintic polynomial spline within the tolerance of S + d N, with the unit normal N along S_u x S_v. Its
// patches are Hermite interpolants: at their corners they have the points and the first two derivatives along
// each axis of the offset. They are cut where offset_bounds() does not prove the tolerance, and join with two
// equal derivatives except along knots where derivatives of the surface up to the third may jump. Where no
// more patches are allowed, the result is the closest spline that was found, with a bound above the
// tolerance. If the distance is not above the tolerance, the surface itself is the result. Throws
// Status::unsupported where the surface has no normal, or two along a knot; not_converged if no bound was
// found. Precondition: a surface of dimension 3, tolerance > 0.
OffsetSurface offset_surface(const SplinePtr &surface, double distance, const OffsetRule &rule);

} // namespace nrb::fit
