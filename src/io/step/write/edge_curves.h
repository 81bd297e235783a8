// SPDX-License-Identifier: MIT
// As which curves an edge is written.
#pragma once

#include "face/face.h"
#include "model/model.h"

namespace nrb::io::step {

// The curve of an edge between its vertices, so that reading gives the same spline: what the edge was in a file if the part of that
// between the vertices is the edge, bit for bit, else its spline.
model::CurvePiece stated_piece(const model::Edge &edge, const Vector3 &start, const Vector3 &end,
                               double tolerance);

// The curve of a coedge in the domain of its face, over the parameters of the curve of its edge as that is written; null where it is
// not under that at equal parameters to the tolerance, by as many places as it has features, or leaves the domain. `along`: the
// coedge runs along the edge.
SplinePtr parameter_curve(const face::Face &face, const face::Coedge &coedge, bool along,
                          const model::CurvePiece &edge, double tolerance);

} // namespace nrb::io::step
