// SPDX-License-Identifier: MIT
// The ground of a face: the part of its surface on which common points with other faces are searched for.
#pragma once

#include "face/face.h"
#include "numeric/vector3.h"

namespace nrb::face {

// A share of the smallest rectangle that contains the face. It is so small that the ground stays near the
// face, and so large that what is found beside the border is no part of the face.
inline constexpr double usual_margin = 1.0 / 64;

// The surface over a little more than the smallest rectangle that contains the face, by the same parameters.
// beyond: whether it is continued where the domain ends, as far as its weights stay positive, so that what
// runs along ends of the domain does not run along ends of the ground. Closed axes and poles are not
// continued.
SplinePtr ground_of(const Face &face, bool beyond, double margin = usual_margin);

// S_u x S_v, each divided by a power of two; 0 where it is not defined. Precondition: a place of the domain.
Vector3 surface_normal(const Spline &surface, const Point2 &at);

} // namespace nrb::face
