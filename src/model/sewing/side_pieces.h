// SPDX-License-Identifier: MIT
// The pieces between the cuts of sides, and which of them are one edge.
#pragma once

#include "model/sewing/side_cuts.h"

#include <map>
#include <optional>
#include <vector>

namespace nrb::model {

struct SidePiece {
    size_t side;
    Interval range; // of the parameter of the side
    bool whole;     // all of the side, which is left as it is
    std::array<size_t, 2> vertices;
    SplinePtr image;
    bool collapsed; // no larger than the tolerance
    // Of an edge with the curve of a piece that leads, which may be this one.
    size_t leader;
    bool against = false; // whether the two run in opposite directions
    double gap = 0;       // from the curve of the leader, both ways
};

// In the order of sides and parameters.
class SidePieces {
public:
    SidePieces(const std::vector<Side> &sides, const std::vector<std::vector<SideCut>> &cuts,
               Corners &corners, double tolerance);

    [[nodiscard]] const std::vector<SidePiece> &all() const noexcept { return pieces_; }
    // The cuts without those at which each piece of an edge goes on with a piece of one other edge.
    [[nodiscard]] std::vector<std::vector<SideCut>> needed(std::vector<std::vector<SideCut>> cuts) const;

private:
    void add_side(const Side &side, size_t number, const std::vector<SideCut> &cuts, Corners &corners,
                  double tolerance);
    [[nodiscard]] std::map<std::array<size_t, 2>, std::vector<size_t>> by_ends() const;
    void match_pieces(const std::vector<size_t> &alike, const std::vector<Side> &sides, double tolerance);
    void set_members();
    [[nodiscard]] std::optional<size_t> beyond(size_t piece, size_t vertex) const;
    [[nodiscard]] bool goes_on(size_t piece, size_t next, size_t vertex) const;

    std::vector<SidePiece> pieces_;
    std::vector<std::vector<size_t>> members_; // of each leader
};

} // namespace nrb::model
