// SPDX-License-Identifier: MIT
// How the sections of faces go on in each other.
#pragma once

#include "model/sections/face_sections.h"

#include <span>

namespace nrb::model {

// Joins branches where they end on edges that two faces of a solid, or two that bound none, share: in the order along the edge, each to
// the next one of the other face that goes on there and is as near as both say; and at corners, where just one ends and one begins.
// What has its way through a corner within the room is left out. Ends on shared edges that nothing is found for are undecided.
class SectionJoints {
public:
    SectionJoints(const Model &model, const SharedBorders &borders, const std::vector<Placement> &placements,
                  std::span<const Vector3> normals, FaceSections &sections);

    void run();

private:
    // An end with its place in the order along the edge, or with its corner.
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
    const std::vector<Placement> &placements_; // of instances
    std::span<const Vector3> normals_;         // of planes, about 1
    FaceSections &sections_;
    std::vector<bool> joined_, dropped_; // ends, branches
};

} // namespace nrb::model
