// SPDX-License-Identifier: MIT
// The smallest change of a spline that meets constraints.
#pragma once

#include "modify/constrain/net_state.h"

namespace nrb::modify {

struct Constrained {
    SplinePtr spline;
    std::vector<double> residuals; // by conditions
    int64_t rank = 0;              // independent equations
    double moved = 0;
    double optimality = 0;
};

// See nurbs_constrain(). In the scaled unknowns x = sqrt(cost) e the change is the vector that is shortest.
//
// With the weights fixed the equations are linear and sparse (MinimumNorm); where all are values the rows are
// shared by the coordinates. Residuals are refined twice.
//
// Otherwise x_(k+1) is the shortest x with g(x_k) + J (x - x_k) = 0, plus what the second derivatives of the
// Lagrangian add in the kernel of J where they are positive there, by sequential quadratic programming with a
// line search on |x|^2 / 2 + mu |g|_1 (Nocedal & Wright, "Numerical Optimization", 18.3). Without them each
// step would multiply the error by about |multipliers| |g''|; with them the convergence is quadratic. They
// are never formed: a system with them takes few conjugate gradients, since few derivatives of the spline are
// in it.
//
// Throws Status::influence, contradiction, weight_sign, not_converged, point_not_finite,
// not_representable, overflow. Cost: in each step linear in the number of equations of a curve; of a surface
// each meets those in the rows of control points that it acts on.
Constrained constrain(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule,
                      double tolerance);

} // namespace nrb::modify
