// SPDX-License-Identifier: MIT
// Drops intersection curves that only repeat the border of a region that two faces share.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/meets/meet_joints.h"

#include <vector>

namespace nrb::model {

// Let a face have a region in common with a face of the other model. Where a neighbour of the latter ends on
// the border of the region, it also meets the former, in a curve along that border. This drops the crossing
// branches that run from end to end along borders of regions on either of their faces. of_branches: for each
// branch, the faces on which it lies; its entries are dropped likewise.
void drop_along_regions(double tolerance, std::vector<FacePair> &of_branches, intersect::Meet &meet);

} // namespace nrb::model
