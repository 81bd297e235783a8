// SPDX-License-Identifier: MIT
#include "reduce/layers.h"

#include "base/checked.h"
#include "base/finite.h"
#include "base/watch.h"
#include "refine/forms/homogeneous.h"
#include "refine/knots/axis_table.h"

#include <algorithm>

namespace nrb::reduce {

namespace {

// Writes one block of a new layer of Form::rational.
void put_records(const double *records, int64_t count, int dim, double *points, double *weights) {
    for (int64_t i = 0; i < count; ++i, records += dim + 1, points += dim) {
        weights[i] = records[dim];
        std::transform(records, records + dim, points,
                       [w = records[dim]](double x) { return w == 0 ? 0 : x / w; });
    }
}

Net net_of_layers(const Spline &old, int axis, std::span<const LayerSource> layers) {
    const AxisView points = axis_view(old, axis, old.stored_width());
    const AxisView weights = axis_view(old, axis, 1);
    const bool rational = old.form() == Form::rational;
    const int64_t count = std::ssize(layers), record = weights.inner * old.width();
    Net net;
    grow_watched(net.points, static_cast<size_t>(points.outer * count * points.inner));
    grow_watched(net.weights, rational ? static_cast<size_t>(weights.outer * count * weights.inner) : 0);
    for (int64_t l = 0; l < count; ++l) {
        const auto [stored, records] = layers[static_cast<size_t>(l)];
        count_work(points.outer * points.inner);
        for (int64_t o = 0; o < points.outer; ++o) {
            const int64_t from = o * points.count + stored, to = o * count + l;
            double *point = net.points.data() + to * points.inner;
            double *weight = rational ? net.weights.data() + to * weights.inner : nullptr;
            if (stored < 0 && rational) {
                put_records(records + o * record, weights.inner, old.dim(), point, weight);
            } else if (stored < 0) {
                std::copy_n(records + o * record, record, point);
            } else {
                std::copy_n(old.points().data() + from * points.inner, points.inner, point);
                std::copy_n(old.weights().data() + (rational ? from * weights.inner : 0),
                            rational ? weights.inner : 0, weight);
            }
        }
    }
    return net;
}

} // namespace

Weight clear_rounding(double *record, int dim, const RecordRounding &rounding) noexcept {
    double &weight = record[dim];
    if (std::abs(weight) > rounding.weight) {
        return weight > 0 ? Weight::positive : Weight::negative;
    }
    weight = 0;
    if (largest_magnitude({record, static_cast<size_t>(dim)}) > rounding.coordinate) {
        return Weight::infinite;
    }
    std::fill_n(record, dim, 0.0);
    return Weight::zero;
}

int64_t layer_length(const Spline &spline, int axis) {
    const AxisView view = axis_view(spline, axis, spline.width());
    return checked_product(view.outer, view.inner, "layer");
}

std::vector<double> by_layers(std::vector<double> records, const AxisView &view) {
    if (view.outer == 1) {
        return records;
    }
    std::vector<double> layers;
    layers.reserve(records.size());
    for (int64_t l = 0; l < view.count; ++l) {
        count_work(view.outer * view.inner);
        for (int64_t o = 0; o < view.outer; ++o) {
            const auto from = records.begin() + (o * view.count + l) * view.inner;
            layers.insert(layers.end(), from, from + view.inner);
        }
    }
    return layers;
}

std::vector<double> layer_records(const Spline &spline, int axis) {
    return by_layers(spline.rational() ? refine::homogeneous_points(spline) : copied_watched(spline.points()),
                     axis_view(spline, axis, spline.width()));
}

SplinePtr spline_of_layers(const Spline &old, int axis, KnotVectorPtr knots,
                           std::span<const LayerSource> layers) {
    Net net = net_of_layers(old, axis, layers);
    return make_result(refine::with_axis(old, axis, std::move(knots)), old.dim(), old.form(),
                       std::move(net.points), std::move(net.weights));
}

SplinePtr spline_of_layers_if_valid(const Spline &old, int axis, KnotVectorPtr knots,
                                    std::span<const LayerSource> layers) {
    Net net = net_of_layers(old, axis, layers);
    return make_result_if_valid(refine::with_axis(old, axis, std::move(knots)), old.dim(), old.form(),
                                std::move(net.points), std::move(net.weights));
}

} // namespace nrb::reduce
