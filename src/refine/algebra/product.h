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

// The axes of the products of two splines: degrees are added, and knots have `extra[k]` more copies than they
// need. Throws what check_same_domains() throws, Status::degree,
// periodic_knots.
std::vector<CommonKnots> product_axes(const Spline::Axes &a, const Spline::Axes &b,
                                      const std::array<int, 3> &extra = {});

Spline::Axes axes_of(const std::vector<CommonKnots> &joint);

enum class ProductKind { components, dot, cross };

// The spline a(t) b(t). Throws Status::dimension, and what the functions above and make_result() throw.
SplinePtr product(const Spline &a, const Spline &b, ProductKind kind);

// A spline of homogeneous records. With Form::rational points of weight 0 stand at the origin. Weights of 0
// in a denominator can bring about points at infinity; if there are some, the form is the homogeneous one.
// Throws what make_result() throws.
SplinePtr from_records(Spline::Axes axes, int dim, Form form, std::vector<double> records);

} // namespace nrb::refine
