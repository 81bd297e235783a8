// SPDX-License-Identifier: MIT
// All critical points of the distance from a point to a curve.
#pragma once

#include "closest/locator.h"
#include "pieces/spline_pieces.h"

namespace nrb::closest {

// A query for critical points of a curve.
struct CriticalQuestion {
    const double *point; // [dim]
    Part part;           // of the domain
    double apart;        // neighbouring events at most this far apart are merged; < 0: none are
    int64_t budget;      // most pieces examined
    double within;       // points farther away do not matter
};

// The critical points in the order of their parameters. On a rational piece A / w, with D = A - x w, the
// distance is critical where the polynomial D . (A' w - A w') vanishes; its signs between its zeros determine
// the kinds. The set is certified unless rounding hides a sign. It is marked not unique if the polynomial
// vanishes to rounding on a whole piece, which is then represented by its start.
CriticalSet critical_points(const Spline &curve, const CriticalQuestion &question);

} // namespace nrb::closest
