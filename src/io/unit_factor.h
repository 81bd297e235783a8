// SPDX-License-Identifier: MIT
// Conversion from one unit of length to another.
#pragma once

#include "io/read_settings.h"
#include "io/write_settings.h"

namespace nrb::io {

// The factor for what is read; 1 where the settings leave the unit as it is. `metres_per_unit`: that of the
// file; 0: not known, and then no other unit can be reached. Throws Status::options for a unit that cannot be
// reached.
double unit_factor(double metres_per_unit, const ReadSettings &settings);

struct Lengths {
    double metres; // of the unit of the file
    double factor; // from the unit of the model to that of the file
};

// The unit and the factor for what is written. `metres_per_unit`: that of the model; 0: not known, and then
// millimetres are assumed. Throws Status::options for a unit that cannot be reached.
Lengths lengths_of(double metres_per_unit, const WriteSettings &settings);

} // namespace nrb::io
