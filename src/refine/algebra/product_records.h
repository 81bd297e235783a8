// SPDX-License-Identifier: MIT
// Control points of pointwise products.
#pragma once

#include "refine/algebra/bilinear.h"
#include "refine/algebra/common_knots.h"
#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::refine {

// A factor: its axes, and records, whatever they mean, for its control points.
struct Factor {
    const Spline::Axes &axes;
    std::span<const double> records;
    int width;
};

// The records B(a, b) of the product, `width` values each: on each axis control point j is the mean, over all
// choices I of p of the p + q knots that belong to it, of B(f[t_I], g[t_rest]) (common_knots.h), equal
// choices taken together. Rows of the polar forms have relative errors of 3 p and 3 q eps, a contraction (p +
// 2) eps / 2, the mean is a sum of at most (p + q) / 2 + 2 eps: every component is within 4 (p + q + 1) eps,
// summed over the axes, of max|f| max|g| among the control points that it depends on, for every term of B.
// Memory: the result, and values of the polar forms for some layers. Throws Status::not_representable,
// overflow. Cost: for each control point the product of the number of choices on each axis; the rows once for
// each span.
std::vector<double> product_records(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes,
                                    int width, const Bilinear &form);

} // namespace nrb::refine
