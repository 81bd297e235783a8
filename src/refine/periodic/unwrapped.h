// SPDX-License-Identifier: MIT
// Periodic axes in unwrapped form, without what they repeat: the knots of one period with its end, which are
// those of the domain, and each control point once, which are the first layers. Other axes are left whole.
#pragma once

#include "spline/axis_view.h"

#include <array>

namespace nrb::refine {

// Checks the m + 1 knots of a period of m control points: finite, sorted, not all equal, and no knot more
// than degree + 1 times, where the last knot is the first one of the next period. `axis` and `offset` are for
// messages, as in check_knots().
void check_period(int degree, std::span<const double> period, int axis, int64_t offset);

// All m + 2 degree + 1 knots of an axis with this period. Equal knots get equal copies. Throws
// Status::not_representable if copies overflow, or if rounding makes too many of them equal. Precondition:
// check_period() accepts the period.
std::vector<double> wrapped_knots(int degree, std::span<const double> period);

std::span<const double> unwrapped_knots(const KnotVector &axis) noexcept;

// The first `distinct` layers of an axis, followed by copies of them up to `count` layers in all.
std::vector<double> wrapped_layers(std::span<const double> values, const AxisView &view, int64_t distinct,
                                   int64_t count);

// From `width` values for each distinct control point to values for all control points of a spline with these
// axes.
std::vector<double> wrapped(std::vector<double> values, const Spline::Axes &axes, int64_t width);

// Calls use(i, j) for each distinct control point: i is its number among these, j its number among all.
template <class Use>
void for_each_distinct(const Spline &spline, Use &&use) {
    std::array<int64_t, max_axes> distinct{1, 1, 1}, count{1, 1, 1};
    for (int k = 0; k < spline.axes(); ++k) {
        distinct[static_cast<size_t>(k)] = spline.axis(k).distinct_layers();
        count[static_cast<size_t>(k)] = spline.count(k);
    }
    int64_t next = 0;
    for (int64_t i = 0; i < distinct[0]; ++i) {
        for (int64_t j = 0; j < distinct[1]; ++j) {
            for (int64_t k = 0; k < distinct[2]; ++k) {
                use(next++, (i * count[1] + j) * count[2] + k);
            }
        }
    }
}

} // namespace nrb::refine
