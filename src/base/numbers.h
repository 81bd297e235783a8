// SPDX-License-Identifier: MIT
// Numbers that bounds of rounding errors are made of.
#pragma once

#include <limits>

namespace nrb::inline base {

inline constexpr double eps = std::numeric_limits<double>::epsilon(); // 2^-52, twice the unit roundoff
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

} // namespace nrb::inline base
