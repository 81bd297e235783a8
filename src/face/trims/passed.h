// SPDX-License-Identifier: MIT
// What is passed of loops on a way through a domain.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb::face {

struct PassedSum {
    int32_t loop;
    int value;
    friend bool operator==(const PassedSum &, const PassedSum &) = default;
};
using PassedSums = std::vector<PassedSum>; // of the loops of which something was passed

// Sorted, with one entry for each loop.
PassedSums summed(PassedSums sums);

} // namespace nrb::face
