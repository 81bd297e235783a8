// SPDX-License-Identifier: MIT
// How much of a domain is covered: by faces, as they are told in the end, and by parts of an arrangement, as they were meant.
#pragma once

#include "face/arrange/arrangement.h"
#include "face/face.h"

#include <functional>
#include <span>

namespace nrb::face {

// As the map of sides of a face tells it, whatever made its loops: the integral over the columns of what is inside.
double domain_area(const Face &face);

// What edges have to their left, if at_top tells whether the upper end of a column is there.
double domain_area(const Arrangement &arrangement, std::span<const DirectedEdge> border,
                   const std::function<bool(double u)> &at_top);

// Throws Status::not_converged if faces cover another area of the domain than they should by more than what is near can make of all
// edges: a wrong part is worse than none.
void check_area(const Arrangement &arrangement, std::span<const FacePtr> faces, double expected);

} // namespace nrb::face
