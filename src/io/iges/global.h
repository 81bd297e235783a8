// SPDX-License-Identifier: MIT
// The global section: delimiters, unit of length, resolution.
#pragma once

#include "io/iges/lines.h"
#include "io/iges/record.h"

namespace nrb::io::iges {

struct Global {
    Delimiters delimiters;
    double metres_per_unit = 0; // of the coordinates in the file; 0: unknown
    double resolution = 0; // least distance that the file tells from none, in its coordinates; 0: not stated
};

// Throws Status::syntax.
Global read_global(const Lines &lines);

} // namespace nrb::io::iges
