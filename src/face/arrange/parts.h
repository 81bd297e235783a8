// SPDX-License-Identifier: MIT
// The parts of a domain, each in one piece, that edges of an arrangement bound.
#pragma once

#include "base/disjoint_sets.h"
#include "face/arrange/ways.h"
#include "face/trims/loop_shape.h"

#include <array>
#include <map>

namespace nrb::face {

// The loops of a part: one around it, and those around holes.
using PartLoops = std::vector<EdgeLoop>;

// Parts to the left of edges, which are all that bound them: a loop around a hole belongs to the part that lies above its
// highest place, and what lies at a seam between two places where edges pass it to the parts beside these. Loops that enclose
// nothing to rounding are left out. Throws Status::not_converged where edges do not go on, or
// rounding hides what is above.
class PartsWithin {
public:
    PartsWithin(const Arrangement &arrangement, const std::vector<DirectedEdge> &border);

    // The name of a part, for edges of the border.
    [[nodiscard]] size_t part_left_of(DirectedEdge edge) const { return names_[way_of_.at(edge)]; }
    // around_corner: whether the corner of a domain both of whose axes close is in a part, which need not have loops.
    [[nodiscard]] std::vector<PartLoops> list(bool around_corner) const;

private:
    // What lies along a seam between contacts is an element of the sets, too.
    struct Seam {
        std::vector<SeamContact> contacts; // with edges of the border
        size_t first = 0;                  // element: what is below the first contact
        bool round = false;                // what is above the last one, too
        [[nodiscard]] size_t below(size_t contact) const noexcept { return first + contact; }
        [[nodiscard]] size_t above(size_t contact) const noexcept {
            return first + (round && contact + 1 == contacts.size() ? 0 : contact + 1);
        }
        [[nodiscard]] size_t at(double place) const noexcept;
    };

    void set_seams();
    void join_seam(int k, DisjointSets &sets);
    void join_holes(DisjointSets &sets) const;
    [[nodiscard]] LoopShape shape_of(const EdgeLoop &way) const;
    [[nodiscard]] bool is_hole(size_t way) const noexcept;
    [[nodiscard]] bool is_nothing(size_t way) const noexcept;
    [[nodiscard]] Point2 top_of(const EdgeLoop &way) const;
    [[nodiscard]] size_t element_above(const EdgeLoop &way) const;
    [[nodiscard]] bool is_of_border(int32_t chain) const;

    const Arrangement &arrangement_;
    std::vector<EdgeLoop> ways_;
    std::vector<LoopShape> shapes_;
    std::map<DirectedEdge, size_t> way_of_;
    std::vector<bool> at_seam_; // ways that pass a seam
    std::array<Seam, 2> seams_;
    std::vector<size_t> names_; // of parts, by ways
    size_t corner_name_ = 0;
};

} // namespace nrb::face
