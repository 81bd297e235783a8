// SPDX-License-Identifier: MIT
// Limits on the size of splines.
#pragma once

namespace nrb::inline base {

inline constexpr int max_degree = 31; // on any axis
inline constexpr int max_axes = 3;

} // namespace nrb::inline base
