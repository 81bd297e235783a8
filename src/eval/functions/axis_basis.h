// SPDX-License-Identifier: MIT
// The basis functions of one axis at one parameter, to which the rule of the axis is applied.
#pragma once

#include "basis/bspline.h"
#include "eval/parameters.h"

#include <cmath>

namespace nrb::eval {

// The active basis functions at a parameter, and which layers they belong to.
struct AxisBasis {
    int64_t first = 0;        // index of the first active layer
    int sole = -1;            // relative to `first`: the layer whose function is 1, others 0; or -1
    double *values = nullptr; // [order + 1][degree + 1]
};

// The data of an axis that a batch looks up once. The recurrences are used, never power spans.
class AxisEvaluator {
public:
    AxisEvaluator(const KnotVector &axis, const AxisRule &rule, int order)
        : spans_(axis.spans()), knots_(axis.knots().data()), domain_(axis.domain()), rule_(rule),
          degree_(axis.degree()), order_(order) {}

    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] size_t values_size() const noexcept {
        return static_cast<size_t>(order_ + 1) * static_cast<size_t>(degree_ + 1);
    }

    // Fills basis.first, basis.sole and basis.values. Returns false, and leaves them unchanged, if the
    // parameter gives NaN. Precondition: t has been checked.
    bool operator()(double t, AxisBasis &basis) const noexcept {
        const double placed = place(t, rule_, domain_);
        if (std::isnan(placed)) {
            return false;
        }
        const int64_t span = spans_.find(placed, rule_.left);
        basis.first = span - degree_;
        basis.sole = sole_function(knots_, degree_, span, placed);
        if (order_ == 0) {
            basis_values(knots_, degree_, span, placed, basis.values);
        } else {
            basis_derivs(knots_, degree_, span, placed, order_, basis.values);
        }
        return true;
    }

private:
    const SpanTable &spans_;
    const double *knots_;
    Interval domain_;
    AxisRule rule_;
    int degree_;
    int order_;
};

} // namespace nrb::eval
