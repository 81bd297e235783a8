// SPDX-License-Identifier: MIT
// The parts of a face on which integrands are smooth.
#pragma once

#include "face/trims/trim_map.h"

#include <vector>

namespace nrb::face {

// A rectangle of the domain; or what lies below a part of a piece, down to the lower end of v. It stays within one span of each
// axis of the surface.
struct Panel {
    const TrimPiece *piece = nullptr; // null: the rectangle
    Interval along{};                 // of the piece, or of u
    Interval v{};                     // the upper end: of a rectangle only
    Interval share{0, 1};             // of the way up
    double factor = 1;                // how often the face holds it, negative where it was counted too often

    // The place at x, y in [0, 1], with derivatives by both.
    struct Jet {
        Point2 place, by_x, by_y;
    };
    [[nodiscard]] Jet jet(const TrimPieces &pieces, double x, double y) const noexcept;
    // Halves across x or y: this becomes the upper one.
    Panel halve(size_t axis) noexcept;
};

// The face as a sum of panels: each column of the surface is gone down span by span, from what is inside at its top; what lies
// below the pieces in a span is added or taken away. Breaks: the knots of both axes in the domain. Cost: linear in the number of
// pieces times the spans that they pass, and of spans inside.
std::vector<Panel> panels_of(const TrimMap &trims, const std::vector<double> &u_breaks,
                             const std::vector<double> &v_breaks);

} // namespace nrb::face
