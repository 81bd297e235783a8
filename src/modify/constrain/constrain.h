// The smallest change of a spline that meets constraints.
#pragma once

#include "modify/constrain/net_state.h"

namespace nrb {

struct Constrained {
    SplinePtr spline;
    std::vector<double> residuals; // by conditions
    int64_t rank = 0;              // independent equations
    double moved = 0;
    double optimality = 0;
};

// See nurbs_constrain(). In the scaled unknowns x = sqrt(cost) e the change is the vector that is shortest.
//
// With the weights fixed each equation is a row of basis functions at one parameter times a vector: the
// shortest e is in the space that the rows span, for each coordinate, so that few unknowns are left
// (RowSpace); where all are values the rows are shared by the coordinates. Residuals are refined twice.
//
// Otherwise x_(k+1) is the shortest x with g(x_k) + J (x - x_k) = 0, by sequential quadratic programming with
// the objective's own Hessian (1) and a line search on |x|^2 / 2 + mu |g|_1 (Nocedal & Wright, "Numerical
// Optimization", 18.3). It converges the faster the less the constraints are curved: each step multiplies the
// error by about |multipliers| |g''|.
//
// Throws NURBS_ERROR_INFLUENCE, _CONTRADICTION, _WEIGHT_SIGN, _NOT_CONVERGED, _POINT_NOT_FINITE,
// _NOT_REPRESENTABLE, _OVERFLOW. Cost: with m equations of n unknowns n m^2, in each step.
Constrained constrain(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule,
                      double tolerance);

} // namespace nrb
