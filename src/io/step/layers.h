// SPDX-License-Identifier: MIT
// The layers of faces, curves and surfaces.
#pragma once

#include "io/step/entities.h"

#include <map>
#include <string>
#include <vector>

namespace nrb::io::step {

struct Layers {
    std::vector<std::string> names; // in the order of the instances; equal names are one layer
    std::map<int64_t, std::vector<int64_t>>
        of; // by the numbers of faces, curves and surfaces: indices of names, ascending

    [[nodiscard]] std::vector<int64_t> at(int64_t number) const;
};

// Reads the PRESENTATION_LAYER_ASSIGNMENTs. The layers of an item hold for everything of which it consists.
// What cannot be read of an assignment is reported.
Layers read_layers(Entities &entities, const TellError &tell);

} // namespace nrb::io::step
