// SPDX-License-Identifier: MIT
#include "refine/compose/axes_under.h"

#include "base/error.h"
#include "refine/periodic/periods.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

// The range of the Bernstein coefficients of coordinate k of f over all pieces. By the convex hull property
// it contains all values of that coordinate.
Interval hull_of(const std::vector<CurvePiece> &pieces, int k) noexcept {
    Interval hull{pieces.front().coefficients(k).front(), pieces.front().coefficients(k).front()};
    for (const CurvePiece &piece : pieces) {
        const auto [least, greatest] = std::ranges::minmax_element(piece.coefficients(k));
        hull = {std::min(hull.lower, *least), std::max(hull.upper, *greatest)};
    }
    return hull;
}

// A curve that runs over more periods is taken for a mistake, such as an f in degrees on a circle in radians.
constexpr double most_periods = 65536;
// Beyond this distance, neighbouring doubles are a period apart.
constexpr double farthest_period = 0x1p52;

// A periodic axis unrolled over all periods that f visits.
KnotVectorPtr with_periods(const KnotVector &axis, int k, Interval range) {
    const auto [lower, upper] = axis.domain();
    const double first = std::floor((range.lower - lower) / (upper - lower));
    const double end = std::max(std::ceil((range.upper - lower) / (upper - lower)), first + 1);
    const bool far = !(std::max(std::fabs(first), std::fabs(end)) <= farthest_period);
    if (far || end - first > most_periods) {
        fail(Status::outside_domain, "f reaches over [%s, %s] on axis %d, %s the domain [%s, %s] of g",
             Number(range.lower).text, Number(range.upper).text, k,
             far ? "more than 2^52 periods from" : "over more than 65536 periods of", Number(lower).text,
             Number(upper).text);
    }
    return over_periods(axis, static_cast<int64_t>(first), static_cast<int64_t>(end));
}

} // namespace

std::vector<CurvePiece> pieces_of(const Spline &f) {
    std::vector<CurvePiece> pieces;
    for (const int64_t span : f.axis(0).spans().indices()) {
        pieces.emplace_back(f, span);
    }
    return pieces;
}

Spline::Axes axes_under(const Spline &g, const std::vector<CurvePiece> &pieces) {
    Spline::Axes axes = g.knot_vectors();
    for (int k = 0; k < g.axes(); ++k) {
        const auto [lower, upper] = g.axis(k).domain();
        const Interval range = hull_of(pieces, k);
        if (g.axis(k).periodic() && (range.lower < lower || range.upper > upper)) {
            KnotVectorPtr &axis = axes[static_cast<size_t>(k)];
            axis = with_periods(*axis, k, range);
        }
    }
    return axes;
}

} // namespace nrb::refine
