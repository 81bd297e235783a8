// SPDX-License-Identifier: MIT
// Overlaps, the regions in which two surfaces coincide within the tolerance, as parts of their meet.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/curves/cross_curve.h"
#include "intersect/surfaces/overlap/overlap_loops.h"

namespace nrb::intersect {

struct Overlaps {
    OverlapEdges edges;
    OverlapRegions regions;
    std::vector<CrossPlace> places; // one inside of each region
};

// Finds and proves the overlaps, and removes from `found` what is in them. None: there are none, or they are
// not proven; `found` is unchanged then. tolerance, near: the same tolerance in the unit of the caller, and
// in the frame.
std::optional<Overlaps> find_overlaps(const OverlapGround &ground, const ContactTracer &tracer,
                                      double tolerance, double near, CrossParts &found);

// Adds each region to the meet, on a level of its own, from 1 on.
void add_overlaps(const Overlaps &overlaps, const pieces::Frame &frame, const CrossSurface &a,
                  const CrossSurface &b, Meet &meet);

} // namespace nrb::intersect
