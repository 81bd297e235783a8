// SPDX-License-Identifier: MIT
// The parts of an arrangement that are inside by the values of owners.
#pragma once

#include "face/arrange/parts.h"
#include "face/face.h"

#include <functional>
#include <span>
#include <vector>

namespace nrb::face {

using Inside = std::function<bool(const PassedSums &)>;

// What is inside on both sides of an edge, and what on none, is not divided by it.
class InsideParts {
public:
    InsideParts(const Arrangement &arrangement, PassedSums at_corner, Inside inside);

    [[nodiscard]] const std::vector<PartLoops> &list() const noexcept { return parts_; }
    // Edges that have the inside to their left only.
    [[nodiscard]] const std::vector<DirectedEdge> &border() const noexcept { return border_; }
    // Edges in whose members `counts` tells interest, and beside which nothing is inside.
    [[nodiscard]] std::vector<DirectedEdge>
    outer_edges(const std::function<bool(const Arrangement::Edge &)> &counts) const;
    // What check_area() does, of faces that were made of the parts.
    void check(std::span<const FacePtr> faces) const;

private:
    const Arrangement &arrangement_;
    PassedSums at_corner_;
    Inside inside_;
    std::vector<DirectedEdge> border_;
    std::vector<bool> within_; // of edges: whether something beside them is inside
    std::vector<PartLoops> parts_;
};

} // namespace nrb::face
