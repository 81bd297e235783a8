// SPDX-License-Identifier: MIT
// How large splines may be.
#pragma once

namespace nrb::inline base {

inline constexpr int max_degree = 31; // on any axis
inline constexpr int max_axes = 3;

} // namespace nrb::inline base
