// SPDX-License-Identifier: MIT
// Heuristics from the control points of an element that detect features narrower than the distance between
// the nodes of a quadrature rule.
#pragma once

#include "measure/elements.h"

namespace nrb::measure {

// Finds the axis along which an element should be halved first, or -1. It is halved if its weights differ by
// a factor of more than 64, or in sign. If `legs`, it is also halved if some leg of the control net along an
// axis is more than 75 degrees off the sum of all legs along it; the axis then is the one along which
// neighbouring legs turn most. Cost: linear in the number of coefficients.
class ElementShape {
public:
    explicit ElementShape(const Elements &elements);
    int uneven_axis(const double *net, double spread, bool legs);

private:
    [[nodiscard]] bool even_weights(const double *weights) const noexcept;
    [[nodiscard]] double least_cosine(int axis) noexcept;
    [[nodiscard]] double turn(int axis, int along) const noexcept;
    [[nodiscard]] int64_t step(int axis) const noexcept;
    [[nodiscard]] int layer(int64_t i, int axis) const noexcept;
    void divide(const double *net) noexcept;
    template <class A, class B>
    double cosine(A &&a, B &&b) const noexcept;

    int axes_, dim_;
    bool rational_;
    int64_t coefficients_;
    std::array<int, max_axes> degrees_{};
    std::vector<double> points_; // [coefficients][dim]
    std::vector<double> sum_;
    double noise_ = 0; // squared length up to which a vector is rounding
    int last_ = 0;
};

} // namespace nrb::measure
