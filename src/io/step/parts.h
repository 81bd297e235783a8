// SPDX-License-Identifier: MIT
// Which curves and surfaces others are made of.
#pragma once

#include "io/step/structure/instances.h"

#include <vector>

namespace nrb::io::step {

// One flag for each place in instances.all(): it is a part of another shape, an edge, a face, or a parameter plane. What
// is a part only of what is its own part in turn is none, so that it is read on its own and somebody hears of the cycle.
std::vector<bool> find_parts(const Instances &instances);

} // namespace nrb::io::step
