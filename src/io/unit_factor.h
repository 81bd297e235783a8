// SPDX-License-Identifier: MIT
// From the unit of a file to the one that is wanted.
#pragma once

#include "io/read_settings.h"

namespace nrb::io {

// 1 where the settings leave the unit as it is. `metres_per_unit`: of the file, 0: not known, which cannot be converted. Throws
// Status::options.
double unit_factor(double metres_per_unit, const ReadSettings &settings);

} // namespace nrb::io
