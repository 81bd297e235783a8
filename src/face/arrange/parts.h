// SPDX-License-Identifier: MIT
// The connected parts of a domain that edges of an arrangement bound.
#pragma once

#include "base/disjoint_sets.h"
#include "face/arrange/ways.h"
#include "face/trims/loop_shape.h"

#include <array>
#include <map>

namespace nrb::face {

// The loops of a part: the one around it, and those around its holes.
using PartLoops = std::vector<EdgeLoop>;

// The parts to the left of the half-edges of a border, which bound them completely. The ways, the cyclic
// chains of these half-edges, are united into parts by disjoint sets. A way around a hole belongs to the part
// right above its highest place. The stretch of a seam between two places where the border crosses it belongs
// to the parts of the ways that cross there. Loops that enclose nothing to rounding are left out. Throws
// Status::not_converged where half-edges have no continuation, or rounding hides what is above a hole.
class PartsWithin {
public:
    PartsWithin(const Arrangement &arrangement, const std::vector<DirectedEdge> &border);

    // The name of the part to the left of a half-edge of the border.
    [[nodiscard]] size_t part_left_of(DirectedEdge edge) const { return names_[way_of_.at(edge)]; }
    // around_corner: whether the corner of a domain both of whose axes close is in a part, with loops or not.
    [[nodiscard]] std::vector<PartLoops> list(bool around_corner) const;

private:
    // The stretches of a seam between contacts, each of which is an element of the disjoint sets.
    struct Seam {
        std::vector<SeamContact> contacts; // with edges of the border
        size_t first = 0;                  // the element of the stretch below the first contact
        bool round = false;                // that stretch is also the one above the last contact
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
    std::vector<bool> at_seam_; // by ways: whether they cross a seam
    std::array<Seam, 2> seams_;
    std::vector<size_t> names_; // of parts, by ways
    size_t corner_name_ = 0;
};

} // namespace nrb::face
