// SPDX-License-Identifier: MIT
// Arcs of the unit circle and the unit hyperbola as control points, from which conics and shapes of
// revolution are made.
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
    arc_smooth,       // one piece with positive weights
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

// The arc (cos a, sin a), with a over the turn, in one of the arc_ forms. A full turn ends in its first
// point, bit for bit. A piece of degree 2 and angle d has the weights 1, cos(d / 2), 1.
//
// The smooth form of a turn of angle d beyond a third of a turn: let q be the complex polynomial with the
// Bernstein coefficients 1, e^(i d / 4), e^(i d / 2). Then q^2 / |q|^2 is on the unit circle and runs over
// the angle d. Its numerator has the Bernstein coefficients e^(i k d / 4), k = 0, ..., 4, and its denominator
// 1, c, (2 + cos(d / 2)) / 3, c, 1 with c = cos(d / 4), which is 0 for the full turn. Raised to degree 5, all
// weights are positive. Throws Status::form.
Arc unit_arc(const Turn &turn, int32_t form);

// The arc (cosh u, sinh u) for u from start to end, in pieces of degree 2 that have equal lengths d in u, at
// most 2. A piece has the weights 1, cosh(d / 2), 1, which are those of the circle at an imaginary angle.
// Coordinates that overflow become infinite. Precondition: start < end, both finite. Throws
// Status::not_representable if end - start overflows or is too long for both ends to be finite.
Arc unit_hyperbola(double start, double end);

// The knots of quadratic pieces over [0, 1]: triple at both ends, double and evenly spaced between them.
KnotVectorPtr piecewise_knots(int64_t pieces);

// Throws Status::form unless the form is one of arc_quarters, ..., `last`.
void check_arc_form(int32_t form, int32_t last = arc_smooth);

} // namespace nrb::build
