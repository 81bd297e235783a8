// SPDX-License-Identifier: MIT
// Where the quintic pieces of an approximated offset end along an axis, and what its control points are.
#pragma once

#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::fit {

inline constexpr int patch_degree = 5;

// Ends of patches along an axis, and how many derivatives are equal on both sides of them, at most 2.
struct PatchAxis {
    std::vector<double> breaks;
    std::vector<int> smooth;

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(breaks) - 1; }
    [[nodiscard]] bool is_end(size_t i) const noexcept { return i == 0 || i + 1 == breaks.size(); }
};

// The pieces of a spline along its axis. Derivatives of an offset are of one order more in those of the spline.
PatchAxis patch_axis(const KnotVector &axis);

// Of quintics that join so smoothly.
KnotVectorPtr knots_of(const PatchAxis &axis);

// A side of a break, where the offset has a Taylor polynomial along the axis: both sides are one where they are equal up to its order.
struct Site {
    size_t at;
    bool left;
};
std::vector<Site> sites_of(const PatchAxis &axis);

// A control point along the axis: with the Taylor coefficients c at a site, factors[0] c_0 + factors[1] c_1 + factors[2] c_2. It is
// the polar form of the polynomial at its five knots, three of which are the break, and x and y away from it the others:
//     c_0 + (x + y) c_1 / 5 + x y c_2 / 10
struct Layer {
    size_t site;
    std::array<double, 3> factors;
};
std::vector<Layer> layers_of(const PatchAxis &axis);

// In how many parts a patch with a bound is to be cut. Quintics come nearer by the sixth power of the lengths of their intervals;
// bounds that are infinite say nothing about that. 1: in none.
int parts_for(double bound, double tolerance) noexcept;

// Interval i in parts[i] equal parts, which join smoothly.
PatchAxis cut(const PatchAxis &axis, const std::vector<int> &parts);

// Whether no interval has become too short to have an inside.
bool rising(const PatchAxis &axis) noexcept;

} // namespace nrb::fit
