// SPDX-License-Identifier: MIT
// Gathers the control points of a spline layer by layer along an axis, and makes splines of such layers.
#pragma once

#include "base/numbers.h"
#include "spline/axis_view.h"

#include <vector>

namespace nrb::reduce {

// Reorders the records of a net layer by layer: all of layer 0, then all of layer 1, and so on, in the order
// of the other axes.
std::vector<double> by_layers(std::vector<double> records, const AxisView &view);
// The records of a spline in this order: homogeneous points if it is rational.
std::vector<double> layer_records(const Spline &spline, int axis);
// Number of doubles in a layer.
int64_t layer_length(const Spline &spline, int axis);

// Classification of a computed record whose weight may be 0.
enum class Weight { positive, zero, infinite, negative };
// How large a value that should be 0 may be after a few operations of 2 eps each, relative to the values it
// is computed from.
inline constexpr double rounding_of_zero = 32 * eps;
// Weights and coordinates up to this size are rounding errors: eps times the largest values that they were
// computed from.
struct RecordRounding {
    double weight;
    double coordinate;
};
// Sets to 0 what does not exceed the rounding: the weight, and the whole record if it is Weight::zero. A
// record with weight 0 and nonzero coordinates is a point at infinity.
Weight clear_rounding(double *record, int dim, const RecordRounding &rounding) noexcept;

// A layer of a new spline: a layer of the old one, bit for bit, or new records.
struct LayerSource {
    int64_t stored; // -1: none
    const double *records;
};

// The spline with another axis, assembled layer by layer. Throws what make_result() throws. Precondition: new
// records of Form::rational have nonzero weights, or are entirely 0: then they are control points without
// effect, put at the origin.
SplinePtr spline_of_layers(const Spline &old, int axis, KnotVectorPtr knots,
                           std::span<const LayerSource> layers);
// The same by make_result_if_valid(): null if the weights are not allowed.
SplinePtr spline_of_layers_if_valid(const Spline &old, int axis, KnotVectorPtr knots,
                                    std::span<const LayerSource> layers);

} // namespace nrb::reduce
