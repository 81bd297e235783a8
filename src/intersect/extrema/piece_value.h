// SPDX-License-Identifier: MIT
// Values of scalar splines on single pieces.
#pragma once

#include "pieces/derivative_pieces.h"

namespace nrb::intersect {

// The value at local parameters in [0, 1], one for each axis of the spline.
double value_of(const pieces::HomogeneousPiece &piece, const std::array<double, max_axes> &place);

} // namespace nrb::intersect
