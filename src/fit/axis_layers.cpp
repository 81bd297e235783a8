// SPDX-License-Identifier: MIT
#include "fit/axis_layers.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

void check_increases(const AxisLayers &layers, int64_t i, size_t axis, int64_t first) {
    const double t = layers.param(i), before = layers.param(i - 1);
    const bool again = t == before && layers.order(i) > 0;
    if (!(t > before || again)) {
        const long long at = first + i;
        fail(Status::knots_decreasing, "params[%lld] = %s on axis %zu, expected more than params[%lld] = %s",
             at, Number(t).text, axis, at - 1, Number(before).text);
    }
    if (again && layers.order(i) <= layers.order(i - 1)) {
        const long long at = first + i;
        fail(Status::order,
             "orders[%lld] = %d, expected more than orders[%lld] = %d at the same parameter %s", at,
             layers.order(i), at - 1, layers.order(i - 1), Number(t).text);
    }
}

void check_order(const AxisLayers &layers, int64_t i, int degree, bool periodic, size_t axis, int64_t first) {
    const int order = layers.order(i);
    const long long at = first + i;
    if (order < 0 || order > degree) {
        fail(Status::order, "orders[%lld] = %d, expected 0 to %d, the degree of axis %zu", at, order, degree,
             axis);
    }
    const double t = layers.param(i);
    if (order > 0 && periodic) {
        fail(Status::order, "orders[%lld] = %d, expected 0: axis %zu is periodic", at, order, axis);
    }
    if (order > 0 && t != layers.params.front() && t != layers.params.back()) {
        fail(Status::order, "orders[%lld] = %d at %s, expected 0 but at an end of axis %zu", at, order,
             Number(t).text, axis);
    }
    if (order > 0 && (i == 0 || layers.param(i - 1) != t)) {
        fail(Status::order, "orders[%lld] = %d is the first one at %s, expected 0, a value", at, order,
             Number(t).text);
    }
}

} // namespace

std::span<const double> AxisLayers::params_of_values(std::vector<double> &room) const {
    if (orders.empty()) {
        return params;
    }
    for (int64_t i = 0; i < count(); ++i) {
        if (order(i) == 0) {
            room.push_back(param(i));
        }
    }
    return room;
}

std::array<int, 2> AxisLayers::derivatives() const noexcept {
    std::array<int, 2> result{};
    for (int64_t i = 0; i < count(); ++i) {
        if (order(i) > 0) {
            ++result[param(i) == params.front() ? 0 : 1];
        }
    }
    return result;
}

void check_layers(const AxisLayers &layers, int degree, bool periodic, size_t axis, int64_t first) {
    if (layers.orders.empty() && all_finite(layers.params) &&
        std::ranges::is_sorted(layers.params, std::less_equal<>())) {
        return;
    }
    for (int64_t i = 0; i < layers.count(); ++i) {
        if (!std::isfinite(layers.param(i))) {
            fail(Status::parameter_not_finite, "params[%lld] = %s is not finite",
                 static_cast<long long>(first + i), Number(layers.param(i)).text);
        }
        if (i > 0) {
            check_increases(layers, i, axis, first);
        }
        check_order(layers, i, degree, periodic, axis, first);
    }
}

void AxisConditions::reserve(size_t count) {
    params_.reserve(count);
    orders_.reserve(count);
    sources_.reserve(count);
}

void AxisConditions::add(double param, int order, int64_t source) {
    params_.push_back(param);
    orders_.push_back(order);
    sources_.push_back(source);
}

AxisConditions conditions_of(const AxisLayers &layers, int degree, Ends ends, bool periodic) {
    if (layers.orders.empty() && conditions_at(ends[0], degree) + conditions_at(ends[1], degree) == 0) {
        const size_t closing = periodic ? 1 : 0;
        return AxisConditions({layers.params.first(layers.params.size() - closing), {}});
    }
    AxisConditions all;
    const auto add_layers = [&](int64_t from, int64_t end) {
        for (int64_t i = from; i < end; ++i) {
            all.add(layers.param(i), layers.order(i), i);
        }
    };
    const auto add_natural = [&](double param, End end) {
        for (int order = degree - conditions_at(end, degree); order < degree; ++order) {
            all.add(param, order, -1);
        }
    };
    all.reserve(static_cast<size_t>(layers.count() + 2 * degree));
    const int64_t last = layers.count() - 1 - layers.derivatives()[1]; // of the value at the end
    all.add(layers.param(0), 0, 0);
    add_natural(layers.param(0), ends[0]);
    add_layers(1, last);
    if (!periodic) {
        add_natural(layers.param(last), ends[1]);
        add_layers(last + 1, layers.count());
        all.add(layers.param(last), 0, last);
    }
    return all;
}

} // namespace nrb::fit
