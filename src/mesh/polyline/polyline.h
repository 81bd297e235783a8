// SPDX-License-Identifier: MIT
// Polylines in place of curves, within a proven distance.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// What is asked of every segment. 0: no limit of that kind.
struct PolylineRule {
    double chord;       // of the Hausdorff distance from its part of the curve; may be infinite
    double angle = 0;   // between any two tangents of that part, in radians
    double longest = 0; // of its length
};

struct Polyline {
    // Rising; where the curve jumps, the same parameter twice, for the limits from the left and from the right.
    std::vector<double> params;
    // [params][dim], as evaluation returns them; of a periodic curve the last is the first, bit for bit.
    std::vector<double> points;
    // [params - 1]: no more is the Hausdorff distance of a segment from its part of the curve, 0 at jumps.
    std::vector<double> bounds;
    bool reached = true; // every segment keeps to the rule, as proven
};

// With vertices at the ends of the domain, at jumps, at kinks, and at parameters `fixed`, which rise in the domain. Between
// these, as few as greedy steps find, and then spread evenly. A curve that closes has three segments or more unless
// it is a point. Ends at the limit of work with what it has.
Polyline polyline_of(const Spline &curve, const PolylineRule &rule, std::span<const double> fixed = {});

} // namespace nrb::mesh
