// SPDX-License-Identifier: MIT
// How large a shape is, for limits that are shares of that.
#pragma once

#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

// The longest side of the box of control points, to which those of a spline are added.
inline double extent_of(const Spline &spline, std::vector<Interval> &box) {
    box.resize(static_cast<size_t>(spline.dim()), {infinity, -infinity});
    double extent = 0;
    for (int c = 0; c < spline.dim(); ++c) {
        Interval &side = box[static_cast<size_t>(c)];
        for (int64_t i = 0; i < spline.point_count(); ++i) {
            const double x = spline.coordinate(i, c);
            side = {std::min(side.lower, x), std::max(side.upper, x)};
        }
        extent = std::max(extent, side.upper - side.lower);
    }
    return extent;
}

// No normal is known as well as smaller angles. For these a mesh for the eye is made.
inline double angle_within_reach(double angle) {
    return angle > 0 && angle < 1e-7 ? 0.1 : angle;
}

// With one distance.
inline MeshRule settled(MeshRule rule, double extent) {
    if (rule.relative > 0) {
        rule.chord = std::min(rule.chord, rule.relative * extent);
    }
    return rule;
}

// About as many cells fewer as distances are larger.
inline MeshRule coarsened(MeshRule rule, double factor) noexcept {
    rule.chord *= factor;
    rule.longest *= std::sqrt(factor);
    rule.angle *= std::sqrt(factor);
    return rule;
}

} // namespace nrb::mesh
