// SPDX-License-Identifier: MIT
// How far the curves of a face in its domain are from its edges in space.
#pragma once

#include "face/face.h"

#include <optional>

namespace nrb::face {

// The edge of a coedge of the face, in the direction that the edge has. Where no edge was given, it is made
// from the curve in the domain, and kept with the face.
SplinePtr edge_of(const Face &face, const Coedge &coedge);

// The distance between the curve of a coedge, as the surface maps it, and its edge. If one was made from the
// other, as it was found then. If both were given: at equal parameters or at those of nearest points, if that
// is within the tolerance of the face; else the Hausdorff distance.
Deviation deviation_of(const Face &face, const Coedge &coedge);

// A distance above the tolerance that two curves in space have at some place, or between their ends; 0 if
// none is found. The curves may run in different directions and at different speeds, and closed ones may
// begin at different places. Precondition: dimension 3, tolerance > 0.
double distance_beyond(const SplinePtr &a, const SplinePtr &b, double tolerance);

// Two curves in space match: no point of either is farther than `distance` from the other one. Their ends,
// paired by `against`, match within the tolerance.
struct CurveMatch {
    double distance;
    bool against; // whether they run in opposite directions
};

// Matches two curves if a distance of at most the tolerance can be proven: at equal parameters, if their
// domains can be made the same; else at the parameters of nearest points; else the Hausdorff distance. Closed
// curves have to begin at the same place. Precondition: dimension 3, tolerance > 0.
std::optional<CurveMatch> match_within(const SplinePtr &a, const SplinePtr &b, double tolerance);

} // namespace nrb::face
