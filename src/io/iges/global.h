// SPDX-License-Identifier: MIT
// The global section: delimiters, unit of length, resolution.
#pragma once

#include "io/iges/lines.h"
#include "io/iges/record.h"

#include <string>
#include <string_view>

namespace nrb::io::iges {

// How files that this library writes call their preprocessor.
inline constexpr std::string_view own_preprocessor = "libnurbs";

struct Global {
    Delimiters delimiters;
    std::string product; // how its sender calls it
    bool all_digits =
        false; // whether its numbers are written with all digits that they have, as this library does
    double metres_per_unit = 0; // of the coordinates in the file; 0: unknown
    double resolution = 0; // least distance that the file tells from none, in its coordinates; 0: not stated
};

// Throws Status::syntax.
Global read_global(const Lines &lines);

} // namespace nrb::io::iges
