// SPDX-License-Identifier: MIT
// The ends of the quintic pieces of an approximated offset along an axis, and its control points.
#pragma once

#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::fit {

inline constexpr int patch_degree = 5;

// The ends of patches along an axis, and the number of derivatives that are equal on both sides of each, at
// most 2.
struct PatchAxis {
    std::vector<double> breaks;
    std::vector<int> smooth;

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(breaks) - 1; }
    [[nodiscard]] bool is_end(size_t i) const noexcept { return i == 0 || i + 1 == breaks.size(); }
};

// The pieces of a spline along its axis. A derivative of the offset depends on derivatives of the spline of
// one order more.
PatchAxis patch_axis(const KnotVector &axis);

// The knots of quintics that join as smoothly as that.
KnotVectorPtr knots_of(const PatchAxis &axis);

// A site: a side of a break, where the offset has a Taylor polynomial along the axis. Both sides are one site
// where their polynomials are equal.
struct Site {
    size_t at;
    bool left;
};
std::vector<Site> sites_of(const PatchAxis &axis);

// A control point along the axis: factors[0] c_0 + factors[1] c_1 + factors[2] c_2 with the Taylor
// coefficients c at a site. This is the polar form (blossom) of the polynomial at the five knots of the
// control point, of which three are the break and two lie x and y away from it:
//     c_0 + (x + y) c_1 / 5 + x y c_2 / 10
struct Layer {
    size_t site;
    std::array<double, 3> factors;
};
std::vector<Layer> layers_of(const PatchAxis &axis);

// The number of parts into which a patch with a bound is to be cut; 1: it is not cut. The error of quintics
// falls with the sixth power of the lengths of their intervals; a bound that is infinite says nothing about
// it.
int parts_for(double bound, double tolerance) noexcept;

// Cuts interval i into parts[i] equal parts, which join smoothly.
PatchAxis cut(const PatchAxis &axis, const std::vector<int> &parts);

// Whether the breaks increase strictly: no interval has become too short to have an inside.
bool rising(const PatchAxis &axis) noexcept;

} // namespace nrb::fit
