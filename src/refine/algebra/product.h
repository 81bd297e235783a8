// SPDX-License-Identifier: MIT
// Pointwise products of splines.
#pragma once

#include "refine/algebra/common_knots.h"
#include "spline/spline.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace nrb::refine {

// A map of two records that is linear in each of them: out = B(a, b).
using Bilinear = std::function<void(const double *a, const double *b, double *out)>;

// A factor: its axes, and records, whatever they mean, for its control points.
struct Factor {
    const Spline::Axes &axes;
    std::span<const double> records;
    int width;
};

// Throws Status::incompatible if the numbers of axes or the domains differ.
void check_same_domains(const Spline::Axes &a, const Spline::Axes &b);

// The axes of the products of two splines: degrees are added, and knots have `extra[k]` more copies than they
// need. Throws what check_same_domains() throws, Status::degree,
// periodic_knots.
std::vector<CommonKnots> product_axes(const Spline::Axes &a, const Spline::Axes &b,
                                      const std::array<int, 3> &extra = {});

// The records B(a, b) of the product, `width` values each: on each axis control point j is the mean, over all
// choices I of p of the p + q knots that belong to it, of B(f[t_I], g[t_rest]) (common_knots.h), equal
// choices taken together. Rows of the polar forms have relative errors of 3 p and 3 q eps, a contraction (p +
// 2) eps / 2, the mean is a compensated sum: every component is within 4 (p + q + 1) eps, summed over the
// axes, of max|f| max|g| among the control points that it depends on, for every product of components in B.
// Memory: the result twice, and the rows of all axes but the first. Throws Status::not_representable,
// overflow. Cost: for each control point, the number of choices on each axis times (p + q + 2).
std::vector<double> product_records(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes,
                                    int width, const Bilinear &form);

Spline::Axes axes_of(const std::vector<CommonKnots> &joint);

enum class ProductKind { components, dot, cross };

// The spline a(t) b(t). Throws Status::dimension, and what the functions above and make_result() throw.
SplinePtr product(const Spline &a, const Spline &b, ProductKind kind);

// A spline of homogeneous records. With Form::rational points of weight 0 stand at the origin. Weights of 0
// in a denominator can bring about points at infinity; if there are some, the form is the homogeneous one.
// Throws what make_result() throws.
SplinePtr from_records(Spline::Axes axes, int dim, Form form, std::vector<double> records);

} // namespace nrb::refine
