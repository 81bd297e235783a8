// SPDX-License-Identifier: MIT
// The layers of faces, and of curves and surfaces.
#pragma once

#include "io/step/entities.h"

#include <map>
#include <string>
#include <vector>

namespace nrb::io::step {

struct Layers {
    std::vector<std::string> names; // in the order of the instances; equal ones are one
    std::map<int64_t, std::vector<int64_t>>
        of; // by the numbers of faces, curves and surfaces: indices of names, rising

    [[nodiscard]] std::vector<int64_t> at(int64_t number) const;
};

// Of PRESENTATION_LAYER_ASSIGNMENTs: those of an item hold for all that it consists of. What cannot be read of one is told.
Layers read_layers(Entities &entities, const TellError &tell);

} // namespace nrb::io::step
