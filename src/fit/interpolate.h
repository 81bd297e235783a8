// SPDX-License-Identifier: MIT
// Tensor-product splines that interpolate data on a grid.
#pragma once

#include "fit/axis_layers.h"
#include "fit/parameters.h"
#include "spline/spline.h"

namespace nrb::fit {

// Checks the parameters of all axes, which are listed one axis after the other: they have to be finite and to
// increase strictly on each axis, else Status::parameter_not_finite or knots_decreasing is thrown.
void check_params(std::span<const double> params, const std::vector<int64_t> &counts);

// On a periodic axis the last layer has to repeat the first one, else Status::periodic_points is thrown.
void check_closed(const PointGrid &grid);

// The layers of each axis, from arrays that list the parameters and orders of one axis after the other;
// without orders, values only.
std::vector<AxisLayers> layers_by_axis(const std::vector<int64_t> &counts, std::span<const double> params,
                                       std::span<const int32_t> orders = {});

// The spline of the given degrees through the layers, over interpolation_knots(); ends[k] belongs to axis k.
// Mixed derivatives may be NaN, and are then estimated (mixed_derivatives.h). On a periodic axis the last
// layer has to repeat the first one, else Status::periodic_points is thrown.
SplinePtr interpolate(const std::vector<int> &degrees, const std::vector<AxisLayers> &layers, PointGrid grid,
                      const std::vector<Ends> &ends);
// The spline over given knots through as many data as it has control points. Throws Status::outside_domain.
SplinePtr interpolate(const Spline::Axes &axes, std::span<const double> params, PointGrid grid);

// Conditions on a curve: its derivative of order orders[i] at params[i] is targets[i], [conditions][dim]; the
// parameters rise. Of the derivatives listed in `directions` only the direction is known, not the length.
struct CurveConditions {
    std::vector<double> params;
    std::vector<int32_t> orders;
    std::vector<int64_t> directions;
    int dim;
    std::vector<double> targets;
};
// The curve over the knots that meets the conditions; tangents of unknown length get the lengths of least
// energy. Throws Status::outside_domain, and what tangent_lengths() and check_along() throw.
SplinePtr interpolate_conditions(CurveConditions given, KnotVectorPtr knots);
// The factors by which the targets have to be multiplied to give them the lengths of least energy.
std::vector<double> tangent_lengths(const CurveConditions &given, KnotVectorPtr knots);

} // namespace nrb::fit
