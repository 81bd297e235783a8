// SPDX-License-Identifier: MIT
// Signed crossings of loops by a ray through a domain.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb::face {

struct PassedSum {
    int32_t loop;
    int value;
    friend bool operator==(const PassedSum &, const PassedSum &) = default;
};
using PassedSums = std::vector<PassedSum>; // of the loops that were crossed

// Sorted by loops, with one entry for each loop.
PassedSums summed(PassedSums sums);

} // namespace nrb::face
