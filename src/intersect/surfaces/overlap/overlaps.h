// SPDX-License-Identifier: MIT
// Regions in which two surfaces are one, as a part of their meet.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/curves/cross_curve.h"
#include "intersect/surfaces/overlap/overlap_loops.h"

namespace nrb::intersect {

struct Overlaps {
    OverlapEdges edges;
    OverlapRegions regions;
    std::vector<CrossPlace> places; // inside of each
};

// What is in them is taken out of what was found. None: there are none, or they are not proven, and nothing is changed.
// tolerance: of the caller.
std::optional<Overlaps> find_overlaps(const OverlapGround &ground, const ContactTracer &tracer,
                                      double tolerance, double near, CrossParts &found);

// Each on a level of its own, from 1 on.
void add_overlaps(const Overlaps &overlaps, const pieces::Frame &frame, const CrossSurface &a,
                  const CrossSurface &b, Meet &meet);

} // namespace nrb::intersect
