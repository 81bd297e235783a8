// SPDX-License-Identifier: MIT
#include "intersect/pairs/periods.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "eval/frames/magnitude.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

bool are_one(const std::vector<double> &x, const std::vector<double> &y, double size) noexcept {
    return are_one_point(x.data(), y.data(), static_cast<int>(x.size()), size);
}

} // namespace

bool are_one_point(const double *x, const double *y, int dim, double size) noexcept {
    return std::equal(x, x + dim, y) || distance(x, y, dim) <= 64 * eps * size;
}

bool closes(const Spline &curve) {
    return are_one(eval::end_point(curve, false), eval::end_point(curve, true), eval::active_size(curve));
}

std::vector<double> jumps_of(const Spline &curve) {
    const KnotVector &axis = curve.axis(0);
    const Interval domain = axis.domain();
    const double size = eval::active_size(curve);
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
