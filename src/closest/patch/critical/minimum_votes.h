// SPDX-License-Identifier: MIT
// Whether a point that several pieces meet in is a minimum: each piece has a vote.
#pragma once

#include "closest/near_points.h"

#include <cstdint>
#include <vector>

namespace nrb::closest {

class MinimumVotes {
public:
    // Points of `dim` coordinates that are nearer to each other than `near` are one.
    MinimumVotes(int dim, double near) : points_(dim, near) {}

    // What one face of a piece says of a point of it. Kind: a critical_ constant. A piece may have several
    // faces there. Faces that contradict each other leave its vote open; one that decides nothing does not
    // count beside others.
    void add(const std::vector<double> &point, int64_t piece, int32_t kind);

    enum class Result { denied, open, certain };
    // Denied by one piece, or certain to all pieces that have a vote.
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
