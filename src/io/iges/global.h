// SPDX-License-Identifier: MIT
// The global section: delimiters and the unit of length.
#pragma once

#include "io/iges/lines.h"
#include "io/iges/record.h"

namespace nrb::io::iges {

struct Global {
    Delimiters delimiters;
    double metres_per_unit = 0; // of the coordinates in the file; 0: unknown
};

// Throws Status::syntax.
Global read_global(const Lines &lines);

} // namespace nrb::io::iges
