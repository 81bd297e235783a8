// SPDX-License-Identifier: MIT
// The edges that bound the overlaps of two surfaces: regions in which they coincide within the tolerance.
#pragma once

#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/overlap/overlap_borders.h"

namespace nrb::intersect {

// An edge has the region on its left in the domain of the first surface.
struct OverlapEdge {
    std::array<size_t, 2> nodes{}; // of an edge that is not closed
    bool closed = false;
    CrossPlace middle{};
    std::vector<CrossSegment> segments;
};

struct OverlapEdges {
    std::vector<CrossPlace> nodes;
    std::vector<OverlapEdge> edges;
    // Ranges of parameters in which borders are near the other surface but bound no region. They may be off
    // by whole periods.
    std::vector<std::array<Interval, 4>> loose;
};

// The edges: runs are cut at the ends of others, and those along borders of both surfaces are taken once.
// None: it is left open which parts of runs are edges, or the curve along one is not found. near: the
// tolerance in the frame.
std::optional<OverlapEdges> overlap_edges(const OverlapGround &ground, const ContactTracer &tracer,
                                          const OverlapBorders &borders, double near);

} // namespace nrb::intersect
