// SPDX-License-Identifier: MIT
// How far a face is from the segments of a polyline of its border.
#pragma once

#include "face/face.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// For each segment between consecutive vertices, from samples: how far the image of the segment of the domain
// is from the segment in space, plus how far the image of the curve is from that at equal parameters.
// `params`: of the curve, at the vertices.
std::vector<double> distances_under(const face::Face &face, const Spline &curve,
                                    std::span<const double> params);

} // namespace nrb::mesh
