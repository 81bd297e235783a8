// SPDX-License-Identifier: MIT
// The flags of evaluation, decoded.
#pragma once

#include "eval/parameters.h"

namespace nrb::capi {

// Throws Status::flags for unknown bits, bits of missing axes and modes that exclude each other.
eval::AxisRules decode_rules(uint32_t flags, int axes);

} // namespace nrb::capi
