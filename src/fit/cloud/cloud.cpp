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

// The points that count, in the coordinates and the order of the caller.
Cloud counted(const ConstRecords &points, const ConstRecords &weights) {
    Cloud cloud{static_cast<int>(points.width),
                0,
                0,
                std::vector<double>(static_cast<size_t>(points.width)),
                {},
                {},
                {}};
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

// Sorted by coordinates, then by weights. Where both agree, exchanging points changes nothing but the index
// that is reported.
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

struct Extent {
    std::vector<double> middle;
    double size = 0; // the largest extent of a coordinate
};

Extent extent_of(const std::vector<double> &points, std::span<const double> more, size_t dim) {
    Extent extent{std::vector<double>(dim)};
    for (size_t c = 0; c < dim; ++c) {
        double lower = HUGE_VAL, upper = -HUGE_VAL;
        for (const std::span<const double> all : {std::span<const double>(points), more}) {
            for (size_t i = c; i < all.size(); i += dim) {
                lower = std::min(lower, all[i]);
                upper = std::max(upper, all[i]);
            }
        }
        extent.middle[c] = lower / 2 + upper / 2;
        extent.size = std::max(extent.size, 2 * (upper / 2 - lower / 2));
    }
    return extent;
}

// The origin for coordinates around `middle`: the middle, rounded to a multiple of a power of two (`grid`)
// that is not below the extent, if it is at least four times as far from 0; otherwise 0. In the first case
// the difference of a coordinate and the origin is a multiple of the unit in the last place of the
// coordinate, and smaller than the coordinate, so that it is exact.
double origin_for(double middle, double extent) noexcept {
    constexpr double far = 4, most = 0x1p53;
    const double grid = std::ldexp(1.0, exponent_above(extent));
    if (!(std::abs(middle) >= far * grid)) {
        return 0;
    }
    const double part = middle / grid;
    return std::abs(part) < most ? std::round(part) * grid
                                 : middle; // that far away, all coordinates are equal
}

// Moves the points to coordinates relative to the origin, in units that none of them exceeds.
void place(Cloud &cloud, std::span<const double> start) {
    const auto dim = static_cast<size_t>(cloud.dim);
    const Extent extent = extent_of(cloud.points, start, dim);
    for (size_t c = 0; c < dim; ++c) {
        cloud.origin[c] = origin_for(extent.middle[c], extent.size);
    }
    double largest = 0;
    for (const std::span<const double> all : {std::span<const double>(cloud.points), start}) {
        for (size_t i = 0; i < all.size(); ++i) {
            largest = std::max(largest, std::abs(all[i] - cloud.origin[i % dim]));
        }
    }
    cloud.exponent = exponent_above(largest);
    for (size_t i = 0; i < cloud.points.size(); ++i) {
        cloud.points[i] = cloud.own(cloud.points[i], i % dim) + 0.0; // no -0, which compares equal to 0
    }
}

} // namespace

Cloud Cloud::part(const std::vector<int64_t> &which) const {
    Cloud result{dim, exponent, weight_exponent, origin, {}, {}, {}};
    result.points.reserve(which.size() * static_cast<size_t>(dim));
    for (const int64_t i : which) {
        result.points.insert(result.points.end(), point(i), point(i) + dim);
        result.weights.push_back(weights[static_cast<size_t>(i)]);
        result.indices.push_back(indices[static_cast<size_t>(i)]);
    }
    return result;
}

bool Cloud::moved() const noexcept {
    return std::ranges::any_of(origin, [](double x) { return x != 0; });
}

double Cloud::weight() const noexcept {
    return std::accumulate(weights.begin(), weights.end(), DoubleDouble{},
                           [](const DoubleDouble &sum, double w) { return sum + DoubleDouble(w); })
        .high;
}

Cloud cloud_of(const ConstRecords &points, const ConstRecords &weights, std::span<const double> start) {
    Cloud cloud = counted(points, weights);
    place(cloud, start);
    cloud.weight_exponent = exponent_above(largest_magnitude(cloud.weights));
    for (double &weight : cloud.weights) {
        weight = std::ldexp(weight, -cloud.weight_exponent);
    }
    count_work(64 * cloud.size());
    return cloud.part(order_of(cloud));
}

} // namespace nrb::fit
