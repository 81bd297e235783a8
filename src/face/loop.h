// SPDX-License-Identifier: MIT
// The loops that bound a face.
#pragma once

#include "face/trims/monotone.h"
#include "spline/spline.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace nrb::face {

// How far apart a curve in space and what the surface makes of one in its domain are, at most if `proven`.
struct Deviation {
    double distance = 0;
    bool proven = false;
};

// A curve of a loop: in the domain of the surface, and in space. One of the two may be null.
struct Coedge {
    SplinePtr curve;
    SplinePtr edge;
    int64_t key = 0;                      // by which faces know their common edges; 0: none
    bool against = false;                 // whether the edge runs against the curve
    std::optional<Deviation> deviation{}; // of a curve that was made from the edge
};
using Loop = std::vector<Coedge>;

struct PlacedLoop {
    std::vector<PlacedCurve> curves;
    Point2 turn{0, 0}; // by which it comes back to its start: periods of closed axes
};

// With the segments that close gaps which are larger than the tolerance.
struct ClosedLoop {
    PlacedLoop placed;
    std::vector<Joint> segments;
};

// The curves of a loop one after the other in the plane that covers the domain, each in the copy in which it begins nearest to
// where the one before it ends. At a pole the way leads around it, the inside to the left; where a loop comes back on the
// meridian that it came on, once around.
PlacedLoop placed(const Spline &surface, const Covering &covering, const Loop &loop, double tolerance);

// The largest distance in space of ends that follow one another, rounded up.
double largest_gap(const Spline &surface, const Covering &covering, const Loop &loop);

// The boundary of the whole domain: one loop, or two around a closed axis, or none where everything is closed. Poles have no
// curves.
std::vector<Loop> natural_loops(const Covering &covering);

// The loop backwards.
Loop turned(const Loop &loop);

} // namespace nrb::face
