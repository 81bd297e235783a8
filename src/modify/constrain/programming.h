// SPDX-License-Identifier: MIT
// Constraints that are not linear equations, by sequential quadratic programming.
#pragma once

#include "modify/constrain/constrain.h"

namespace nrb::modify {

// See constrain(). Precondition: something may change.
Constrained solve_by_programming(NetState &state, const std::vector<Condition> &conditions, double tolerance);

} // namespace nrb::modify
