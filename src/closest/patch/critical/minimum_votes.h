// SPDX-License-Identifier: MIT
// Decides whether a point at which several pieces meet is a minimum: each piece has one vote.
#pragma once

#include "closest/near_points.h"

#include <cstdint>
#include <vector>

namespace nrb::closest {

class MinimumVotes {
public:
    // near: points of `dim` coordinates that are at most this far apart count as one.
    MinimumVotes(int dim, double near) : points_(dim, near) {}

    // The verdict of one face of a piece on a point of it. Kind: a critical_ constant. If several faces of a
    // piece meet at the point, contradicting verdicts leave its vote open, and undecided ones do not count
    // beside others.
    void add(const std::vector<double> &point, int64_t piece, int32_t kind);

    enum class Result { denied, open, certain };
    // Denied if one piece denies the minimum; certain if all pieces that voted confirm it.
    [[nodiscard]] Result result(const std::vector<double> &point) const;

private:
    enum class Answer { no, unknown, yes };
    struct Vote {
        int64_t piece;
        Answer answer;
    };

    NearPoints points_; // of the votes
    std::vector<Vote> votes_;
};

} // namespace nrb::closest
