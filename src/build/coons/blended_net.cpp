// SPDX-License-Identifier: MIT
#include "build/coons/blended_net.h"

#include "base/checked.h"
#include "base/representable.h"
#include "refine/algebra/product.h"

#include <algorithm>

namespace nrb::build {

void clear_margins(const BlendAxis &axis, size_t width, std::vector<double> &function) {
    const auto length = static_cast<std::ptrdiff_t>(axis.margin() * width);
    std::fill_n(function.begin(), length, 0);
    std::fill_n(function.end() - length, length, 0);
}

std::vector<double> net_of_zeros(const std::vector<const BlendAxis *> &axes, int dim) {
    int64_t size = dim + 1;
    for (const BlendAxis *axis : axes) {
        size = checked_product(size, axis->count(), "control points");
    }
    const auto values = static_cast<size_t>(size / (dim + 1) * dim);
    std::vector<double> net;
    net.reserve(values + Spline::padding); // so that the spline does not reallocate them
    net.resize(values);
    return net;
}

namespace {

// The tensor product of value(axis, layer) over the axes, the last one fastest.
template <class Value>
std::vector<double> tensor(const std::vector<const BlendAxis *> &axes, Value &&value) {
    std::vector<double> products{1};
    for (const BlendAxis *axis : axes) {
        std::vector<double> next;
        next.reserve(products.size() * static_cast<size_t>(axis->count()));
        for (const double product : products) {
            for (size_t i = 0; i < static_cast<size_t>(axis->count()); ++i) {
                next.push_back(product * value(*axis, i));
            }
        }
        products = std::move(next);
    }
    return products;
}

std::vector<double> records_of(const std::vector<double> &net, size_t dim,
                               const std::vector<double> &divisors, const std::vector<double> &weights) {
    std::vector<double> records;
    records.reserve(net.size() + weights.size());
    for (size_t i = 0; i < weights.size(); ++i) {
        for (size_t c = 0; c < dim; ++c) {
            records.push_back(divisors[i] * net[i * dim + c]);
        }
        records.push_back(weights[i]);
    }
    return records;
}

} // namespace

SplinePtr blended_spline(const std::vector<const BlendAxis *> &axes, int dim, Form form,
                         std::vector<double> net) {
    require_representable(net, "control points");
    Spline::Axes knots;
    for (const BlendAxis *axis : axes) {
        knots.push_back(axis->axis);
    }
    if (std::ranges::all_of(axes, [](const BlendAxis *axis) { return axis->weights.empty(); })) {
        return make_result(std::move(knots), dim, Form::polynomial, std::move(net));
    }
    std::vector<double> weights =
        tensor(axes, [](const BlendAxis &axis, size_t i) { return axis.weight(i); });
    require_representable(weights, "weights");
    if (form == Form::rational && std::ranges::find(weights, 0) == weights.end()) {
        return make_result(std::move(knots), dim, form, std::move(net), std::move(weights));
    }
    const std::vector<double> divisors =
        tensor(axes, [](const BlendAxis &axis, size_t i) { return axis.divisor(i); });
    return refine::from_records(std::move(knots), dim, form,
                                records_of(net, static_cast<size_t>(dim), divisors, weights));
}

} // namespace nrb::build
