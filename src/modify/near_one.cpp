#include "modify/near_one.h"

#include "base/representable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace nrb {

namespace {

// An exponent by which no knot overflows and no two become one: nearest to the one that is wanted.
int kept_apart(const Spline &spline, int exponent) {
    constexpr int most = 1000;
    double largest = 0, least = HUGE_VAL;
    for (int k = 0; k < spline.axes(); ++k) {
        const std::span<const double> knots = spline.axis(k).knots();
        largest = std::max({largest, std::abs(knots.front()), std::abs(knots.back())});
        for (size_t i = 1; i < knots.size(); ++i) {
            const double apart = knots[i] - knots[i - 1];
            least = apart > 0 ? std::min(least, apart) : least;
        }
    }
    const int raised = std::max(exponent, std::min(-most - std::ilogb(least), 0));
    return std::min(raised, std::max(most - std::ilogb(largest), 0));
}

} // namespace

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
    std::fill_n(powers.knots.begin(), spline.axes(), kept_apart(spline, power(shortest)));
    return powers;
}

Powers powers_near_one(const Spline &spline, int degree) {
    std::vector<int64_t> places(static_cast<size_t>(spline.point_count()));
    std::iota(places.begin(), places.end(), int64_t{0});
    return powers_near_one(spline.effective(), degree, places);
}

SplinePtr scaled_back(const Spline &result, const Spline &given, const Powers &powers) {
    const SplinePtr points = scaled(result, {.coordinates = -powers.coordinates, .weights = -powers.weights});
    require_representable(points->points(), "control points");
    return make_result(given.knot_vectors(), given.dim(), given.form(),
                       std::vector<double>(points->points().begin(), points->points().end()),
                       std::vector<double>(given.weights().begin(), given.weights().end()));
}

} // namespace nrb
