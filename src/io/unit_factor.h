// SPDX-License-Identifier: MIT
// From one unit of length to another.
#pragma once

#include "io/read_settings.h"
#include "io/write_settings.h"

namespace nrb::io {

// Of what is read: 1 where the settings leave the unit as it is. `metres_per_unit`: of the file, 0: not known, which cannot be
// converted. Throws Status::options.
double unit_factor(double metres_per_unit, const ReadSettings &settings);

struct Lengths {
    double metres; // of the unit of the file
    double factor; // from the unit of the model
};

// Of what is written. `metres_per_unit`: of the model, 0: not known, which is taken for millimetres. Throws Status::options.
Lengths lengths_of(double metres_per_unit, const WriteSettings &settings);

} // namespace nrb::io
