// SPDX-License-Identifier: MIT
// The colours of faces.
#pragma once

#include "io/step/entities.h"

#include <array>
#include <map>

namespace nrb::io::step {

// Colours by the numbers of the faces: red, green and blue from 0 to 1.
using Colours = std::map<int64_t, std::array<double, 3>>;

// Reads the styled items. The colour of an item is the first one that its styles have, curve and point styles
// excepted: usually that of the filled area of a side of a surface. It holds for all faces below the item.
// Where several items style a face, the one with the fewest faces counts, so that a style of the face itself
// comes first. What cannot be read of an item is reported.
Colours read_colours(Entities &entities, const TellError &tell);

} // namespace nrb::io::step
