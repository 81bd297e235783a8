// SPDX-License-Identifier: MIT
// The colours of faces.
#pragma once

#include "io/step/entities.h"

#include <array>
#include <map>

namespace nrb::io::step {

// By the numbers of the faces: red, green and blue from 0 to 1.
using Colours = std::map<int64_t, std::array<double, 3>>;

// Of styled items: the colour of the filled area of a side of a surface, which holds for all faces below the item, unless one of
// them has a style of its own. What cannot be read of an item is told.
Colours read_colours(Entities &entities, const TellError &tell);

} // namespace nrb::io::step
