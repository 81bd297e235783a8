// SPDX-License-Identifier: MIT
#include "eval/frames/shape_operator.h"

#include "base/numbers.h"

#include <cmath>

namespace nrb::eval {

ShapeOperator::ShapeOperator(const SurfaceDerivatives &d) noexcept {
    const Vector3 product = cross(d.u, d.v);
    a_ = length(d.u);
    e1_ = unit(d.u);
    normal_ = unit(product);
    normal_ = unit(normal_ - dot(normal_, e1_) * e1_); // perpendicular only up to the rounding of the product
    b_ = dot(d.v, e1_) / a_;
    c_ = length(product) / a_;
    l_ = dot(d.uu, normal_);
    m_ = dot(d.uv, normal_);
    n_ = dot(d.vv, normal_);
    const double mixed = m_ - b_ * l_;
    w11_ = l_ / a_ / a_;
    w12_ = mixed / a_ / c_;
    w22_ = ((n_ - b_ * m_) - b_ * mixed) / c_ / c_;
    spread_ = length({0.5 * (w11_ - w22_), w12_, 0});
}

// The determinant of W or, where it is not finite, the product of the principal curvatures, whose factors do
// not overflow.
double ShapeOperator::gaussian() const noexcept {
    const double determinant = w11_ * w22_ - w12_ * w12_;
    return std::isfinite(determinant) ? determinant : (mean() + spread_) * (mean() - spread_);
}

// The angle phi from e1 satisfies tan 2 phi = 2 w12 / (w11 - w22). The larger one of cos phi and sin phi is
// computed by the half-angle formula, the other one from it, so that nothing cancels.
Vector3 ShapeOperator::direction() const noexcept {
    const double half = 0.5 * (w11_ - w22_);
    if (!(spread_ > 0)) {
        return e1_;
    }
    const double large = std::sqrt(0.5 * (1 + std::fabs(half) / spread_));
    const double small = std::fabs(w12_) / (2 * spread_ * large);
    const double along = half >= 0 ? large : small;
    const double across = std::copysign(half >= 0 ? small : large, along > 0 ? w12_ : 1.0);
    return along * e1_ + across * cross(normal_, e1_);
}

// The errors of each factor of w11, w12 and w22 in turn, plus a few eps for the operations themselves.
double ShapeOperator::spread_error(const SurfaceDerivatives &d,
                                   const DerivativeErrors &errors) const noexcept {
    constexpr double own = 8 * eps;
    const double b = std::fabs(b_);
    const double size_v = length(d.v);
    const double turn = (a_ * errors.v + size_v * errors.u) / (a_ * c_) + own; // of the normal
    const double of_a = errors.u / a_ + own;
    const double of_b = (errors.v + 2 * b * errors.u) / a_ + own * (b + size_v / a_);
    const double of_c = (errors.v + b * errors.u) / c_ + turn;
    const double of_l = errors.uu + length(d.uu) * turn;
    const double of_m = errors.uv + length(d.uv) * turn;
    const double of_n = errors.vv + length(d.vv) * turn;
    const double first = of_l / a_ / a_ + 2 * std::fabs(w11_) * of_a;
    const double mixed = (of_m + b * of_l + std::fabs(l_) * of_b) / a_ / c_ + std::fabs(w12_) * (of_a + of_c);
    const double slopes = 2 * of_b * (std::fabs(m_) + b * std::fabs(l_));
    const double second =
        (of_n + 2 * b * of_m + b * b * of_l + slopes) / c_ / c_ + 2 * std::fabs(w22_) * of_c;
    return 0.5 * (first + second) + mixed;
}

bool regular(const SurfaceDerivatives &d, const DerivativeErrors &errors) noexcept {
    return length(cross(d.u, d.v)) > length(d.u) * errors.v + errors.u * (length(d.v) + errors.v);
}

} // namespace nrb::eval
