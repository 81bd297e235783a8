// SPDX-License-Identifier: MIT
// Which uses of parts a model keeps, and which it adds.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::model {

// Drops the uses by which a part would be placed in itself, and returns their indices, ascending.
// Precondition: the parents of all uses are parts.
std::vector<size_t> drop_cycles(size_t parts, std::vector<Use> &uses);

// Adds a use in the whole for each part that no use places.
void place_the_rest(size_t parts, std::vector<Use> &uses);

} // namespace nrb::model
