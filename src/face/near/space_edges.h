// SPDX-License-Identifier: MIT
// The boundary of a face as curves in space with their boxes, for searches.
#pragma once

#include "face/boundary.h"

#include <vector>

namespace nrb::face {

struct SpaceEdge {
    BoundaryCurve curve;              // with a curve in space
    std::vector<double> lower, upper; // its box

    // A lower bound on the distance from a box [dim].
    [[nodiscard]] double distance(const double *box_lower, const double *box_upper) const noexcept;
};

struct SpaceEdges {
    std::vector<SpaceEdge> all;
    // False if some curves could not be composed with the surface, so that they are near the boundary without
    // proof, or if the surface jumps along a curve.
    bool exact = true;
};

SpaceEdges space_edges(const Face &face);

// A place of the face: where the first curve begins.
Point2 place_of(const Face &face, const SpaceEdges &edges);

// The place in the domain of a curve at one of its parameters; with `left`, the limit from below.
Point2 place_on(const Face &face, const BoundaryCurve &curve, double t, bool left);

} // namespace nrb::face
