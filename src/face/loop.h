// SPDX-License-Identifier: MIT
// The loops that bound a face.
#pragma once

#include "face/trims/monotone.h"
#include "spline/spline.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace nrb::face {

// The distance between a curve in space and the image of a curve in the domain; a bound if `proven`.
struct Deviation {
    double distance = 0;
    bool proven = false;
};

// A curve of a loop: in the domain of the surface, and as an edge in space. One of the two may be null.
struct Coedge {
    SplinePtr curve;
    SplinePtr edge;
    int64_t key = 0;                      // identifies edges that faces share; 0: none
    bool against = false;                 // whether the edge runs against the curve
    std::optional<Deviation> deviation{}; // if the curve was made from the edge
};
using Loop = std::vector<Coedge>;

struct PlacedLoop {
    std::vector<PlacedCurve> curves;
    Point2 turn{0, 0}; // by which its end is moved from its start: periods of closed axes
};

// With the segments that close gaps larger than the tolerance.
struct ClosedLoop {
    PlacedLoop placed;
    std::vector<Joint> segments;
};

// Places the curves of a loop one after the other in the plane that covers the domain: each in the copy in
// which its start is nearest to the end of the curve before it. Where the loop goes through a pole, it goes
// around the pole with the inside to the left; if it leaves the pole on the meridian on which it arrived,
// once around.
PlacedLoop placed(const Spline &surface, const Covering &covering, const Loop &loop, double tolerance);

// The largest distance in space between the end of a curve and the start of the next one, rounded up.
double largest_gap(const Spline &surface, const Covering &covering, const Loop &loop);

// The boundary of the whole domain: one loop, or two around a closed axis, or none where everything is
// closed. Poles have no curves.
std::vector<Loop> natural_loops(const Covering &covering);

// The loop in the opposite direction.
Loop turned(const Loop &loop);

} // namespace nrb::face
