// SPDX-License-Identifier: MIT
// The assembly structure of a file: its parts, and where they are placed.
#pragma once

#include "io/step/entities.h"
#include "model/model.h"

#include <functional>
#include <string>
#include <vector>

namespace nrb::io::step {

// An error in an instance of the assembly structure, and the number of that instance.
struct PlacementDamage {
    int64_t number;
    Status reason;
    std::string text;
};

struct Assembly {
    std::vector<model::ModelPart> parts;
    std::vector<model::Use> uses;
    std::vector<int64_t> part_of; // by place: the part of an instance of geometry or topology
    std::vector<PlacementDamage> damages;
};

// Reads the parts and their uses. A part is a shape representation, together with those that relationships
// without a transformation equate to it. It has the name of its product. Parts are placed by relationships
// with a transformation and by mapped items; a part that nothing places is placed in the whole. If faces
// belong to no representation, a part of their own is added for all that belongs to none. Placements are in
// the unit of the model: `length(place)` is the factor to it from the unit of an instance, whose place is its
// index in Instances::all(). A use that would place a part in itself is left out and reported. Cost: linear
// in the size of the file, however large the expanded assembly would be.
Assembly read_assembly(Entities &entities, const std::function<double(int64_t place)> &length);

} // namespace nrb::io::step
