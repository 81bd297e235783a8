// SPDX-License-Identifier: MIT
// Fits shapes to samples.
#pragma once

#include "recognize/shape_model.h"
#include "recognize/shape_samples.h"

namespace nrb::recognize {

// A shape of a given kind with a good, nearly least-squares fit to the samples, relative to their centre.
// Returns shape_none if there is none, and any shape if the best one is no nearer than the tolerance. `dim`:
// the dimension of the spline. First guesses come from linear problems: planes and lines from the principal
// axes; circles and spheres from the linear equation |p|^2 = 2 c . p + k; conics from their equation in the
// plane; the axes of cylinders and cones from the Gauss image of the normals; the axis of a torus as the line
// that all normals meet (H. Pottmann, M. Peternell, B. Ravani, "An introduction to line geometry with
// applications", CAD 31 (1999)). The distances themselves are then minimized.
Shape fitted_shape(int32_t kind, const ShapeSamples &samples, int dim, double tolerance);

// The same shape in the coordinates of the spline, with the origin, the signs and the direction x as
// specified for nurbs_recognize().
Shape placed_shape(const Shape &fitted, const ShapeSamples &samples, int dim);

} // namespace nrb::recognize
