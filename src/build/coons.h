// Surfaces from their boundaries.
#pragma once

#include "build/corner.h"

#include <cstdint>

namespace nrb {

// See nurbs_surface_coons(). Throws NURBS_ERROR_GAP, and what make_blend_axis() and coons_patch() throw.
SplinePtr surface_coons(const PatchCurves &curves, double tolerance);

// How the twists are chosen: one of the NURBS_TWIST_ constants; `given` [4][dim] for NURBS_TWIST_GIVEN.
struct TwistRule {
    int32_t rule;
    const double *given;
};

struct HermitePatch {
    SplinePtr surface;
    double twist_gap; // largest difference between the twists used and those of the cross tangents
};

// See nurbs_surface_coons_hermite(). Throws NURBS_ERROR_GAP, _TANGENT, _TWIST, and what make_blend_axis() and
// coons_patch() throw. Precondition: the rule suits.
HermitePatch surface_coons_hermite(const PatchCurves &curves, const TwistRule &twists, double tolerance);

} // namespace nrb
