// SPDX-License-Identifier: MIT
// Where sides have to be cut because others end there.
#pragma once

#include "model/sewing/corners.h"

#include <vector>

namespace nrb::model {

struct SideCut {
    double param;
    size_t vertex; // its name when the cut was found; see Corners::now()
};

// The cuts of each side, ascending: at the nearest points to vertices within the tolerance of it that are not
// its own ends. Vertices between which a side would have a piece no larger than the tolerance are merged.
std::vector<std::vector<SideCut>> cuts_of(const std::vector<Side> &sides, Corners &corners, double tolerance);

} // namespace nrb::model
