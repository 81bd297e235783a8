// SPDX-License-Identifier: MIT
// Coons surfaces: surfaces from their boundary curves and, in Hermite form, the derivatives across them.
#pragma once

#include "build/coons/corner.h"

#include <cstdint>

namespace nrb::build {

// See nurbs_surface_coons(). Throws Status::gap, and what make_blend_axis() and coons_patch() throw.
SplinePtr surface_coons(const PatchCurves &curves, double tolerance);

enum TwistChoice : int32_t {
    twist_compatible = 0, // that of both cross tangents, which must agree to the tolerance
    twist_average,        // the mean of both
    twist_given,
    twist_zero,     // Ferguson's patch
    twist_bilinear, // that of the bilinear patch of the corners
    twist_adini,    // that of the bilinear Coons surface of the boundaries (Adini's twist)
};

// How the twists are chosen: one of the twist_ constants; `given` [4][dim] for twist_given.
struct TwistRule {
    int32_t rule;
    const double *given;
};

struct HermitePatch {
    SplinePtr surface;
    double twist_gap; // largest difference between the twists used and those of the cross tangents
};

// See nurbs_surface_coons_hermite(). Throws Status::gap, tangent, twist, and what make_blend_axis() and
// coons_patch() throw. Precondition: twist_compatible and twist_average need cross tangents, twist_given
// needs `given`.
HermitePatch surface_coons_hermite(const PatchCurves &curves, const TwistRule &twists, double tolerance);

} // namespace nrb::build
