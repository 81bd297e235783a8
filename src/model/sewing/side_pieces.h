// SPDX-License-Identifier: MIT
// The pieces of sides between their cuts, and which of them form one edge.
#pragma once

#include "model/sewing/side_cuts.h"

#include <map>
#include <optional>
#include <vector>

namespace nrb::model {

struct SidePiece {
    size_t side;
    Interval range; // of the parameter of the side
    bool whole;     // the whole side, which is kept as it is
    std::array<size_t, 2> vertices;
    SplinePtr image;
    bool collapsed; // no larger than the tolerance
    // The piece whose curve is that of the edge; possibly this one.
    size_t leader;
    bool against = false; // whether the two run in opposite directions
    // The distance, both ways, between the curve of the leader and the exact image of this piece on its
    // surface.
    double gap = 0;
};

// Cuts the sides and matches the pieces. These are in the order of sides and parameters.
class SidePieces {
public:
    SidePieces(const std::vector<Side> &sides, const std::vector<std::vector<SideCut>> &cuts,
               Corners &corners, double tolerance);

    [[nodiscard]] const std::vector<SidePiece> &all() const noexcept { return pieces_; }
    // The cuts that are needed. A cut is dropped where the pieces of one edge continue, one by one, in those
    // of another edge.
    [[nodiscard]] std::vector<std::vector<SideCut>> needed(std::vector<std::vector<SideCut>> cuts) const;
    // For each side, whether a piece has fewer partners than one of its parts had. `parts` are pieces of the
    // same sides, with more cuts.
    [[nodiscard]] std::vector<bool> fewer_than(const SidePieces &parts, size_t sides) const;

private:
    void add_side(const Side &side, size_t number, const std::vector<SideCut> &cuts, Corners &corners,
                  double tolerance);
    [[nodiscard]] std::map<std::array<size_t, 2>, std::vector<size_t>> by_ends() const;
    void match_pieces(const std::vector<size_t> &alike, const std::vector<Side> &sides, double tolerance);
    void set_members();
    [[nodiscard]] size_t size_of_group(const SidePiece &piece) const { return members_[piece.leader].size(); }
    [[nodiscard]] std::optional<size_t> beyond(size_t piece, size_t vertex) const;
    [[nodiscard]] bool goes_on(size_t piece, size_t next, size_t vertex) const;

    std::vector<SidePiece> pieces_;
    std::vector<std::vector<size_t>> members_; // indexed by leader
};

} // namespace nrb::model
