// SPDX-License-Identifier: MIT
// One-sided derivatives of a curve at a parameter, with bounds on their rounding errors.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::closest {

// The Cartesian derivatives of orders 0, 1, ... as vectors, and bounds on their rounding errors: H_k and E_k
// of the preamble of nurbs.h, taken over the whole span and in the Euclidean norm. They are not finite if
// w(t) = 0.
class CurveSide {
public:
    // Differentiates the piece below t (left) or above it. `accuracy` is the constant c of the bounds: the
    // one for the curve's degree plus the one for the operations that produced the curve. Precondition: t
    // lies in the closed domain of a curve.
    CurveSide(const Spline &curve, double t, bool left, int order, double accuracy);

    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] int order() const noexcept { return static_cast<int>(errors_.size()) - 1; }
    [[nodiscard]] const double *at(int k) const noexcept { return derivs_.data() + int64_t{k} * dim_; }
    [[nodiscard]] double error(int k) const noexcept { return errors_[static_cast<size_t>(k)]; }
    [[nodiscard]] double length(int k) const noexcept;
    // The length that the span would have if the speed were constant and equal to the speed at t.
    [[nodiscard]] double span_length() const noexcept { return length(1) * span_; }
    // Whether derivative k is 0 to within its rounding error.
    [[nodiscard]] bool vanishes(int k) const noexcept { return !(length(k) > error(k)); }
    // Turns these into the derivatives of the reversed curve: the parameter changes its sign.
    void reverse() noexcept;

private:
    void divide(const std::vector<double> &records, const std::vector<double> &sizes,
                const std::vector<double> &weight_sizes);

    int dim_;
    double span_ = 0; // length of the parameter interval
    std::vector<double> derivs_;
    std::vector<double> errors_;
};

} // namespace nrb::closest
