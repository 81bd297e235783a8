// SPDX-License-Identifier: MIT
// Sewing: makes a model of patches without topology.
#pragma once

#include "model/model.h"

namespace nrb::model {

// A model with one part and one use of it, with faces in the order given. Pieces of the sides of patches are
// one edge if each is proven to be within the tolerance of the other, given how far edge_over() found curves
// from their exact images (which is no bound where it fits). The curve of the edge is one of the pieces; the
// others deviate from it, as coedges may. Sides are cut where others begin or end. Pieces no larger than the
// tolerance are left out of loops. Faces connected by edges with two uses are oriented like the first of
// them. Throws Status::same for a patch that is given twice, and what Face() and edge_over() throw, naming
// the face. Precondition: surfaces of dimension 3, tolerance > 0.
Model sew(const std::vector<face::FacePtr> &faces, double tolerance, double metres_per_unit);

} // namespace nrb::model
