// SPDX-License-Identifier: MIT
#include "face/arrange/inside_parts.h"

#include "face/arrange/domain_area.h"
#include "face/arrange/edge_sides.h"

#include <utility>

namespace nrb::face {

InsideParts::InsideParts(const Arrangement &arrangement, PassedSums at_corner, Inside inside)
    : arrangement_(arrangement), at_corner_(std::move(at_corner)), inside_(std::move(inside)) {
    const std::vector<SideValues> sides = values_beside(arrangement_, at_corner_);
    for (size_t i = 0; i < sides.size(); ++i) {
        const bool in_left = inside_(sides[i].left), in_right = inside_(sides[i].right);
        within_.push_back(in_left || in_right);
        if (in_left != in_right) {
            border_.push_back({i, !in_left});
        }
    }
    parts_ = PartsWithin(arrangement_, border_).list(inside_(at_corner_));
}

std::vector<DirectedEdge>
InsideParts::outer_edges(const std::function<bool(const Arrangement::Edge &)> &counts) const {
    std::vector<DirectedEdge> result;
    for (size_t i = 0; i < within_.size(); ++i) {
        if (!within_[i] && counts(arrangement_.edges()[i])) {
            result.push_back({i, false});
        }
    }
    return result;
}

void InsideParts::check(std::span<const FacePtr> faces) const {
    const auto at_top = [&](double u) { return inside_(values_at_top(arrangement_, at_corner_, u)); };
    check_area(arrangement_, faces, domain_area(arrangement_, border_, at_top));
}

} // namespace nrb::face
