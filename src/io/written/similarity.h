// SPDX-License-Identifier: MIT
// Placements as files can state them.
#pragma once

#include "numeric/vector3.h"

#include <array>

namespace nrb::io {

struct Columns {
    Vector3 x, y, z, shift;
};
// m: the rows of a placement.
Columns columns_of(const std::array<double, 12> &m) noexcept;

// The scale of a similarity, negative for a mirror image; 0 for other maps.
double scale_of(const Columns &m) noexcept;
// But for the rounding of placements that others have computed.
bool is_one(double scale) noexcept;
bool is_identity(const std::array<double, 12> &m) noexcept;

} // namespace nrb::io
