// SPDX-License-Identifier: MIT
// Fits that outliers do not pull along.
#pragma once

#include "fit/least_squares/fit_points.h"

namespace nrb::fit {

// Least squares with weights w_i f(r_i / width) in rounds, where r_i = sqrt(w_i) |y_i - s(t_i)| / (scale sqrt(dim)) and the scale
// is the median of sqrt(w_i) |y_i - s(t_i)|, over what it is for normal errors of deviation 1:
// - Huber's min(1, 1 / x) (P. Huber, "Robust estimation of a location parameter", Ann. Math. Statist. 35 (1964)), which has one
//   minimum, width 1.345;
// - Tukey's (1 - x^2)^2 below 1, else 0, from Huber's fit on and with its scale (A. Beaton, J. Tukey, "The fitting of power series ...",
//   Technometrics 16 (1974)), width 4.685.
// Throws what fit_points() does; where Tukey's leaves nothing that determines a control point the result is Huber's fit, and has
// not converged.
FittedPoints robust_fit(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes);

} // namespace nrb::fit
