// SPDX-License-Identifier: MIT
// Curves that run along borders.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// Whether parts of a curve are all of it, but for what is as short as ends of such parts are exact.
bool cover(std::vector<Interval> parts, const Interval &domain);

// Whether a curve in the domain runs along curves of loops from end to end.
bool runs_along_border(const Face &face, const Spline &curve);

} // namespace nrb::face
