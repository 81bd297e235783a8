// SPDX-License-Identifier: MIT
// Constraints that are linear equations of control points.
#pragma once

#include "modify/constrain/constrain.h"

namespace nrb::modify {

// See constrain(). Preconditions: all conditions are linear, the weights stay, and some control point may
// move.
Constrained solve_linear(NetState &state, const std::vector<Condition> &conditions, double tolerance);

} // namespace nrb::modify
