// SPDX-License-Identifier: MIT
// Self-intersections are found twice, once for each order of their two places ('mirrored': in the other
// order). These functions keep one of both.
#pragma once

#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/cross_chains.h"

namespace nrb::intersect {

// Groups of clusters, which are first brought into one order of their places; then the mirrored copies of all
// groups.
std::vector<CrossGroup> mirrored_groups(const CrossSurface &surface, const CrossTouch &touch,
                                        std::vector<CrossCluster> clusters);

// Removes one of each pair of mirrored ways, which are chains that continue each other. A way that is its own
// mirror, along which the places change their order, is kept: it runs through its points twice.
void remove_mirrored(const CrossSurface &surface, const CrossParts &found, CrossChains &chains);

// Removes one of each pair of mirrored contact curves.
void remove_mirrored(const ContactTracer &tracer, std::vector<ContactCurve> &curves);

// Merges mirrored nodes of kind touch and undecided, unless branches end in both. A touch whose two ranges
// have places in common, so that part of it is the surface meeting itself trivially, becomes undecided unless
// it is small to within the tolerance.
void remove_mirrored(const CrossSurface &surface, const CrossTouch &touch, Meet &meet);

} // namespace nrb::intersect
