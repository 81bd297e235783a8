// SPDX-License-Identifier: MIT
// The solids of a file with their shells.
#pragma once

#include "io/step/entities.h"

#include <map>

namespace nrb::io::step {

// Where a face is in the solids.
struct PlaceInSolid {
    int64_t solid = -1; // counted from 0 in the order of the instances; -1: in none
    bool in_void = false;
    bool turned = false; // the material is on the side of its outer normal, unless that is turned
};

// By the numbers of the faces; the first solid has a face that several name. What cannot be read of a solid is told.
using PlacesInSolids = std::map<int64_t, PlaceInSolid>;

// MANIFOLD_SOLID_BREP and its subtypes; voids of BREP_WITH_VOIDS are oriented so that normals point out of the material.
PlacesInSolids read_solids(Entities &entities, const TellError &tell);

} // namespace nrb::io::step
