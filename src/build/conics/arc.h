// SPDX-License-Identifier: MIT
// Arcs of the unit circle as control points: the basis of every conic and of every shape of revolution.
#pragma once

#include "basis/knot_vector.h"
#include "build/conics/angle.h"

#include <cstdint>
#include <vector>

namespace nrb::build {

// How an arc is divided into pieces.
enum ArcForm : int32_t {
    arc_quarters = 0, // degree 2, equal pieces of at most a quarter turn
    arc_thirds,       // degree 2, equal pieces of at most a third of a turn
    arc_smooth,       // one piece, whose weights are positive
};

struct ArcPoint {
    double x; // Cartesian
    double y;
    double weight;
};

struct Arc {
    KnotVectorPtr axis; // over [0, 1]
    std::vector<ArcPoint> points;
};

// The arc (cos a, sin a) in one of the arc_ forms; a full turn ends with its first point. A piece of
// degree 2 and angle d has the weights 1, cos(d / 2), 1. The smooth form beyond a third of a turn: the square
// of the complex polynomial with the Bernstein coefficients 1, e^(i d / 4), e^(i d / 2) over the square of
// its magnitude has the homogeneous points e^(i k d / 4) with the weights 1, c, (2 + cos(d / 2)) / 3, c, 1, c
// = cos(d / 4), which is 0 for the full turn; raised to degree 5 all are positive. Throws Status::form.
Arc unit_arc(const Turn &turn, int32_t form);

// The arc (cosh u, sinh u) from start to end, in pieces of degree 2 and equal lengths in u, at most 2, with
// the weights 1, cosh(d / 2), 1 (the circle's weights at imaginary angles). Values that overflow become
// infinities. Precondition: start < end, both finite. Throws Status::not_representable if end - start
// overflows or is too long for its ends to be finite.
Arc unit_hyperbola(double start, double end);

// Double knots at equal distances between triple ones at 0 and 1.
KnotVectorPtr piecewise_knots(int64_t pieces);

// Throws Status::form unless the form is one of arc_quarters, ..., `last`.
void check_arc_form(int32_t form, int32_t last = arc_smooth);

} // namespace nrb::build
