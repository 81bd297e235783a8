// SPDX-License-Identifier: MIT
// How far the curves of a face in its domain are from its edges in space.
#pragma once

#include "face/face.h"

#include <optional>

namespace nrb::face {

// The edge of a coedge of the face as it runs, made from the curve in the domain where none was given, and kept.
SplinePtr edge_of(const Face &face, const Coedge &coedge);

// Of a made one as it was found when it was made. Of two that were given: at equal parameters if that is within the tolerance of
// the face, or at those of nearest points, else from each to the nearest point of the other.
Deviation deviation_of(const Face &face, const Coedge &coedge);

// How far two curves in space, or their ends, are from each other somewhere, where that is more than the tolerance, else 0. They may
// run in different directions and at different speeds, and closed ones may begin elsewhere. Precondition: dimension 3, tolerance > 0.
double distance_beyond(const SplinePtr &a, const SplinePtr &b, double tolerance);

// Of two curves in space, each of which is within `distance` of the other one, and so are their ends.
struct CurveMatch {
    double distance;
    bool against; // whether they run in opposite directions
};

// Of curves for which a distance of at most the tolerance can be proven: at equal parameters, as far as their domains can be made the
// same, else at those of nearest points, else from each to the nearest point of the other one. Closed ones begin at the same place. Precondition: dimension 3,
// tolerance > 0.
std::optional<CurveMatch> match_within(const SplinePtr &a, const SplinePtr &b, double tolerance);

} // namespace nrb::face
