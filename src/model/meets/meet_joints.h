// SPDX-License-Identifier: MIT
// How the curves in which faces of two models meet go on in each other.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/meets/placed_faces.h"
#include "numeric/vector3.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace nrb::model {

// Places of faces of two models.
struct FacePair {
    size_t a, b;
};

// Joins branches where they end on edges that two faces of a solid, or two that bound none, share: with what goes on there on the other
// face and the same face of the other model, or, where edges of both models cross, on the other face of each. The nearest ones first, if
// they are as near as tolerances and the angle between edge and surface allow. Ends on shared edges that nothing is found for are undecided, but for those of
// what runs along borders of both faces, which is an edge of both.
class MeetJoints {
public:
    // of_branches: the faces that each branch is on.
    MeetJoints(PlacedFaces &a, PlacedFaces &b, const std::vector<FacePair> &of_branches, double tolerance,
               intersect::Meet &meet);

    void run();

private:
    // Where an end is on the border of a face, with another face beyond.
    struct Border {
        int64_t pair; // of uses of an edge, as SharedBorders numbers them
        int64_t coedge;
        double param;
    };
    struct End {
        size_t branch;
        bool begins;
        Vector3 point;
        double room;
        std::array<std::vector<Border>, 2> borders; // on the faces of both models
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
    std::vector<bool> joined_; // ends
};

} // namespace nrb::model
