// SPDX-License-Identifier: MIT
#include "face/made/speeds.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

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
            for (int c = 0; c < surface.dim(); ++c) {
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

} // namespace nrb::face
