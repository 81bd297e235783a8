// SPDX-License-Identifier: MIT
// The derivatives of a curve on one side of a parameter, with bounds of their rounding.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::closest {

// The Cartesian derivatives of orders 0, 1, ... as vectors, and the bounds of their rounding: H_k and E_k of
// nurbs.h's preamble, for the whole span, in Euclidean length. They are not finite if w(t) = 0.
class CurveSide {
public:
    // Derivatives of the piece below t (left) or above it. `accuracy` is the constant c of the bounds: that
    // of the curve's degree plus that of the operations that made the curve. Precondition: t lies in the
    // closed domain of a curve.
    CurveSide(const Spline &curve, double t, bool left, int order, double accuracy);

    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] int order() const noexcept { return static_cast<int>(errors_.size()) - 1; }
    [[nodiscard]] const double *at(int k) const noexcept { return derivs_.data() + int64_t{k} * dim_; }
    [[nodiscard]] double error(int k) const noexcept { return errors_[static_cast<size_t>(k)]; }
    [[nodiscard]] double length(int k) const noexcept;
    // How long the span would be at the speed that the curve has here.
    [[nodiscard]] double span_length() const noexcept { return length(1) * span_; }
    // Whether derivative k is more than its rounding.
    [[nodiscard]] bool vanishes(int k) const noexcept { return !(length(k) > error(k)); }
    // The derivatives when the curve is run through in the other direction: the parameter changes its sign.
    void reverse() noexcept;

private:
    void divide(const std::vector<double> &records, const std::vector<double> &sizes,
                const std::vector<double> &weight_sizes);

    int dim_;
    double span_ = 0; // of the parameter
    std::vector<double> derivs_;
    std::vector<double> errors_;
};

} // namespace nrb::closest
