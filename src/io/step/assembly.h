// SPDX-License-Identifier: MIT
// The parts of a file and where they are placed.
#pragma once

#include "io/step/entities.h"
#include "model/model.h"

#include <functional>
#include <string>
#include <vector>

namespace nrb::io::step {

// What is wrong with an instance that places a part.
struct PlacementDamage {
    int64_t number;
    Status reason;
    std::string text;
};

struct Assembly {
    std::vector<model::ModelPart> parts;
    std::vector<model::Use> uses;
    std::vector<int64_t> part_of; // of each instance of geometry or topology, by its place
    std::vector<PlacementDamage> damages;
};

// A part is a shape representation, with those that relationships without a transformation equate to it, under the name of its
// product. Parts are placed by relationships with a transformation and by mapped items; those that nothing places stand in the
// whole. What belongs to no representation is in a part of its own. Placements are in the unit of the model: `length(place)` is the
// factor of the unit of an instance. Uses that would put a part into itself are told and left out. Cost: linear in the size of the
// file, whatever the parts would be if they were multiplied.
Assembly read_assembly(Entities &entities, const std::function<double(int64_t place)> &length);

} // namespace nrb::io::step
