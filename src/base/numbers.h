// SPDX-License-Identifier: MIT
// Constants used in bounds of rounding errors.
#pragma once

#include <limits>

namespace nrb::inline base {

inline constexpr double eps = std::numeric_limits<double>::epsilon(); // 2^-52, twice the unit roundoff
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

} // namespace nrb::inline base
