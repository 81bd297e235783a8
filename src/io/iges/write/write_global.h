// SPDX-License-Identifier: MIT
// The global section as it is written.
#pragma once

#include "io/iges/write/file_text.h"

#include <string>

namespace nrb::io::iges {

struct GlobalFacts {
    std::string product;
    double metres;     // of the unit of length
    double resolution; // distances that are less than it count as none, in that unit
    double extent;     // no coordinate is larger; 0: not stated
};

// Without a date, a place and other names, so that the same model is the same file. A unit that has no number is one of them in another
// model space scale.
Parameters write_global(const GlobalFacts &facts);

} // namespace nrb::io::iges
