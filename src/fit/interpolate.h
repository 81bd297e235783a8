// SPDX-License-Identifier: MIT
// Splines through data on a grid.
#pragma once

#include "fit/axis_layers.h"
#include "fit/parameters.h"
#include "spline/spline.h"

namespace nrb::fit {

// The parameters of all axes, one after the other: finite and strictly increasing on each, else
// Status::parameter_not_finite, knots_decreasing.
void check_params(std::span<const double> params, const std::vector<int64_t> &counts);

// Of periodic axes: the last layer repeats the first one, else Status::periodic_points.
void check_closed(const PointGrid &grid);

// The layers of all axes, from arrays of parameters and orders that are one after the other; no orders: values only.
std::vector<AxisLayers> layers_by_axis(const std::vector<int64_t> &counts, std::span<const double> params,
                                       std::span<const int32_t> orders = {});

// The spline of the given degrees through the layers, over interpolation_knots(); `ends` are those of all axes. Mixed
// derivatives may be NaN. The last layer of a periodic axis has to repeat the first one, else Status::periodic_points.
SplinePtr interpolate(const std::vector<int> &degrees, const std::vector<AxisLayers> &layers, PointGrid grid,
                      const std::vector<Ends> &ends);
// The spline through points over given knots, as many control points as data. Throws Status::outside_domain.
SplinePtr interpolate(const Spline::Axes &axes, std::span<const double> params, PointGrid grid);

// Derivatives targets[i] of a curve, [conditions][dim], by rising parameters; those at `directions` are known but for their
// lengths.
struct CurveConditions {
    std::vector<double> params;
    std::vector<int32_t> orders;
    std::vector<int64_t> directions;
    int dim;
    std::vector<double> targets;
};
// The curve over the knots that fulfils the conditions, with tangents of the lengths of least energy. Throws
// Status::outside_domain, and what tangent_lengths() and check_along() do.
SplinePtr interpolate_conditions(CurveConditions given, KnotVectorPtr knots);
// The factors that make derivatives of all targets.
std::vector<double> tangent_lengths(const CurveConditions &given, KnotVectorPtr knots);

} // namespace nrb::fit
