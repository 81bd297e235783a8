// SPDX-License-Identifier: MIT
// Names of the room `pieces` that the search for nearest points on surfaces and volumes uses in every file.
#pragma once

#include "pieces/tree/piece_grid.h"

namespace nrb::closest {

using pieces::AxisValues;
using pieces::PatchShape;
using pieces::PieceGrid;

} // namespace nrb::closest
