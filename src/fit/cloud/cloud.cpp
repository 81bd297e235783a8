// SPDX-License-Identifier: MIT
#include "fit/cloud/cloud.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/watch.h"
#include "fit/least_squares/fit_points.h"
#include "fit/statistics/gather.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::fit {

namespace {

void add_point(const ConstRecords &points, int64_t i, std::vector<double> &to) {
    for (int64_t c = 0; c < points.width; ++c) {
        const double x = points(i, c);
        if (!std::isfinite(x)) {
            fail(Status::point_not_finite, "points[%lld][%lld] = %s is not finite", static_cast<long long>(i),
                 static_cast<long long>(c), Number(x).text);
        }
        to.push_back(x);
    }
}

// As they were given.
Cloud counted(const ConstRecords &points, const ConstRecords &weights) {
    Cloud cloud{static_cast<int>(points.width), 0, 0, {}, {}, {}};
    Steps steps(points.count);
    for (int64_t i = 0; i < points.count; ++i, steps.next(8 * points.width)) {
        const double weight = checked_weight(weights, i);
        if (weight > 0) {
            add_point(points, i, cloud.points);
            cloud.weights.push_back(weight);
            cloud.indices.push_back(i);
        }
    }
    if (cloud.size() == 0) {
        fail(Status::count, "n = %lld: no point counts, expected at least 1 of a weight above 0",
             static_cast<long long>(points.count));
    }
    return cloud;
}

// By coordinates, then weights: where these agree, exchanging points changes nothing but the index that is told.
std::vector<int64_t> order_of(const Cloud &cloud) {
    std::vector<int64_t> order(cloud.weights.size());
    std::iota(order.begin(), order.end(), int64_t{0});
    std::ranges::sort(order, [&](int64_t i, int64_t j) {
        const double *a = cloud.point(i), *b = cloud.point(j);
        const auto [x, y] = std::mismatch(a, a + cloud.dim, b);
        if (x != a + cloud.dim) {
            return *x < *y;
        }
        const double u = cloud.weights[static_cast<size_t>(i)], v = cloud.weights[static_cast<size_t>(j)];
        return u != v ? u < v : i < j;
    });
    return order;
}

Cloud permuted(const Cloud &cloud, const std::vector<int64_t> &order) {
    Cloud result{cloud.dim, cloud.exponent, cloud.weight_exponent, {}, {}, {}};
    result.points.reserve(cloud.points.size());
    for (const int64_t i : order) {
        result.points.insert(result.points.end(), cloud.point(i), cloud.point(i) + cloud.dim);
        result.weights.push_back(cloud.weights[static_cast<size_t>(i)]);
        result.indices.push_back(cloud.indices[static_cast<size_t>(i)]);
    }
    return result;
}

void scale(std::vector<double> &values, int exponent) noexcept {
    for (double &x : values) {
        x = std::ldexp(x, -exponent) + 0.0; // no -0, which compares as 0
    }
}

} // namespace

double Cloud::weight() const noexcept {
    return std::accumulate(weights.begin(), weights.end(), DoubleDouble{},
                           [](const DoubleDouble &sum, double w) { return sum + DoubleDouble(w); })
        .high;
}

Cloud cloud_of(const ConstRecords &points, const ConstRecords &weights, double least) {
    Cloud cloud = counted(points, weights);
    cloud.exponent = exponent_above(std::max(largest_magnitude(cloud.points), least));
    cloud.weight_exponent = exponent_above(largest_magnitude(cloud.weights));
    scale(cloud.points, cloud.exponent);
    scale(cloud.weights, cloud.weight_exponent);
    count_work(64 * cloud.size());
    return permuted(cloud, order_of(cloud));
}

} // namespace nrb::fit
