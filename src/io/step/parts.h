// SPDX-License-Identifier: MIT
// Finds the curves and surfaces that are parts of others.
#pragma once

#include "io/step/structure/instances.h"

#include <vector>

namespace nrb::io::step {

// One flag for each place in instances.all(): whether the instance is a part of another shape, an edge, a
// face, or a parameter plane. An instance that is a part only of its own parts is not flagged, so that it is
// read on its own and the cycle is reported.
std::vector<bool> find_parts(const Instances &instances);

} // namespace nrb::io::step
