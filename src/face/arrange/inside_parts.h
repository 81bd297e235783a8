// SPDX-License-Identifier: MIT
// The parts of an arrangement that are inside, by a rule for the values of owners.
#pragma once

#include "face/arrange/parts.h"
#include "face/face.h"

#include <functional>
#include <span>
#include <vector>

namespace nrb::face {

using Inside = std::function<bool(const PassedSums &)>;

// An edge bounds parts if the inside is on one side of it only.
class InsideParts {
public:
    InsideParts(const Arrangement &arrangement, PassedSums at_corner, Inside inside);

    [[nodiscard]] const std::vector<PartLoops> &list() const noexcept { return parts_; }
    // The half-edges with the inside to their left and not to their right.
    [[nodiscard]] const std::vector<DirectedEdge> &border() const noexcept { return border_; }
    // The edges that `counts` accepts and that have the inside on neither side.
    [[nodiscard]] std::vector<DirectedEdge>
    outer_edges(const std::function<bool(const Arrangement::Edge &)> &counts) const;
    // check_area() for faces that were made of the parts.
    void check(std::span<const FacePtr> faces) const;

private:
    const Arrangement &arrangement_;
    PassedSums at_corner_;
    Inside inside_;
    std::vector<DirectedEdge> border_;
    std::vector<bool> within_; // by edges: whether either side is inside
    std::vector<PartLoops> parts_;
};

} // namespace nrb::face
