// SPDX-License-Identifier: MIT
// Curves of a loop as pieces on which both parameters run one way.
#pragma once

#include "face/trims/trim_piece.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::face {

// A curve in the plane that covers the domain: the stored one, moved by periods.
struct PlacedCurve {
    SplinePtr curve;
    Point2 shift{0, 0};
};

// Two places that a loop has to join.
struct Joint {
    Point2 from, to;
};

// Appends the pieces of the curves of a loop one after the other, with a segment wherever one does not begin bit for bit where
// the one before it ends. A piece is cut at the zeros of the derivatives of its coordinates, unless its coefficients rise or
// fall, which proves that it has none (variation diminution holds for positive weights too). Returns where
// segments were put in. The loop comes back to its start moved by `turn`.
// Cost: linear in the number of spans.
std::vector<Joint> append_monotone(const std::vector<PlacedCurve> &loop, int32_t number, const Point2 &turn,
                                   TrimPieces &out);

// The same of one curve from one place to another, with segments where it does not begin at the first of them, or end at the
// second, to rounding.
void append_between(const PlacedCurve &placed, int32_t number, const Point2 &start, const Point2 &end,
                    TrimPieces &out);

} // namespace nrb::face
