// SPDX-License-Identifier: MIT
// What a surface has in common with itself is found twice, with both of its places in either order: one of both is kept.
#pragma once

#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/cross_chains.h"

namespace nrb::intersect {

// Groups of clusters, of which each is taken with its places in one order, and then these with their places in the other order.
std::vector<CrossGroup> mirrored_groups(const CrossSurface &surface, const CrossTouch &touch,
                                        std::vector<CrossCluster> clusters);

// Ways of chains. One that is its own mirror, along which places change their order, stays as it is, and goes round twice.
void remove_mirrored(const CrossSurface &surface, const CrossParts &found, CrossChains &chains);

void remove_mirrored(const ContactTracer &tracer, std::vector<ContactCurve> &curves);

// Parts in which branches are not told apart, unless branches end in both. near: of those in which places are the same ones, or side by
// side, all that are larger than the tolerance are left open.
void remove_mirrored(const CrossSurface &surface, const CrossTouch &touch, Meet &meet);

} // namespace nrb::intersect
