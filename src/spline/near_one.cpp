// SPDX-License-Identifier: MIT
#include "spline/near_one.h"

#include "base/representable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace nrb::inline spline {

Powers powers_near_one(const Spline &spline, int degree, std::span<const int64_t> places) {
    constexpr int near_one = 64;
    const auto power = [](double size) {
        const int exponent = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
        return std::abs(exponent) <= near_one ? 0 : -exponent;
    };
    double coordinates = 0, weights = 0, shortest = HUGE_VAL;
    for (const int64_t i : places) {
        const double *stored = spline.points().data() + i * spline.stored_width();
        for (int c = 0; c < spline.dim(); ++c) {
            coordinates = std::max(coordinates, std::abs(stored[c]));
        }
        weights = std::max(weights, std::abs(spline.weight(i)));
    }
    for (int k = 0; k < spline.axes(); ++k) {
        const Interval domain = spline.axis(k).domain();
        if (spline.axis(k).degree() >= degree) {
            shortest = std::min(shortest, domain.upper / 2 - domain.lower / 2);
        }
    }
    Powers powers{.coordinates = power(coordinates), .weights = spline.rational() ? power(weights) : 0};
    std::fill_n(powers.knots.begin(), spline.axes(), kept_apart(spline.knot_vectors(), power(shortest)));
    return powers;
}

Powers powers_near_one(const Spline &spline, int degree) {
    std::vector<int64_t> places(static_cast<size_t>(spline.point_count()));
    std::iota(places.begin(), places.end(), int64_t{0});
    return powers_near_one(spline.effective(), degree, places);
}

SplinePtr near_one(const Spline &spline, const Powers &powers) {
    const SplinePtr near = scaled(spline, powers);
    std::vector<double> points(near->points().begin(), near->points().end());
    std::vector<double> weights(near->weights().begin(), near->weights().end());
    for (std::vector<double> *values : {&points, &weights}) {
        for (double &x : *values) {
            x = std::isfinite(x) ? x : 0;
        }
    }
    return std::make_shared<const Spline>(near->knot_vectors(), near->dim(), near->form(), std::move(points),
                                          std::move(weights));
}

SplinePtr scaled_back(const Spline &result, const Spline &near, const Spline &given, const Powers &powers) {
    std::vector<double> points(given.points().begin(), given.points().end());
    const auto width = static_cast<size_t>(given.stored_width()), dim = static_cast<size_t>(given.dim());
    for (size_t i = 0; i < points.size(); ++i) {
        if (result.points()[i] != near.points()[i]) {
            points[i] =
                std::ldexp(result.points()[i], i % width < dim ? -powers.coordinates : -powers.weights);
        }
    }
    require_representable(points, "control points");
    return make_result(given.knot_vectors(), given.dim(), given.form(), std::move(points),
                       std::vector<double>(given.weights().begin(), given.weights().end()));
}

} // namespace nrb::inline spline
