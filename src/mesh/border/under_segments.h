// SPDX-License-Identifier: MIT
// What a face has under the segments of a polyline.
#pragma once

#include "face/face.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// How far it is from each segment at most, as samples have it: on its curve, or on the segment of its domain. Parameters of the curve at
// the vertices.
std::vector<double> distances_under(const face::Face &face, const Spline &curve,
                                    std::span<const double> params);

} // namespace nrb::mesh
