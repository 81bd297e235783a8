// SPDX-License-Identifier: MIT
#include "mesh/volume/sides.h"

#include "base/error.h"
#include "base/numbers.h"
#include "eval/curve_point.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/iso.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

void check_cell_degrees(const Spline &spline) {
    for (int k = 0; k < spline.axes(); ++k) {
        if (spline.axis(k).degree() == 0) {
            fail(Status::degree, "axis %d has degree 0, cells need 1 or more: raise it", k);
        }
    }
}

std::vector<bool> jumps_of(const KnotVector &axis) {
    const std::span<const int64_t> spans = axis.spans().indices();
    std::vector<bool> jumps;
    for (size_t e = 0; e + 1 < spans.size(); ++e) {
        jumps.push_back(spans[e + 1] - spans[e] > axis.degree());
    }
    return jumps;
}

namespace {

SplinePtr end_of_axis(const Spline &spline, int k, bool upper) {
    const Interval domain = spline.axis(k).domain();
    eval::AxisRule rule;
    rule.left = upper;
    return refine::iso(spline, k, upper ? domain.upper : domain.lower, rule);
}

bool jumps_at_seam(const KnotVector &axis) {
    const double end = axis.domain().upper;
    return std::ranges::count(axis.knots(), end) > axis.degree();
}

// Whether all layers along an axis are the same.
bool is_constant(const std::vector<double> &points, const Spline &side, int k) {
    const AxisView view = axis_view(side, k, side.dim());
    for (int64_t o = 0; o < view.outer; ++o) {
        const double *first = points.data() + o * view.count * view.inner;
        for (int64_t i = 1; i < view.count; ++i) {
            if (!std::equal(first, first + view.inner, first + i * view.inner)) {
                return false;
            }
        }
    }
    return true;
}

// Whether the weights are products of a factor for each layer along an axis and a factor for the other
// indices, up to rounding. Then the former do not count where the layers have the same points.
bool are_in_proportion(const Spline &side, int k) {
    const AxisView view = axis_view(side, k, 1);
    const auto weight = [&](int64_t o, int64_t i, int64_t x) {
        return side.weight((o * view.count + i) * view.inner + x);
    };
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 1; i < view.count; ++i) {
            for (int64_t x = 0; x < view.inner; ++x) {
                const double a = weight(o, i, x) * weight(0, 0, 0), b = weight(o, 0, x) * weight(0, i, 0);
                if (!(std::abs(a - b) <= 16 * eps * std::abs(b))) {
                    return false;
                }
            }
        }
    }
    return true;
}

// Whether a side is the same all along an axis. For a single point this holds for any weights.
bool is_along(const Spline &side, const std::vector<double> &points, int k) {
    if (!is_constant(points, side, k)) {
        return false;
    }
    for (int l = 0; l < side.axes(); ++l) {
        if (l != k && !is_constant(points, side, l)) {
            return are_in_proportion(side, k);
        }
    }
    return true;
}

} // namespace

bool closes(const Spline &spline, int k) {
    const KnotVector &axis = spline.axis(k);
    if (axis.periodic()) {
        return !jumps_at_seam(axis);
    }
    if (spline.axes() == 1) {
        return axis.clamped_start() && axis.clamped_end() &&
               spline.weight(0) == spline.weight(spline.count(0) - 1) &&
               eval::end_point(spline, false) == eval::end_point(spline, true);
    }
    const SplinePtr lower = end_of_axis(spline, k, false), upper = end_of_axis(spline, k, true);
    return std::ranges::equal(lower->points(), upper->points()) &&
           std::ranges::equal(lower->weights(), upper->weights());
}

Collapses collapses_of(const Spline &spline) {
    Collapses result{};
    for (int k = 0; k < spline.axes() && spline.axes() > 1; ++k) {
        for (const bool upper : {false, true}) {
            const SplinePtr side = end_of_axis(spline, k, upper);
            const std::vector<double> points = refine::cartesian_points(*side);
            for (int l = 0; l < side->axes(); ++l) {
                result[static_cast<size_t>(k)][upper ? 1 : 0][static_cast<size_t>(l < k ? l : l + 1)] =
                    is_along(*side, points, l);
            }
        }
    }
    return result;
}

} // namespace nrb::mesh
