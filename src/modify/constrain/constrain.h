// SPDX-License-Identifier: MIT
// The smallest change of a spline that meets constraints.
#pragma once

#include "modify/constrain/net_state.h"

namespace nrb::modify {

struct Constrained {
    SplinePtr spline;
    std::vector<double> residuals; // one for each condition
    int64_t rank = 0;              // independent equations
    double moved = 0;
    double optimality = 0;
};

// See nurbs_constrain(). In the scaled unknowns x = sqrt(cost) e, where e are the moves of control points and
// the relative changes of weights, the smallest change is the shortest vector.
//
// If the weights stay and all conditions are linear, the equations are sparse linear ones, solved by an
// orthogonal factorisation (MinimumNorm); if all conditions are values, the coordinates share the rows.
// Iterative refinement follows, twice.
//
// Otherwise the solution is found by sequential quadratic programming. With g the residuals of the equations
// and J their Jacobian, x_(k+1) is the shortest x with g(x_k) + J (x - x_k) = 0, plus what the second
// derivatives of the Lagrangian add in the kernel of J where they are positive there. A line search on |x|^2
// / 2 + mu |g|_1 follows (Nocedal & Wright, "Numerical Optimization", 18.3). Without the second derivatives,
// each step would multiply the error by about |multipliers| |g''|; with them the convergence is quadratic.
// They are never formed: a system that contains them takes few conjugate gradient steps, since it contains
// few derivatives of the spline.
//
// Throws Status::influence, contradiction, weight_sign, not_converged, point_not_finite, not_representable,
// overflow. Cost of each step: linear in the number of equations of a curve; an equation of a surface meets
// those in the rows of control points that it acts on.
Constrained constrain(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule,
                      double tolerance);

} // namespace nrb::modify
