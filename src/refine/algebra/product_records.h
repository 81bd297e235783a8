// SPDX-License-Identifier: MIT
// Control points of pointwise products.
#pragma once

#include "refine/algebra/bilinear.h"
#include "refine/algebra/common_knots.h"
#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::refine {

// A factor: its axes, and a record of `width` values for each control point, whatever its meaning.
struct Factor {
    const Spline::Axes &axes;
    std::span<const double> records;
    int width;
};

// The records of the product B(f, g), `width` values each, of factors f and g of degrees p and q. On each
// axis, control point j is the mean of B(f[t_I], g[t_rest]) over all choices I of p of the p + q knots that
// belong to it (common_knots.h); choices that differ only by equal knots are evaluated once.
//
// Error: rows of the polar forms have relative errors of 3 p eps and 3 q eps, a contraction adds (p + 2) eps
// / 2 or (q + 2) eps / 2, and the sum that forms the mean at most 2 eps. For every term of B, a component is
// thus within 4 (p + q + 1) eps, summed over the axes, of max|f| max|g| among the control points that it
// depends on. Memory: the result, and values of the polar forms for some layers. Throws
// Status::not_representable, overflow. Cost: for each control point, the product over the axes of the numbers
// of choices; the rows are computed once for each span.
std::vector<double> product_records(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes,
                                    int width, const Bilinear &form);

} // namespace nrb::refine
