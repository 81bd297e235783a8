// SPDX-License-Identifier: MIT
// What is passed of loops on a way through a domain.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb::face {

struct PassedSum {
    int32_t loop;
    int value;
};
using PassedSums = std::vector<PassedSum>; // of the loops of which something was passed

} // namespace nrb::face
