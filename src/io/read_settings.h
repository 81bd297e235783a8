// SPDX-License-Identifier: MIT
// Settings for the readers of all formats.
#pragma once

#include <cstdint>

namespace nrb::io {

struct ReadSettings {
    double unit = 0; // wanted unit in metres, 0: the file's own
    int64_t max_bytes = int64_t{1} << 30;
    double tolerance = 0; // in the unit of the result, 0: what the file states
};

} // namespace nrb::io
