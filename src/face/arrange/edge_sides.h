// SPDX-License-Identifier: MIT
// What lies at the sides of the edges of an arrangement.
#pragma once

#include "face/arrange/arrangement.h"

#include <optional>

namespace nrb::face {

// The values of owners, by their numbers, without those that are 0.
struct SideValues {
    PassedSums left, right;
};

// At a place of the edge that is away from all others. Throws Status::not_converged where rounding hides that everywhere.
SideValues values_beside(const Arrangement &arrangement, size_t edge);

} // namespace nrb::face
