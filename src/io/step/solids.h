// SPDX-License-Identifier: MIT
// The solids of a file with their shells.
#pragma once

#include "io/step/entities.h"

#include <map>

namespace nrb::io::step {

// The place of a face in the solids.
struct PlaceInSolid {
    int64_t solid = -1; // counted from 0 in the order of the instances; -1: in none
    bool in_void = false;
    bool turned = false; // whether its outer normal has to be turned to point out of the material
};

// Places by the numbers of the faces. A face that several solids name belongs to the first of them.
using PlacesInSolids = std::map<int64_t, PlaceInSolid>;

// Reads each MANIFOLD_SOLID_BREP, subtypes included. In a BREP_WITH_VOIDS, the shells of voids are oriented
// so that normals point out of the material. What cannot be read of a solid is reported.
PlacesInSolids read_solids(Entities &entities, const TellError &tell);

} // namespace nrb::io::step
