// SPDX-License-Identifier: MIT
#include "fit/interpolation_knots.h"

#include "base/error.h"
#include "basis/generators.h"

#include <algorithm>
#include <vector>

namespace nrb::fit {

namespace {

void check_ends(int degree, Ends ends, bool periodic, int axis) {
    for (size_t e = 0; e < ends.size(); ++e) {
        if (periodic && ends[e] != End::not_a_knot) {
            fail(Status::rule, "ends[%d][%zu] = %d, expected 0 on a periodic axis", axis, e,
                 static_cast<int>(ends[e]));
        }
        if ((ends[e] == End::averaged) != (ends[0] == End::averaged)) {
            fail(Status::rule, "ends[%d]: only one of them is NURBS_ENDS_FREE, which is for both", axis);
        }
        if (ends[e] == End::natural && degree % 2 == 0) {
            fail(Status::degree, "degrees[%d] = %d, expected an odd degree with natural ends", axis, degree);
        }
    }
}

void check_derivatives(int degree, Ends ends, std::array<int, 2> derivatives, int axis) {
    for (size_t e = 0; e < ends.size(); ++e) {
        if (derivatives[e] > 0 && ends[e] != End::not_a_knot) {
            fail(Status::rule, "ends[%d][%zu] = %d, expected 0 where derivatives are given", axis, e,
                 static_cast<int>(ends[e]));
        }
        if (derivatives[e] > degree / 2) {
            fail(Status::order,
                 "orders: %d derivatives at the %s of axis %d, expected at most %d, half the degree",
                 derivatives[e], e == 0 ? "start" : "end", axis, degree / 2);
        }
    }
}

void check_count(size_t count, int64_t least, int axis) {
    if (static_cast<int64_t>(count) < least) {
        fail(Status::too_few_points, "counts[%d] = %zu, expected at least %lld for the degree and the ends",
             axis, count, static_cast<long long>(least));
    }
}

std::vector<double> middles_of(std::span<const double> params) {
    std::vector<double> middles(params.size() - 1);
    for (size_t i = 0; i < middles.size(); ++i) {
        middles[i] = params[i] + (params[i + 1] - params[i]) / 2;
    }
    return middles;
}

std::vector<double> open_knots(int degree, std::span<const double> params, Ends ends,
                               std::array<int, 2> derivatives, int axis) {
    const auto skipped = [&](size_t e) { return ends[e] == End::natural ? 0 : degree / 2 - derivatives[e]; };
    const int start = skipped(0), end = skipped(1);
    check_count(params.size(), std::max<int64_t>(2, start + end + (degree % 2 == 0 ? 1 : 2)), axis);
    const std::vector<double> middles = degree % 2 == 0 ? middles_of(params) : std::vector<double>();
    const std::span<const double> places =
        degree % 2 == 0 ? std::span(middles) : params.subspan(1, params.size() - 2);
    const size_t clamped = static_cast<size_t>(degree) + 1;
    std::vector<double> knots;
    knots.reserve(places.size() + 2 * clamped);
    knots.insert(knots.end(), clamped, params.front());
    knots.insert(knots.end(), places.begin() + start, places.end() - end);
    knots.insert(knots.end(), clamped, params.back());
    return knots;
}

std::vector<double> averaged(int degree, std::span<const double> params, int axis) {
    check_count(params.size(), std::max(degree + 1, 2), axis);
    std::vector<double> knots(params.size() + static_cast<size_t>(degree) + 1);
    averaged_knots(degree, params, knots);
    return knots;
}

// For even degrees the knots lie midway between parameters, beginning half of the last step before the first
// parameter.
std::vector<double> closed_knots(int degree, std::span<const double> params, int axis) {
    check_count(params.size(), 2, axis);
    std::vector<double> breaks(params.begin(), params.end());
    if (degree % 2 == 0) {
        const double half = (params.back() - params[params.size() - 2]) / 2;
        const double period = params.back() - params.front();
        breaks = middles_of(params);
        breaks.insert(breaks.begin(), params.front() - half);
        breaks.back() = breaks.front() + period;
    }
    const size_t count = breaks.size() - 1 + static_cast<size_t>(degree);
    std::vector<double> knots(count + static_cast<size_t>(degree) + 1);
    periodic_knots(degree, breaks, nullptr, knots);
    return knots;
}

} // namespace

KnotVectorPtr interpolation_knots(int degree, std::span<const double> params, Ends ends, bool periodic,
                                  int axis, std::array<int, 2> derivatives) {
    check_degree(degree, axis);
    check_ends(degree, ends, periodic, axis);
    check_derivatives(degree, ends, derivatives, axis);
    std::vector<double> knots = periodic ? closed_knots(degree, params, axis)
                                : ends[0] == End::averaged
                                    ? averaged(degree, params, axis)
                                    : open_knots(degree, params, ends, derivatives, axis);
    return make_knot_vector(degree, std::move(knots), periodic, axis);
}

} // namespace nrb::fit
