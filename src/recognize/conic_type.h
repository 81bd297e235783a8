// SPDX-License-Identifier: MIT
// The kinds of conics.
#pragma once

#include <cstdint>

namespace nrb::recognize {

enum ConicType : int32_t {
    conic_ellipse = 1,
    conic_parabola,
    conic_hyperbola,
    conic_chord, // shape factor 0: the segment P0 P2
    conic_legs,  // shape factor infinite: the segments P0 P1 and P1 P2
    conic_line,  // P0, P1 and P2 are on a line
};

} // namespace nrb::recognize
