// SPDX-License-Identifier: MIT
// Curves of the plane that covers a domain, in parts that lie in the domain.
#pragma once

#include "face/covering.h"

#include <vector>

namespace nrb::face {

// The parts of a curve between seams, each moved into the domain, its ends at seams set to these; none if it leaves the domain elsewhere.
// Their parameters are those of the curve.
std::vector<SplinePtr> seam_parts(const Covering &covering, const SplinePtr &curve);

} // namespace nrb::face
