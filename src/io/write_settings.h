// SPDX-License-Identifier: MIT
// Settings for the writers of all formats.
#pragma once

namespace nrb::io {

struct WriteSettings {
    double unit = 0; // of the file, in metres; 0: the model's own, millimetres where it has none
    double tolerance =
        0; // distances below it count as none, in units of the file; 0: as fine as the finest face of a part
};

} // namespace nrb::io
