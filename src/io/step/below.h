// SPDX-License-Identifier: MIT
// What items consist of.
#pragma once

#include "io/step/entities.h"

#include <vector>

namespace nrb::io::step {

// The numbers of the instances of some kinds in items, through topology and representations, and through the kinds that are opened
// besides.
std::vector<int64_t> found_below(Entities &entities, std::vector<int64_t> items, bool (*wanted)(Kind),
                                 bool (*opened)(Kind));

} // namespace nrb::io::step
