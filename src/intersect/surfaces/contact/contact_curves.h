// SPDX-License-Identifier: MIT
// Curves of tangential contact as branches of a meet.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/curves/cross_curve.h"

namespace nrb::intersect {

// Contact curves through all found.contacts. A contact becomes a cluster if no curve through it is found, or
// if the curve neither closes nor ends at borders, or is not shown to be a contact within the tolerance.
std::vector<ContactCurve> contact_curves(ContactTracer &tracer, CrossParts &found);

// Adds them as branches of kind touch, cut at seams, where the parameters do not continue.
void add_branches(const std::vector<ContactCurve> &curves, const pieces::Frame &frame, const CrossSurface &a,
                  const CrossSurface &b, Meet &meet);

} // namespace nrb::intersect
