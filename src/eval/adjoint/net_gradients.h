// SPDX-License-Identifier: MIT
// The two methods by which the adjoint of evaluation is computed: for points, and for derivatives of any
// order.
#pragma once

#include "eval/adjoint/adjoint.h"

namespace nrb::eval {

// The cotangents, and all that gradients are made from.
struct Cotangents {
    const Spline &spline;
    const AxisRules &rules;
    int order;
    ConstRecords params;
    ConstRecords values; // [count][slots][dim]
    bool accumulate;
};

// Sets all elements of an output to 0, if it is wanted.
void clear(const Records &out) noexcept;

// Whether parameter (i, k) was moved to an end of the domain, so that the point does not depend on it.
bool clamped(const Cotangents &from, int64_t i, int k) noexcept;

// From cotangents of points, in few operations per parameter. Preconditions: order 0, and no control point at
// infinity.
void points_adjoint(const Cotangents &from, const Gradients &out);
// From cotangents of derivatives of any order.
void derivatives_adjoint(const Cotangents &from, const Gradients &out);

} // namespace nrb::eval
