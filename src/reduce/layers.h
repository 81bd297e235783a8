// SPDX-License-Identifier: MIT
// Control points layer by layer along an axis, in and out.
#pragma once

#include "base/numbers.h"
#include "spline/axis_view.h"

#include <vector>

namespace nrb::reduce {

// Records of a net put layer by layer: all of layer 0, then all of layer 1 and so on, in the order of the other axes.
std::vector<double> by_layers(std::vector<double> records, const AxisView &view);
// Those of a spline: homogeneous points when rational.
std::vector<double> layer_records(const Spline &spline, int axis);
// Doubles in a layer.
int64_t layer_length(const Spline &spline, int axis);

// The kind of a computed record whose weight may be 0.
enum class Weight { positive, zero, infinite, negative };
// How large a value that should be 0 may be after a few operations of 2 eps each, as a part of the values
// that it comes from.
inline constexpr double rounding_of_zero = 32 * eps;
// Weights and coordinates of at most this size are rounding: eps times the largest ones that were computed
// with.
struct RecordRounding {
    double weight;
    double coordinate;
};
// Sets what is no more than rounding to 0: the weight, and the whole record if that is Weight::zero. A record
// with weight 0 and coordinates is a point at infinity.
Weight clear_rounding(double *record, int dim, const RecordRounding &rounding) noexcept;

// A layer of a new spline: a layer of the old one, bit for bit, or records of its own.
struct LayerSource {
    int64_t stored; // -1: none
    const double *records;
};

// The spline with another axis, layer by layer. Throws what make_result() throws. Precondition: new records
// of Form::rational have weights other than 0, or are 0: control points that have no effect, put at the
// origin.
SplinePtr spline_of_layers(const Spline &old, int axis, KnotVectorPtr knots,
                           std::span<const LayerSource> layers);
// The same by make_result_if_valid(): null if the weights are not allowed.
SplinePtr spline_of_layers_if_valid(const Spline &old, int axis, KnotVectorPtr knots,
                                    std::span<const LayerSource> layers);

} // namespace nrb::reduce
