// SPDX-License-Identifier: MIT
// Finds the instances of which items consist.
#pragma once

#include "io/step/entities.h"

#include <vector>

namespace nrb::io::step {

// The numbers of the instances below some items whose kinds are wanted. The search follows references through
// topology, shape representations, and the kinds for which `opened` is true. It does not go below an instance
// that is wanted.
std::vector<int64_t> found_below(Entities &entities, std::vector<int64_t> items, bool (*wanted)(Kind),
                                 bool (*opened)(Kind));

} // namespace nrb::io::step
