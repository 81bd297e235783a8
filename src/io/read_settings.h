// SPDX-License-Identifier: MIT
// Settings for the readers of all formats.
#pragma once

#include <cstdint>

namespace nrb::io {

// What to read, as bits.
inline constexpr uint32_t kind_curves = 1, kind_surfaces = 2, kind_faces = 4, all_kinds = 7;

struct ReadSettings {
    double unit = 0; // unit of the result in metres; 0: that of the file
    int64_t max_bytes = int64_t{1} << 30;
    double tolerance = 0; // in the unit of the result; 0: what the file states
    uint32_t kinds = all_kinds;

    [[nodiscard]] bool wants(uint32_t kind) const noexcept { return (kinds & kind) != 0; }
};

} // namespace nrb::io
