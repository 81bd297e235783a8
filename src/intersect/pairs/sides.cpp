// SPDX-License-Identifier: MIT
#include "intersect/pairs/sides.h"

#include "closest/locator.h"
#include "eval/curve_point.h"
#include "intersect/pairs/periods.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::intersect {

namespace {

// The foot point of a perpendicular determines the side. An end or a corner of b does not, nor does a foot
// point that is farther than `reach` from the guess.
int side_of(const Spline &b, const double *point, double guess, double reach, double noise) {
    const double start = in_domain(b, guess);
    const closest::Foot foot = closest::locator_of(b).local(point, &start);
    std::array<double, 4> ray{}; // a point and the derivative
    eval::evaluate_points(b, {}, 1, {foot.params.data(), 1, 1, 1, 1}, {ray.data(), 1, 4, 4, 1});
    const double x = point[0] - ray[0], y = point[1] - ray[1];
    const double across = ray[2] * y - ray[3] * x, speed = norm(ray.data() + 2, 2), away = std::hypot(x, y);
    if (distance(eval::curve_point(b, start, false).data(), ray.data(), 2) > reach) {
        return 0;
    }
    const bool perpendicular = std::abs(across) > 0.5 * speed * away;
    return !perpendicular || !(away > 2 * noise) ? 0 : across > 0 ? 1 : -1;
}

} // namespace

int side_along(const Spline &a, const Spline &b, const Way &way, double noise) {
    const Interval domain = a.axis(0).domain();
    const std::vector<double> from = eval::curve_point(a, in_domain(a, way.from_a), false);
    double step = way.first;
    while (step <= way.most) {
        const double t = way.up ? way.from_a + step : way.from_a - step;
        if (!a.axis(0).periodic() && (t < domain.lower || t > domain.upper)) {
            return 0;
        }
        const std::vector<double> point = eval::curve_point(a, in_domain(a, t), false);
        const double reach = way.width + 4 * distance(from.data(), point.data(), 2) + 8 * noise;
        if (const int side = side_of(b, point.data(), way.from_b, reach, noise)) {
            return side;
        }
        step *= 4;
    }
    return 0;
}

} // namespace nrb::intersect
