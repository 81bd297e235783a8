// SPDX-License-Identifier: MIT
// Curves of a loop, cut into monotone pieces.
#pragma once

#include "face/trims/trim_piece.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::face {

// A curve in the plane that covers the domain: a stored curve, moved by periods.
struct PlacedCurve {
    SplinePtr curve;
    Point2 shift{0, 0};
};

// A gap of a loop: two places between which it needs a segment.
struct Joint {
    Point2 from, to;
};

// Appends the pieces of the curves of a loop one after the other, with a segment wherever a curve does not
// begin where the one before it ends, to rounding; the loop is closed bit for bit. A span is cut at the zeros
// of the derivatives of its coordinates. There are none if its control coordinates ascend or descend, because
// the variation diminishing property holds for positive weights, too. At the end the loop is back at its
// start, moved by `turn`. Returns where segments were added. Cost: linear in the number of spans.
std::vector<Joint> append_monotone(const std::vector<PlacedCurve> &loop, int32_t number, const Point2 &turn,
                                   TrimPieces &out);

// The same for a single curve, from `start` to `end`: with segments where the curve does not begin or end
// there, to rounding.
void append_between(const PlacedCurve &placed, int32_t number, const Point2 &start, const Point2 &end,
                    TrimPieces &out);

} // namespace nrb::face
