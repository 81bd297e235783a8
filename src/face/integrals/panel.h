// SPDX-License-Identifier: MIT
// The panels of a face: parts on which integrands are smooth.
#pragma once

#include "face/trims/trim_map.h"

#include <vector>

namespace nrb::face {

// A rectangle of the domain, or the area between a part of a piece and the lower end of its span of v. It
// lies in one span of each axis of the surface.
struct Panel {
    const TrimPiece *piece = nullptr; // null: the rectangle
    Interval along{};                 // of the piece, or of u
    Interval v{};                     // of a rectangle; below a piece only the lower end counts
    Interval share{0, 1};             // of the height, from the lower end up
    double factor = 1;                // how often it counts, negative where it was counted too often

    // The place at (x, y) in [0, 1]^2, and its derivatives by x and y.
    struct Jet {
        Point2 place, by_x, by_y;
    };
    [[nodiscard]] Jet jet(const TrimPieces &pieces, double x, double y) const noexcept;
    // Halves the panel across x or y: this becomes the upper half, and the lower one is returned.
    Panel halve(size_t axis) noexcept;
};

// The face as a sum of panels. Each column of the surface is run through from top to bottom, span by span,
// with the values (TrimMap) at its top to begin with. In each span there are rectangles with the values at
// its upper end, and for each piece the area below it, which is added or taken away. Breaks: the knots of
// both axes in the domain. Cost: linear in the number of pieces times the spans that they cross, and of spans
// inside.
std::vector<Panel> panels_of(const TrimMap &trims, const std::vector<double> &u_breaks,
                             const std::vector<double> &v_breaks);

} // namespace nrb::face
