// SPDX-License-Identifier: MIT
// A spline as a lattice of Bezier cells, with control points that neighbouring cells share.
#pragma once

#include "mesh/volume/lattice.h"
#include "spline/spline.h"

namespace nrb::mesh {

// One cell for each Bezier piece, in the order of refine::bezier_pieces(). Control points of collapsed sides
// stay apart, since their weights may differ. Throws Status::degree, overflow.
Lattice bezier_lattice(const Spline &spline);

// Writes the control points of the lattice, [points][dim], and their weights; null: not wanted. Throws what
// refine::bezier_pieces() throws, before anything is written.
void write_bezier_points(const SplinePtr &spline, const Lattice &lattice, double *points, double *weights);

} // namespace nrb::mesh
