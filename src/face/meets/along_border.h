// SPDX-License-Identifier: MIT
// Curves that run along the border of a face.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// Whether parts of a curve cover its domain, except for gaps that are within the accuracy of the ends of such
// parts.
bool cover(std::vector<Interval> parts, const Interval &domain);

// Whether a curve in the domain of a face runs along curves of its loops from end to end.
bool runs_along_border(const Face &face, const Spline &curve);

} // namespace nrb::face
