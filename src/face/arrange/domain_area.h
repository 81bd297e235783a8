// SPDX-License-Identifier: MIT
// How much of a domain is covered: by the faces of a result, and by the parts of an arrangement from which
// they were made. The comparison checks the result.
#pragma once

#include "face/arrange/arrangement.h"
#include "face/face.h"

#include <functional>
#include <span>

namespace nrb::face {

// The area in the domain of what the trim map of a face has inside, however its loops were made: the integral
// of the value, 1 inside and 0 outside, column by column.
double domain_area(const Face &face);

// The area to the left of the edges of a border. at_top: whether the upper end of the column at u is inside.
double domain_area(const Arrangement &arrangement, std::span<const DirectedEdge> border,
                   const std::function<bool(double u)> &at_top);

// Throws Status::not_converged if the area of the domain that faces cover differs from the expected one by
// more than moving all edges by a multiple of the distance that counts as none can explain: a wrong part is
// worse than none.
void check_area(const Arrangement &arrangement, std::span<const FacePtr> faces, double expected);

} // namespace nrb::face
