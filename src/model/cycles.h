// SPDX-License-Identifier: MIT
// Parts that would be placed in themselves.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::model {

// Of each use: whether it leads back to a part on the way to it, so that without these no part is in itself. The parents of all
// uses are parts. Cost: linear in the number of uses.
std::vector<bool> uses_in_cycles(size_t parts, const std::vector<Use> &uses);

} // namespace nrb::model
