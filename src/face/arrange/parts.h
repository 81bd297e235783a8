// SPDX-License-Identifier: MIT
// The parts of a domain, each in one piece, that edges of an arrangement bound.
#pragma once

#include "face/arrange/ways.h"
#include "face/trims/loop_shape.h"

#include <map>

namespace nrb::face {

// The loops of a part: one around it, and those around holes.
using PartLoops = std::vector<EdgeLoop>;

// Parts to the left of edges, which are all that bound them: a loop around a hole belongs to the part that lies above its
// highest place. Loops that enclose nothing to rounding are left out. Throws Status::not_converged where edges do not go on, or
// rounding hides what is above.
class PartsWithin {
public:
    PartsWithin(const Arrangement &arrangement, const std::vector<DirectedEdge> &border);

    // The name of a part, for edges of the border.
    [[nodiscard]] size_t part_left_of(DirectedEdge edge) const { return names_[way_of_.at(edge)]; }
    [[nodiscard]] std::vector<PartLoops> list() const;

private:
    [[nodiscard]] LoopShape shape_of(const EdgeLoop &way) const;
    [[nodiscard]] bool is_nothing(size_t way) const noexcept;
    [[nodiscard]] Point2 top_of(const EdgeLoop &way) const;
    [[nodiscard]] size_t way_above(const EdgeLoop &way) const;
    [[nodiscard]] bool bounds_something(const TrimPiece &piece) const;

    const Arrangement &arrangement_;
    std::vector<EdgeLoop> ways_;
    std::vector<LoopShape> shapes_;
    std::map<DirectedEdge, size_t> way_of_;
    std::vector<size_t> names_; // of parts, by ways
};

} // namespace nrb::face
