// SPDX-License-Identifier: MIT
// Finds uses by which a part would be placed in itself.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::model {

// For each use, whether it leads back to a part on the way to it (a back edge of a depth-first search).
// Without these uses no part contains itself. Precondition: the parents of all uses are parts. Cost: linear
// in the number of uses.
std::vector<bool> uses_in_cycles(size_t parts, const std::vector<Use> &uses);

} // namespace nrb::model
