// SPDX-License-Identifier: MIT
// Fairing: shapes of less energy within a tolerance.
#pragma once

#include "spline/spline.h"

namespace nrb::modify {

struct Faired {
    SplinePtr spline;
    double energy_before;
    double energy_after;
    double bound; // proven, of the distance to the given spline
};

// See nurbs_fair(). With X = w (P - centre) the energy is X^T K X (energy.h). With D the diagonal matrix of 1
// / w^2, the solution of (K + rho D) (X - X_0) = -K X_0 has the least energy among the splines whose control
// points are as near as its own, measured by sum |P_i - P_i0|^2. rho is found by secants in logarithms; the
// bound of deviation() decides whether a solution is within the tolerance. Of the last solution that is too
// far away, as large a part is taken as the tolerance allows; this lowers the energy as well, because the
// energy is convex. Layers that act on derivatives to be kept stay. `keep` is [axes][2] or null. Throws
// Status::degree, not_representable, overflow. Cost: some 8 solutions of a sparse system of the size of the
// net, and as many deviations.
Faired fair(const SplinePtr &spline, int order, const int32_t *keep, double tolerance);

} // namespace nrb::modify
