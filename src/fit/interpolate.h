// SPDX-License-Identifier: MIT
// Splines through data on a grid.
#pragma once

#include "fit/axis_interpolation.h"
#include "fit/interpolation_knots.h"
#include "fit/parameters.h"
#include "spline/spline.h"

namespace nrb::fit {

// The parameters of all axes, one after the other: finite and strictly increasing on each, else
// Status::parameter_not_finite, knots_decreasing.
void check_params(std::span<const double> params, const std::vector<int64_t> &counts);

// Of periodic axes: the last layer repeats the first one, else Status::periodic_points.
void check_closed(const PointGrid &grid);

// The spline of the given degrees through the points at the parameters, over interpolation_knots(); `ends` are those
// of all axes. The last layer of a periodic axis has to repeat the first one, else Status::periodic_points.
SplinePtr interpolate(const std::vector<int> &degrees, std::span<const double> params, PointGrid grid,
                      const std::vector<Ends> &ends);
// The same over given knots, as many control points as data. Throws Status::outside_domain.
SplinePtr interpolate(const Spline::Axes &axes, std::span<const double> params, PointGrid grid);

// The curve over the knots with derivatives targets[i] of orders[i] at params[i], which do not decrease.
SplinePtr interpolate_conditions(KnotVectorPtr knots, const std::vector<Condition> &conditions, int dim,
                                 std::vector<double> targets);

// The largest distance of the points from the spline at their parameters.
double largest_miss(const Spline &spline, std::span<const double> params, const PointGrid &grid);

} // namespace nrb::fit
