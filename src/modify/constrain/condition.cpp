// SPDX-License-Identifier: MIT
#include "modify/constrain/condition.h"

#include "numeric/direction.h"
#include "numeric/norm.h"

#include <cmath>

namespace nrb::modify {

Condition::Condition(int32_t kind, const eval::Orders &orders, const double *param, const double *target,
                     int axes, int dim)
    : kind_(kind), dim_(dim), param_(param), target_(target) {
    switch (kind) {
    case constrain_direction:
        derivatives_ = {orders};
        add_complement(target);
        equations_ = dim - 1;
        break;
    case constrain_normal:
        for (int k = 0; k < axes; ++k) {
            derivatives_.push_back({k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0});
        }
        rows_ = unit_vector(target, dim);
        equations_ = axes;
        break;
    case constrain_curvature:
        derivatives_ = {eval::Orders{1}, eval::Orders{2}};
        equations_ = dim;
        target_size_ = norm(target, dim);
        break;
    default:
        derivatives_ = {orders};
        equations_ = dim;
        target_size_ = norm(target, dim);
    }
}

// Adds an orthonormal basis of the vectors perpendicular to the direction: all rows but the first of the
// Householder reflection that takes the direction to the first coordinate axis.
void Condition::add_complement(const double *direction) {
    std::vector<double> v = unit_vector(direction, dim_);
    v[0] += std::copysign(1.0, v[0]);
    const double square = dot(v.data(), v.data(), dim_);
    for (int r = 1; r < dim_; ++r) {
        for (int c = 0; c < dim_; ++c) {
            rows_.push_back((r == c ? 1 : 0) -
                            2 * v[static_cast<size_t>(r)] * v[static_cast<size_t>(c)] / square);
        }
    }
}

bool Condition::linear() const noexcept {
    return kind_ != constrain_curvature;
}

void Condition::evaluate(const double *values, double *residual, double *jacobian) const noexcept {
    const auto width = static_cast<int64_t>(derivatives_.size()) * dim_;
    std::fill_n(jacobian, equations_ * width, 0.0);
    if (kind_ == constrain_curvature) {
        return curvature(values, residual, jacobian);
    }
    for (int k = 0; k < equations_; ++k) {
        double *const row = jacobian + k * width;
        if (kind_ == constrain_value) {
            row[k] = 1;
            residual[k] = values[k] - target_[k];
            continue;
        }
        const bool normal = kind_ == constrain_normal;
        const double *const along = rows_.data() + (normal ? 0 : k * dim_);
        const int from = normal ? k * dim_ : 0;
        std::copy_n(along, dim_, row + from);
        residual[k] = dot(along, values + from, dim_);
    }
}

// Let a = C', b = C'', s = a.a. The curvature vector is k = b / s - (a.b) a / s^2, and the residual is r = k
// - t for the target t. The Jacobian is that of the components of r in a frame that turns with the tangent T
// = a / |a|; the component along T is -t.T. With D for the derivative by a and b, it is
//
//     D k + (T r^T + (t.T) I) / |a|,
//
// where the second term counts for a only. It is D k where r = 0. Elsewhere it says how T has to turn to
// become perpendicular to t. D k alone cannot say that where k is far from t, because T.D k = -k.D T.
void Condition::curvature(const double *values, double *residual, double *jacobian) const noexcept {
    const double *const a = values, *const b = values + dim_;
    const double s = dot(a, a, dim_), ab = dot(a, b, dim_) / s, at = dot(a, target_, dim_) / s;
    for (int k = 0; k < dim_; ++k) {
        residual[k] = (b[k] - ab * a[k]) / s - target_[k];
    }
    for (int k = 0; k < dim_; ++k) {
        double *const to_a = jacobian + int64_t{2} * k * dim_, *const to_b = to_a + dim_;
        for (int c = 0; c < dim_; ++c) {
            to_a[c] = (4 * ab * (a[k] * (a[c] / s)) - 2 * b[k] * (a[c] / s) - a[k] * (b[c] / s)) / s +
                      a[k] * (residual[c] / s);
            to_b[c] = -a[k] * (a[c] / s) / s;
        }
        to_a[k] += at - ab / s;
        to_b[k] += 1 / s;
    }
}

} // namespace nrb::modify
