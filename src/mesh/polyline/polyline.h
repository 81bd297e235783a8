// SPDX-License-Identifier: MIT
// Approximates curves by polylines within a proven Hausdorff distance.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// What every segment has to fulfil. 0: no limit of that kind.
struct PolylineRule {
    double chord;       // largest Hausdorff distance from its part of the curve; may be infinite
    double angle = 0;   // largest angle between any two tangents of that part, in radians
    double longest = 0; // largest length
};

struct Polyline {
    // Ascending; where the curve jumps, the same parameter twice, for the limits from the left and from the
    // right.
    std::vector<double> params;
    // [params][dim], as evaluation returns them. The last point of a periodic curve is the first, bit for
    // bit.
    std::vector<double> points;
    // [params - 1]: a bound on the Hausdorff distance of each segment from its part of the curve; 0 at jumps.
    std::vector<double> bounds;
    bool reached = true; // whether every segment is proven to keep to the rule
};

// There are vertices at the ends of the domain, at jumps, at kinks, and at the parameters `fixed`, which
// ascend in the domain. Between these there are as few as greedy steps find, spread evenly. A closed curve
// has three segments or more. At the limit of work it ends with what it has by then.
Polyline polyline_of(const Spline &curve, const PolylineRule &rule, std::span<const double> fixed = {});

} // namespace nrb::mesh
