// SPDX-License-Identifier: MIT
// As which curves an edge is written.
#pragma once

#include "face/face.h"
#include "io/written/topology.h"
#include "model/model.h"

namespace nrb::io::step {

// The curve of an edge between its vertices, so that reading gives the same spline: what the edge was in a file if the part of that
// between the vertices is the edge, bit for bit, else its spline.
model::CurvePiece stated_piece(const model::Edge &edge, const Vector3 &start, const Vector3 &end,
                               double tolerance);

// The curve of an edge in the domain of its face, over the parameters of the curve of the edge as that is written; null where it is
// not under that at equal parameters to the tolerance, by as many places as it has features, or leaves the domain. A face that
// has no larger tolerance keeps any that readers take: made anew, it would be another one where its edge is far from the surface.
SplinePtr parameter_curve(const face::Face &face, const OrientedEdge &oriented, const model::CurvePiece &edge,
                          double tolerance);

} // namespace nrb::io::step
