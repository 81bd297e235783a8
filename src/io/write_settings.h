// SPDX-License-Identifier: MIT
// Settings for the writers of all formats.
#pragma once

namespace nrb::io {

struct WriteSettings {
    double unit = 0; // of the file, in metres; 0: that of the model, or millimetres if it has none
    double tolerance =
        0; // distances below it count as 0, in units of the file; 0: the least tolerance of a part's faces
};

} // namespace nrb::io
