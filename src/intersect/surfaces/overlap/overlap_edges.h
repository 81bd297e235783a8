// SPDX-License-Identifier: MIT
// The boundary of regions in which two surfaces are one, edge by edge.
#pragma once

#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/overlap/overlap_borders.h"

namespace nrb::intersect {

// Along it the region is on the left in the domain of the first surface.
struct OverlapEdge {
    std::array<size_t, 2> nodes{}; // of an edge that does not close
    bool closed = false;
    CrossPlace middle{};
    std::vector<CrossSegment> segments;
};

struct OverlapEdges {
    std::vector<CrossPlace> nodes;
    std::vector<OverlapEdge> edges;
    // Where borders are near the other surface, but bound no region: ranges of parameters, which may be periods away.
    std::vector<std::array<Interval, 4>> loose;
};

// Runs cut where others end, what runs along borders of both once. None: it is not told which parts are edges, or a curve along one
// is not found. near: in the frame.
std::optional<OverlapEdges> overlap_edges(const OverlapGround &ground, const ContactTracer &tracer,
                                          const OverlapBorders &borders, double near);

} // namespace nrb::intersect
