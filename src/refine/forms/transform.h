// SPDX-License-Identifier: MIT
// Affine and projective maps of the control points.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// A matrix stored row by row.
struct MatrixView {
    int64_t rows;
    int64_t columns;
    const double *entries;
};

// The affine map x -> A x + b of the control points. The translation may be null. Throws Status::overflow,
// not_representable. Preconditions: columns == dim, entries are finite.
SplinePtr transform(const Spline &spline, const MatrixView &matrix, const double *translation);

// The projective map h -> M h of the homogeneous control points. Throws Status::overflow, weights_vanish,
// not_representable. Preconditions: columns == dim + 1, entries are finite.
SplinePtr transform_projective(const Spline &spline, const MatrixView &matrix);

} // namespace nrb::refine
