// SPDX-License-Identifier: MIT
// Standard errors of a fit, and the criteria for the factor of its penalty.
#pragma once

#include "eval/parameters.h"
#include "fit/least_squares/smoothing.h"

#include <vector>

namespace nrb::fit {

// sqrt(b^T (G + lambda P)^(-1) b) with the vector b of basis functions at each of the parameters: the
// standard error of a coordinate of the fit, for data of standard deviation 1 at weight 1 (G. Wahba,
// "Bayesian confidence intervals for the cross-validated smoothing spline", J. R. Statist. Soc. B 45 (1983)).
// NaN where a rule makes a parameter NaN. Throws what fit() throws. Precondition: the parameters are checked.
void standard_errors(const Statistics &statistics, const std::vector<KnotVectorPtr> &wanted,
                     int penalty_order, double lambda, const ConstRecords &params,
                     const eval::AxisRules &rules, const Records &errors);

// The criteria for one factor of the penalty after the other.
std::vector<Criteria> criteria(const Statistics &statistics, const std::vector<KnotVectorPtr> &wanted,
                               int penalty_order, const std::vector<double> &lambdas);

} // namespace nrb::fit
