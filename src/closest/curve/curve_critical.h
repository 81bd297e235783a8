// All critical points of the distance from a curve.
#pragma once

#include "closest/locator.h"
#include "pieces/spline_pieces.h"

namespace nrb::closest {

// What is asked of the critical points of a curve.
struct CriticalQuestion {
    const double *point; // [dim]
    Part part;           // of the domain
    double apart;        // neighbours that are nearer to each other are one; < 0: none are
    int64_t budget;      // most pieces looked at
    double within;       // no interest in points that are farther away
};

// In the order of their parameters. With D = A - x w on a piece the distance is critical where D . (A' w - A
// w') is 0; the signs of this polynomial between its zeros tell the kinds. Certified unless rounding hides a
// sign; not unique where the polynomial vanishes to rounding on a whole piece, which gives its start.
CriticalSet critical_points(const Spline &curve, const CriticalQuestion &question);

} // namespace nrb::closest
