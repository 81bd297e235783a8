// SPDX-License-Identifier: MIT
// Which uses of parts a model keeps.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::model {

// Leaves out the uses that would put a part into itself, and returns which they were, by rising index. The parents of all uses are
// parts.
std::vector<size_t> drop_cycles(size_t parts, std::vector<Use> &uses);

// Parts that nothing places stand in the whole.
void place_the_rest(size_t parts, std::vector<Use> &uses);

} // namespace nrb::model
