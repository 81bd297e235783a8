// SPDX-License-Identifier: MIT
// All critical points of the distance from a curve.
#pragma once

#include "closest/locator.h"
#include "pieces/spline_pieces.h"

namespace nrb::closest {

// The question about the critical points of a curve.
struct CriticalQuestion {
    const double *point; // [dim]
    Part part;           // of the domain
    double apart;        // neighbours nearer to each other than this are one; < 0: none are
    int64_t budget;      // most pieces examined
    double within;       // points farther away do not matter
};

// In the order of their parameters. With D = A - x w on a piece the distance is critical where D . (A' w - A
// w') is 0; the signs of this polynomial between its zeros determine the kinds. Certified unless rounding
// hides a sign. Not unique if the polynomial vanishes to rounding on a whole piece; the result is then the
// start of the piece.
CriticalSet critical_points(const Spline &curve, const CriticalQuestion &question);

} // namespace nrb::closest
