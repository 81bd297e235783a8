// SPDX-License-Identifier: MIT
// The global section: delimiters, unit of length, resolution.
#pragma once

#include "io/iges/lines.h"
#include "io/iges/record.h"

#include <string>
#include <string_view>

namespace nrb::io::iges {

// The preprocessor name in files written by this library.
inline constexpr std::string_view own_preprocessor = "libnurbs";

struct Global {
    Delimiters delimiters;
    std::string product;        // as its sender names it
    bool all_digits = false;    // its numbers have all their digits, as this library writes them
    double metres_per_unit = 0; // of the coordinates in the file; 0: unknown
    double resolution = 0; // smallest distance that the file distinguishes from 0, in its unit; 0: not stated
};

// Throws Status::syntax.
Global read_global(const Lines &lines);

} // namespace nrb::io::iges
