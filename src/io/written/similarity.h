// SPDX-License-Identifier: MIT
// Placements as similarities, the maps that files can state.
#pragma once

#include "numeric/vector3.h"

#include <array>

namespace nrb::io {

struct Columns {
    Vector3 x, y, z, shift;
};
// `m`: the rows of (M | t) of a placement.
Columns columns_of(const std::array<double, 12> &m) noexcept;

// The scale of a similarity, to rounding; negative for a mirror image, 0 for any other map.
double scale_of(const Columns &m) noexcept;
// Whether a scale is 1, but for the rounding of placements that other programs have computed.
bool is_one(double scale) noexcept;
bool is_identity(const std::array<double, 12> &m) noexcept;

} // namespace nrb::io
