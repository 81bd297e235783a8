// SPDX-License-Identifier: MIT
// Parameters of axes that may be periodic, and of curves that may jump.
#pragma once

#include "spline/spline.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::intersect {

// The length of a period; 0 if there is none.
inline double period_of(const KnotVector &axis) noexcept {
    const Interval domain = axis.domain();
    return axis.periodic() ? domain.upper - domain.lower : 0;
}
inline double period_of(const Spline &curve) noexcept {
    return period_of(curve.axis(0));
}

// The multiple of the period that moves a parameter into the domain.
inline double shift_of(const KnotVector &axis, double t) noexcept {
    const Interval domain = axis.domain();
    const double period = period_of(axis);
    const bool outside = t < domain.lower || t > domain.upper;
    return period > 0 && outside ? -std::floor((t - domain.lower) / period) * period : 0;
}
inline double shift_of(const Spline &curve, double t) noexcept {
    return shift_of(curve.axis(0), t);
}

inline double in_domain(const KnotVector &axis, double t) noexcept {
    const Interval domain = axis.domain();
    return std::clamp(t + shift_of(axis, t), domain.lower, domain.upper);
}
inline double in_domain(const Spline &curve, double t) noexcept {
    return in_domain(curve.axis(0), t);
}

inline Interval turned(Interval part, int turns, double period) noexcept {
    return {part.lower + turns * period, part.upper + turns * period};
}

// Whether two points agree as far as rounding can tell. size: that of the shape to which they belong.
bool are_one_point(const double *x, const double *y, int dim, double size) noexcept;

// The knots in the domain at which the limits from both sides differ by more than rounding. If a periodic
// curve jumps at its seam, these include both ends of the domain.
std::vector<double> jumps_of(const Spline &curve);

// Whether a curve ends where it begins.
bool closes(const Spline &curve);

} // namespace nrb::intersect
