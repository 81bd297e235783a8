// SPDX-License-Identifier: MIT
// Robust fits (M-estimators), on which outliers have little influence.
#pragma once

#include "fit/least_squares/fit_points.h"

namespace nrb::fit {

// Iteratively reweighted least squares with weights w_i f(r_i / width), where
// r_i = sqrt(w_i) |y_i - s(t_i)| / (scale sqrt(dim)). The scale is the median of sqrt(w_i) |y_i - s(t_i)|
// divided by the median for normal errors of standard deviation 1, corrected for the degrees of freedom that
// the fit takes from the data. The weight function f(x) is
// - Huber's min(1, 1 / x) (P. Huber, "Robust estimation of a location parameter", Ann. Math. Statist. 35
//   (1964)), which leads to a single minimum, with width 1.345;
// - Tukey's (1 - x^2)^2 for x < 1, else 0 (A. Beaton, J. Tukey, "The fitting of power series ...",
//   Technometrics 16 (1974)), starting from Huber's fit and with its scale, with width 4.685.
// Throws what fit_points() throws. Where Tukey's weights leave a control point undetermined, the result is
// Huber's fit, and has not converged.
FittedPoints robust_fit(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes);

} // namespace nrb::fit
