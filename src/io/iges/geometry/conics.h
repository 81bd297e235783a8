// SPDX-License-Identifier: MIT
// Circular arcs (entity 100) and conic arcs (104), which lie in a plane z = ZT of their definition space.
#pragma once

#include "io/iges/geometry/placement.h"
#include "io/iges/record.h"
#include "model/shapes/curve_shape.h"

namespace nrb::io::iges {

// Counterclockwise from one point to another; a full circle if they are equal. The parameter is the angle
// from the x axis. Throws Status::length for a radius of 0, syntax.
model::CurvePiece read_circular_arc(Record &record, const Placement &place);

// The arc of A x^2 + B x y + C y^2 + D x + E y + F = 0 from one point to another; an ellipse is traversed
// counterclockwise, and completely if the points are equal. The coefficients determine the kind, except for
// parabolas (form 3), whose discriminant is rarely exactly 0. The parameter of an ellipse is the eccentric
// angle from the principal axis nearest to x. Throws Status::conic, empty_domain, syntax, not_representable.
model::CurvePiece read_conic_arc(Record &record, const Placement &place, int64_t form);

} // namespace nrb::io::iges
