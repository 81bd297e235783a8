// SPDX-License-Identifier: MIT
// Joins the sections of faces across shared edges and corners.
#pragma once

#include "model/sections/face_sections.h"

#include <span>

namespace nrb::model {

// Joins branches where they end on edges that two faces of one solid share, or two faces that bound none. On
// an edge, ends are matched in their order along it: each with the next end of the other face that has the
// opposite direction and is within the rooms of both. At a corner, an end and a beginning are joined if there
// is exactly one of each; a branch that begins and ends at the corner and stays near it is dropped. An end on
// a shared edge that finds no continuation becomes an undecided node.
class SectionJoints {
public:
    SectionJoints(const Model &model, const SharedBorders &borders, const std::vector<Placement> &placements,
                  std::span<const Vector3> normals, FaceSections &sections);

    void run();

private:
    // An end, keyed by its edge and ordered along it, or keyed by its corner.
    struct Item {
        std::array<int64_t, 4> key;
        double order;
        size_t end;
    };
    void join_on_edges();
    void join_on_edge(std::span<const Item> items);
    void join_in_order(std::span<const Item> a, std::span<const Item> b);
    void join_at_corners();
    void join_at_corner(std::span<const Item> items);
    void join_in_touches();
    void tell_open_ends();
    void join(size_t a, size_t b);

    [[nodiscard]] bool fit(size_t a, size_t b) const;
    [[nodiscard]] double slope(const SectionEnd &end) const;
    [[nodiscard]] int64_t corner_near(const SectionEnd &end) const;
    [[nodiscard]] Vector3 point_on(const SectionEnd &end, int64_t coedge, double param) const;
    [[nodiscard]] const intersect::MeetBranch &branch_of(const SectionEnd &end) const noexcept {
        return sections_.meet.branches[static_cast<size_t>(end.branch)];
    }
    [[nodiscard]] int64_t &node_of(const SectionEnd &end) const noexcept {
        return sections_.meet.branches[static_cast<size_t>(end.branch)].nodes[end.begins ? 0 : 1];
    }
    [[nodiscard]] bool is_short(const SectionEnd &end) const;
    [[nodiscard]] bool is_open(const SectionEnd &end) const noexcept;
    [[nodiscard]] const face::Coedge &coedge_of(int64_t number) const;

    const Model &model_;
    const SharedBorders &borders_;
    const std::vector<Placement> &placements_; // indexed by instance
    std::span<const Vector3> normals_;         // of the planes, scaled to about 1
    FaceSections &sections_;
    std::vector<bool> joined_, dropped_; // indexed by end, and by branch
};

} // namespace nrb::model
