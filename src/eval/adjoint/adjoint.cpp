// SPDX-License-Identifier: MIT
#include "eval/adjoint/adjoint.h"

#include "eval/adjoint/net_gradients.h"

namespace nrb::eval {

void clear(const Records &out) noexcept {
    for (int64_t i = 0; i < out.count && out.data != nullptr; ++i) {
        for (int64_t c = 0; c < out.width; ++c) {
            out(i, c) = 0;
        }
    }
}

bool clamped(const Cotangents &from, int64_t i, int k) noexcept {
    if (from.rules[static_cast<size_t>(k)].outside != Outside::clamp) {
        return false;
    }
    const Interval domain = from.spline.axis(k).domain();
    const double t = from.params(i, k);
    return t < domain.lower || t > domain.upper;
}

void evaluate_adjoint(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                      ConstRecords cotangents, bool accumulate, const Gradients &gradients) {
    const Cotangents from{spline, rules, order, params, cotangents, accumulate};
    const bool finite = spline.form() != Form::homogeneous || spline.all_weights().smallest > 0;
    if (order == 0 && finite) {
        points_adjoint(from, gradients);
    } else {
        derivatives_adjoint(from, gradients);
    }
}

} // namespace nrb::eval
