// SPDX-License-Identifier: MIT
// The extent of a shape, and rules whose limits depend on it.
#pragma once

#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

// Extends a bounding box by the control points of a spline. Returns the longest side of the result.
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

// Rounding makes normals less accurate than angles below 1e-7: for such a limit the mesh gets one that is
// fine enough for display.
inline double angle_within_reach(double angle) {
    return angle > 0 && angle < 1e-7 ? 0.1 : angle;
}

// The same rule with a single limit of the chord error: the smaller one of chord and relative * extent.
inline MeshRule settled(MeshRule rule, double extent) {
    if (rule.relative > 0) {
        rule.chord = std::min(rule.chord, rule.relative * extent);
    }
    return rule;
}

// A rule for about 1 / factor as many cells: chord errors are quadratic in the size of cells, lengths and
// angles are linear.
inline MeshRule coarsened(MeshRule rule, double factor) noexcept {
    rule.chord *= factor;
    rule.longest *= std::sqrt(factor);
    rule.angle *= std::sqrt(factor);
    return rule;
}

} // namespace nrb::mesh
