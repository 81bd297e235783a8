// SPDX-License-Identifier: MIT
// Joins the intersection curves of faces of two models across the edges that faces share.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/meets/placed_faces.h"
#include "numeric/vector3.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace nrb::model {

// Two faces that meet: indices into PlacedFaces::places() of either model.
struct FacePair {
    size_t a, b;
};

// Joins branches where they end on an edge that two faces of one solid share, or two faces that bound none. A
// branch continues on the other face of the edge with the same face of the other model or, where edges of
// both models cross, on the other face of each. Of the pairs of an end and a beginning the nearest are joined
// first; their distance must be within what the tolerances and the angle between edge and surface allow. An
// end on a shared edge that finds no continuation becomes an undecided node, unless its branch runs along the
// borders of both faces: then the branch is an edge of both models, even if its other end was joined.
class MeetJoints {
public:
    // of_branches: for each branch, the faces on which it lies.
    MeetJoints(PlacedFaces &a, PlacedFaces &b, const std::vector<FacePair> &of_branches, double tolerance,
               intersect::Meet &meet);

    void run();

private:
    // The place of an end on a border of its face, beyond which another face continues.
    struct Border {
        int64_t pair; // of uses of an edge, as numbered by SharedBorders
        int64_t coedge;
        double param;
    };
    struct End {
        size_t branch;
        bool begins;
        Vector3 point;
        double room;
        std::array<std::vector<Border>, 2> borders; // on the faces of either model
    };
    struct Match {
        double apart;
        size_t from, to;
    };

    void add_ends();
    void add_end(size_t branch, bool begins);
    [[nodiscard]] std::vector<Border> borders_at(size_t model, size_t place, const intersect::MeetNode &node);
    void add_matches();
    void match_on_edge(const std::vector<size_t> &ends);
    void join(const Match &match);
    void tell_open_ends();
    [[nodiscard]] bool is_common_edge(size_t branch) const;

    [[nodiscard]] bool fit(const End &a, const End &b) const;
    [[nodiscard]] bool crosses(const End &a, const End &b, size_t model) const;
    [[nodiscard]] double slope(const End &end) const;
    [[nodiscard]] size_t place_of(const End &end, size_t model) const noexcept {
        const FacePair &pair = of_branches_[end.branch];
        return model == 0 ? pair.a : pair.b;
    }
    [[nodiscard]] int64_t &node_of(const End &end) const noexcept {
        return meet_.branches[end.branch].nodes[end.begins ? 0 : 1];
    }

    std::array<PlacedFaces *, 2> models_;
    const std::vector<FacePair> &of_branches_;
    double tolerance_;
    intersect::Meet &meet_;
    std::vector<End> ends_;
    std::vector<Match> matches_;
    std::vector<bool> joined_; // indexed by end
};

} // namespace nrb::model
