// SPDX-License-Identifier: MIT
// Where the cubic pieces of an approximated offset end along an axis.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// Ends of patches along an axis, and whether derivatives are equal on both sides of them.
struct PatchAxis {
    std::vector<double> breaks;
    std::vector<bool> smooth;

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(breaks) - 1; }
};

// The pieces of a spline along its axis. Derivatives of an offset are of the second order in those of the spline.
PatchAxis patch_axis(const KnotVector &axis);

// Of cubics: a smooth break takes two of them, so that the control point between its neighbours is left out.
KnotVectorPtr knots_of(const PatchAxis &axis);

// In how many parts a patch with a bound is to be cut. Cubics come nearer by the fourth power of the lengths of their intervals;
// bounds that are infinite say nothing about that.
int parts_for(double bound, double tolerance) noexcept;

// Interval i in parts[i] equal parts, which join smoothly.
PatchAxis cut(const PatchAxis &axis, const std::vector<int> &parts);

// Whether no interval has become too short to have an inside.
bool rising(const PatchAxis &axis) noexcept;

} // namespace nrb::fit
