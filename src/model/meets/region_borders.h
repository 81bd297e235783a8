// SPDX-License-Identifier: MIT
// What runs along borders of regions that faces of two models share.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/meets/meet_joints.h"

#include <vector>

namespace nrb::model {

// Leaves out curves in which a face meets a neighbour of one that it has a region in common with, where they run along the border
// of that from end to end: there the neighbour ends. of_branches: the faces that each branch is on, likewise.
void drop_along_regions(double tolerance, std::vector<FacePair> &of_branches, intersect::Meet &meet);

} // namespace nrb::model
