// SPDX-License-Identifier: MIT
// Arcs of circles (entity 100) and of conics (104), which lie in a plane z = ZT of their definition space.
#pragma once

#include "io/iges/geometry/placement.h"
#include "io/iges/record.h"
#include "model/shapes/curve_shape.h"

namespace nrb::io::iges {

// Counterclockwise from one point to another, all around if they are equal. The parameter is the angle from the x axis.
// Throws Status::length for a radius of 0, syntax.
model::CurvePiece read_circular_arc(Record &record, const Placement &place);

// Of A x^2 + B x y + C y^2 + D x + E y + F = 0 from one point to another: an ellipse counterclockwise, all around if
// they are equal. The coefficients decide about the kind, but for parabolas (form 3), whose discriminant is seldom 0 to
// the bit. The parameter of an ellipse is the eccentric angle from the axis next to x. Throws Status::conic, empty_domain,
// syntax, not_representable.
model::CurvePiece read_conic_arc(Record &record, const Placement &place, int64_t form);

} // namespace nrb::io::iges
