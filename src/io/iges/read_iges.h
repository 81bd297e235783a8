// SPDX-License-Identifier: MIT
// Reading IGES: the curves and surfaces of a file in the fixed-length ASCII form of IGES 5.x.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// Curves and surfaces become splines in the order of the directory, but for those that others are made of, as nurbs.h
// says; everything else becomes a note. Throws
// Error: Status::truncated (the end is missing), syntax (the structure is broken; the message names the
// line), options. What is wrong inside one entity becomes a note and does not affect the others. A unit that
// the file leaves out is the inch, the default of the standard. A unit that cannot be known (flag 3 with a
// name that the standard does not list) leaves metres_per_unit 0 and the coordinates unchanged. Cost:
// O(bytes) time and memory, within the limits of io/limits.h; a count stated in the file is believed only if as many values are there.
// Precondition: begins_iges(bytes), and the settings have been checked.
model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io
