// SPDX-License-Identifier: MIT
// Where sides have to be cut because others end there.
#pragma once

#include "model/sewing/corners.h"

#include <vector>

namespace nrb::model {

struct SideCut {
    double param;
    size_t vertex; // one at the time when the cut was found
};

// Of each side, rising: where a vertex is no farther from it than the tolerance, and none of its own ends. Vertices between which
// a side would have a piece no larger than the tolerance become one.
std::vector<std::vector<SideCut>> cuts_of(const std::vector<Side> &sides, Corners &corners, double tolerance);

} // namespace nrb::model
