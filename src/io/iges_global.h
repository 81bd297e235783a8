// The global section: delimiters and the unit of length.
#pragma once

#include "io/iges_lines.h"
#include "io/iges_record.h"

namespace nrb::iges {

struct Global {
    Delimiters delimiters;
    double metres_per_unit = 0; // of the coordinates in the file; 0: unknown
};

// Throws NURBS_ERROR_SYNTAX.
Global read_global(const Lines &lines);

} // namespace nrb::iges
