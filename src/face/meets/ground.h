// SPDX-License-Identifier: MIT
// The part of a surface that what a face has in common with others is looked for on.
#pragma once

#include "face/face.h"
#include "numeric/vector3.h"

namespace nrb::face {

// Of the rectangle: small enough to stay near, and large enough for what is found beside the border to be no part of the face.
inline constexpr double usual_margin = 1.0 / 64;

// The surface over a little more than the smallest rectangle that holds the face, by the same parameters. `beyond`: continued where
// the domain ends, as far as its weights stay positive, so that what runs along its ends does not; axes that close and poles stay.
SplinePtr ground_of(const Face &face, bool beyond, double margin = usual_margin);

// S_u x S_v over powers of two; 0 where it is not defined. Precondition: a place of the domain.
Vector3 surface_normal(const Spline &surface, const Point2 &at);

} // namespace nrb::face
