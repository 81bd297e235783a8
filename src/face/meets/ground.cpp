// SPDX-License-Identifier: MIT
#include "face/meets/ground.h"

#include "base/error.h"
#include "base/numbers.h"
#include "eval/evaluate.h"
#include "face/face_box.h"
#include "refine/parts/continuation.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::face {

namespace {

// A surface is continued by at most this share of the span at its end: so little beyond it, the polynomial of
// the span is hardly larger.
constexpr double most_of_span = 1.0 / 8;
// A span that is cut keeps at least this share of its length.
constexpr double least_of_span = 1.0 / 8;

double last_span(const KnotVector &axis, bool upper) {
    const std::span<const double> breaks = axis.spans().breaks();
    const size_t n = breaks.size();
    return upper ? breaks[n - 1] - breaks[n - 2] : breaks[1] - breaks[0];
}

SplinePtr continued(const SplinePtr &surface, int axis, bool upper, double amount) {
    const double most = most_of_span * last_span(surface->axis(axis), upper);
    try {
        return refine::extend(surface, axis, upper, std::min(amount, most), surface->axis(axis).degree());
    } catch (const Error &) { // weights would not stay positive, or the new end is not representable
        return surface;
    }
}

// Where to cut an axis. The cut is farther out if it would leave a sliver of a span, beyond which its
// polynomial says nothing.
double cut_at(const KnotVector &axis, double at, bool upper) {
    const std::span<const double> breaks = axis.spans().breaks();
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
    const double low = *(above - 1), high = *above, least = least_of_span * (high - low);
    return upper ? std::max(at, low + least) : std::min(at, high - least);
}

// Bounds for one axis: the distance of control points from a centre, the magnitudes of the derivatives of
// homogeneous points and of weights, and the least weight.
struct Speeds {
    double reach = 0, along = 0, weights = 0, least = infinity;
};

// A bound on the difference of two products that were rounded twice.
double most_apart(double x, double y) noexcept {
    return std::abs(x - y) + 2 * eps * (std::abs(x) + std::abs(y));
}

} // namespace

SplinePtr ground_of(const Face &face, bool beyond, double margin) {
    const std::array<Interval, 2> rectangle = smallest_rectangle(face);
    SplinePtr surface = face.surface();
    for (const int k : {0, 1}) {
        if (face.covering().closed(k)) {
            continue;
        }
        const auto &[lower, upper] = rectangle[static_cast<size_t>(k)];
        const Interval domain = surface->axis(k).domain();
        const double around = margin * (upper - lower);
        const double from = cut_at(surface->axis(k), std::max(lower - around, domain.lower), false),
                     to = cut_at(surface->axis(k), std::min(upper + around, domain.upper), true);
        if ((from > domain.lower || to < domain.upper) && from < to) {
            surface = refine::restrict_axis(surface, k, from, to);
        }
        if (beyond && lower - around < domain.lower && !face.covering().collapsed(k, 0)) {
            surface = continued(surface, k, false, around);
        }
        if (beyond && upper + around > domain.upper && !face.covering().collapsed(k, 1)) {
            surface = continued(surface, k, true, around);
        }
    }
    return surface;
}

// By (P / w)' = (P' - (P / w) w') / w, where P are homogeneous points relative to a centre, and the convex
// hulls of P', w' and w.
std::array<double, 2> fastest(const Spline &surface) {
    std::array<double, 2> bound{};
    const int64_t columns = surface.count(1);
    const std::array<int64_t, 2> steps{columns, 1};
    const auto at = [&](int64_t i, int c) { return surface.coordinate(i, c) - surface.coordinate(0, c); };
    for (const int k : {0, 1}) {
        const KnotVector &axis = surface.axis(k);
        Speeds speeds;
        for (int64_t i = 0; i < surface.point_count(); ++i) {
            const int64_t place = k == 0 ? i / columns : i % columns,
                          next = i + steps[static_cast<size_t>(k)];
            const double w = surface.rational() ? surface.weight(i) : 1;
            speeds.least = std::min(speeds.least, w);
            double far = 0, along = 0;
            const auto knot = static_cast<size_t>(place) + 1;
            const double width =
                place + 1 < axis.count()
                    ? axis.knots()[knot + static_cast<size_t>(axis.degree())] - axis.knots()[knot]
                    : 0;
            const double w_next = !(width > 0) ? w : surface.rational() ? surface.weight(next) : 1;
            for (int c = 0; c < 3; ++c) {
                far = std::hypot(far, at(i, c));
                along = width > 0 ? std::hypot(along, most_apart(w_next * at(next, c), w * at(i, c))) : along;
            }
            speeds.reach = std::max(speeds.reach, far);
            if (width > 0) {
                speeds.along = std::max(speeds.along, axis.degree() * along / width);
                speeds.weights = std::max(speeds.weights, axis.degree() * std::abs(w_next - w) / width);
            }
        }
        const double speed = (speeds.along + speeds.reach * speeds.weights) / speeds.least;
        bound[static_cast<size_t>(k)] = speed >= 0 ? speed * (1 + 64 * eps) : infinity;
    }
    return bound;
}

Vector3 surface_normal(const Spline &surface, const Point2 &at) {
    std::array<double, 9> jet{}; // the point and both derivatives
    eval::evaluate_points(surface, {}, 1, {at.data(), 1, 2, 2, 1}, {jet.data(), 1, 9, 9, 1});
    const Vector3 u{jet[3], jet[4], jet[5]}, v{jet[6], jet[7], jet[8]};
    return cross(times_power(u, -size_exponent(u)), times_power(v, -size_exponent(v)));
}

} // namespace nrb::face
