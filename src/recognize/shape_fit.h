// SPDX-License-Identifier: MIT
// Shapes fitted to samples.
#pragma once

#include "recognize/shape_model.h"
#include "recognize/shape_samples.h"

namespace nrb::recognize {

// The shape of a kind that fits the samples best or nearly so, relative to their centre; shape_none if
// there is none, and any one where the best is no nearer than the tolerance. `dim` is that of the spline.
// What is linear in the data gives a first one: the plane and the line of principal axes, circles and spheres
// from the linear equation |p|^2 = 2 c p + k, conics from their equation in the plane, the axis of a cylinder
// and a cone from the Gauss image of the normals, that of a torus as the line that all normals meet (H.
// Pottmann, M. Peternell, B. Ravani, "An introduction to line geometry with applications", CAD 31 (1999));
// the distances themselves are then made small.
Shape fitted_shape(int32_t kind, const ShapeSamples &samples, int dim, double tolerance);

// The same shape where the spline is, with the origin, the signs and the direction x that nurbs_recognize()
// states.
Shape placed_shape(const Shape &fitted, const ShapeSamples &samples, int dim);

} // namespace nrb::recognize
