// SPDX-License-Identifier: MIT
// The two ways of an adjoint.
#pragma once

#include "eval/adjoint/adjoint.h"

namespace nrb::eval {

// What gradients are made from.
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

// Whether the value does not depend on parameter (i, k), because that was moved to an end of the domain.
bool clamped(const Cotangents &from, int64_t i, int k) noexcept;

// From cotangents of points, in few steps for each parameter. Precondition: order 0, and no point at
// infinity.
void points_adjoint(const Cotangents &from, const Gradients &out);
// From cotangents of derivatives of any order.
void derivatives_adjoint(const Cotangents &from, const Gradients &out);

} // namespace nrb::eval
