// SPDX-License-Identifier: MIT
// Curves of contact as branches of a meet.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/curves/cross_curve.h"

namespace nrb::intersect {

// Through all contacts. Those through which none is found, or of which it is left open how it goes on, become clusters.
std::vector<ContactCurve> contact_curves(ContactTracer &tracer, CrossParts &found);

// Cut where parameters do not go on.
void add_branches(const std::vector<ContactCurve> &curves, const pieces::Frame &frame, const CrossSurface &a,
                  const CrossSurface &b, Meet &meet);

} // namespace nrb::intersect
