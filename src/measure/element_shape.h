// SPDX-License-Identifier: MIT
// What the control points of an element tell of features that are narrower than the nodes of a rule are
// apart.
#pragma once

#include "measure/elements.h"

namespace nrb::measure {

// The axis along which an element should be halved first, or -1: the weights differ by a factor of more than
// 64; or, if `legs`, some leg of the control net along the axis is more than 75 degrees off the sum of all of
// them, and neighbours of it turn most along that axis. Cost: linear in the number of coefficients.
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
    double noise_ = 0; // square of a length that is rounding
    int last_ = 0;
};

} // namespace nrb::measure
