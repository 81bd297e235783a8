// SPDX-License-Identifier: MIT
// Writes the global section.
#pragma once

#include "io/iges/write/file_text.h"

#include <string>

namespace nrb::io::iges {

struct GlobalFacts {
    std::string product;
    double metres;     // of the unit of length
    double resolution; // smaller distances count as 0; in that unit
    double extent;     // upper bound of the coordinates; 0: not stated
};

// Writes no date, place or other names, so that the same model gives the same file. A unit without a flag is
// expressed as one that has a flag, with a model space scale.
Parameters write_global(const GlobalFacts &facts);

} // namespace nrb::io::iges
