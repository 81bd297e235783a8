// SPDX-License-Identifier: MIT
// Pointwise products of splines.
#pragma once

#include "refine/algebra/product_records.h"
#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::refine {

// Throws Status::incompatible if the numbers of axes or the domains differ.
void check_same_domains(const Spline::Axes &a, const Spline::Axes &b);

// The axes of the product of two splines: their degrees add up, and knots of axis k get extra[k] more copies
// than they need. Throws what check_same_domains() throws, and Status::degree, periodic_knots.
std::vector<CommonKnots> product_axes(const Spline::Axes &a, const Spline::Axes &b,
                                      const std::array<int, 3> &extra = {});

Spline::Axes axes_of(const std::vector<CommonKnots> &joint);

enum class ProductKind { components, dot, cross };

// The product of two splines: by components, as a dot product or as a cross product. Throws
// Status::dimension, and what the functions above and make_result() throw.
SplinePtr product(const Spline &a, const Spline &b, ProductKind kind);

// A spline from homogeneous records. In Form::rational, points of weight 0 are placed at the origin. If a
// record of weight 0 has another component that is not 0 (a point at infinity, which can arise from weights
// of 0 in a denominator), the result has Form::homogeneous instead. Throws what make_result() throws.
SplinePtr from_records(Spline::Axes axes, int dim, Form form, std::vector<double> records);

} // namespace nrb::refine
