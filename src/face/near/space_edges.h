// SPDX-License-Identifier: MIT
// The boundary of a face in space, to be searched.
#pragma once

#include "face/boundary.h"

#include <vector>

namespace nrb::face {

struct SpaceEdge {
    BoundaryCurve curve;              // with a curve in space
    std::vector<double> lower, upper; // of its box

    // At least how far a box [dim] is away.
    [[nodiscard]] double distance(const double *box_lower, const double *box_upper) const noexcept;
};

struct SpaceEdges {
    std::vector<SpaceEdge> all;
    // Else some could not be composed with the surface, and are near it, without proof; or the surface jumps along them.
    bool exact = true;
};

SpaceEdges space_edges(const Face &face);

// Of the face: where the first curve begins.
Point2 place_of(const Face &face, const SpaceEdges &edges);

// Where a curve is in the domain, at one of its parameters or just below that.
Point2 place_on(const Face &face, const BoundaryCurve &curve, double t, bool left);

} // namespace nrb::face
