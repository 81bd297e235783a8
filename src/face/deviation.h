// SPDX-License-Identifier: MIT
// How far the curves of a face in its domain are from its edges in space.
#pragma once

#include "face/face.h"

namespace nrb::face {

// The edge of a coedge as it runs, made from the curve in the domain where none was given.
SplinePtr edge_of(const Face &face, const Coedge &coedge);

// Of a made one as it was found when it was made. Of two that were given: at equal parameters if that is within the tolerance of
// the face, else from each to the nearest point of the other.
Deviation deviation_of(const Face &face, const Coedge &coedge);

// How far two curves in space, or their ends, are from each other somewhere, where that is more than the tolerance, else 0. They may
// run in different directions and at different speeds, and closed ones may begin elsewhere. Precondition: dimension 3, tolerance > 0.
double distance_beyond(const SplinePtr &a, const SplinePtr &b, double tolerance);

} // namespace nrb::face
