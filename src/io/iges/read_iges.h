// SPDX-License-Identifier: MIT
// Reading IGES: the curves and surfaces of a file in the fixed-length ASCII form of IGES 5.x.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// Curves and surfaces become splines, as nurbs.h says: B-splines (126, 128) first, then the others except
// those that others are made of, both in the order of the directory. Everything else becomes a note.
//
// Throws Error: Status::truncated (the end is missing), syntax (the structure is broken; the message names
// the line), options. A defect inside one entity becomes a note and does not affect the others.
//
// If the file omits the unit, it is the inch, the default of the standard. If the unit cannot be determined
// (flag 3 with a name that the standard does not list), metres_per_unit is 0 and the coordinates are
// unchanged.
//
// Cost: O(bytes) time and memory, within the limits of io/limits.h; a count stated in the file is trusted
// only if as many values are there. Precondition: begins_iges(bytes), and the settings have been checked.
model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io
