// SPDX-License-Identifier: MIT
// Decoding of evaluation flags.
#pragma once

#include "eval/parameters.h"

namespace nrb::capi {

// The rule of each axis. Throws Status::flags for unknown bits, for bits of axes that the spline lacks, and
// for modes that exclude each other.
eval::AxisRules decode_rules(uint32_t flags, int axes);

} // namespace nrb::capi
