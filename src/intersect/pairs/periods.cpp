// SPDX-License-Identifier: MIT
#include "intersect/pairs/periods.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

namespace nrb::intersect {

namespace {

double size_of(const Spline &curve) noexcept {
    double size = 0;
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        for (int c = 0; c < curve.dim(); ++c) {
            const double x = std::abs(curve.coordinate(i, c));
            size = std::isfinite(x) ? std::max(size, x) : size;
        }
    }
    return size;
}

bool are_one(const std::vector<double> &x, const std::vector<double> &y, double size) noexcept {
    return x == y || distance(x.data(), y.data(), static_cast<int>(x.size())) <= 64 * eps * size;
}

} // namespace

bool closes(const Spline &curve) {
    return are_one(eval::end_point(curve, false), eval::end_point(curve, true), size_of(curve.effective()));
}

std::vector<double> jumps_of(const Spline &curve) {
    const KnotVector &axis = curve.axis(0);
    const Interval domain = axis.domain();
    const double size = size_of(curve.effective());
    std::vector<double> jumps;
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (group.multiplicity > axis.degree() && group.knot > domain.lower && group.knot < domain.upper &&
            !are_one(eval::curve_point(curve, group.knot, true), eval::curve_point(curve, group.knot, false),
                     size)) {
            jumps.push_back(group.knot);
        }
    }
    if (axis.periodic() && !closes(curve)) {
        jumps.insert(jumps.begin(), domain.lower);
        jumps.push_back(domain.upper);
    }
    return jumps;
}

} // namespace nrb::intersect
