// SPDX-License-Identifier: MIT
#include "closest/patch/patch_descent.h"

#include "eval/kernels/slots.h"

#include <cmath>

namespace nrb::closest {

namespace {

double product(const double *a, const double *b, int n) noexcept {
    double sum = a[0] * b[0];
    for (int c = 1; c < n; ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

// The slot of a second derivative.
int64_t second(int axes, int k, int l) noexcept {
    eval::Orders orders{};
    ++orders[static_cast<size_t>(k)];
    ++orders[static_cast<size_t>(l)];
    return eval::slot(axes, orders);
}

} // namespace

double PatchDescent::distance(const double *values, const AxisValues &at) const {
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(pieces::evaluation_work(shape_)), *q = memory_.take(shape_.lanes);
    evaluate_patch(shape_, values, at, 0, work, q);
    return std::sqrt(product(q, q, shape_.dim)) / std::abs(q[shape_.dim]);
}

void PatchDescent::point(const double *values, const AxisValues &at, double *out) const {
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(pieces::evaluation_work(shape_)), *q = memory_.take(shape_.lanes);
    evaluate_patch(shape_, values, at, 0, work, q);
    for (int c = 0; c < shape_.dim; ++c) {
        out[c] = q[c] / q[shape_.dim];
    }
}

PatchValues PatchDescent::values(const double *values, const AxisValues &at) const {
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(pieces::evaluation_work(shape_));
    double *q = memory_.take(eval::slot_count(max_axes, 1) * shape_.lanes);
    evaluate_patch(shape_, values, at, 1, work, q);
    PatchValues result;
    result.length = std::sqrt(product(q, q, shape_.dim));
    result.weight = q[shape_.dim];
    for (int k = 0; k < shape_.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        const double *d = q + static_cast<ptrdiff_t>((k + 1) * shape_.lanes);
        result.products[i] = product(q, d, shape_.dim);
        result.derivatives[i] = std::sqrt(product(d, d, shape_.dim));
        result.weights[i] = d[shape_.dim];
    }
    return result;
}

// With S = Q / w: S_k = (Q_k - S w_k) / w and S_kl = (Q_kl - S_k w_l - S_l w_k - S w_kl) / w.
PatchJet PatchDescent::jet(const double *values, const AxisValues &at) const {
    const PatchMemory::Hold hold(memory_);
    const int dim = shape_.dim, axes = shape_.axes;
    double *work = memory_.take(pieces::evaluation_work(shape_));
    double *q = memory_.take(eval::slot_count(max_axes, 2) * shape_.lanes);
    evaluate_patch(shape_, values, at, 2, work, q);
    const double inverse = 1 / q[dim];
    for (int c = 0; c < dim; ++c) {
        q[c] *= inverse;
    }
    PatchJet jet;
    jet.square = product(q, q, dim);
    for (int k = 0; k < axes; ++k) {
        const auto i = static_cast<size_t>(k);
        double *d = q + static_cast<ptrdiff_t>((k + 1) * shape_.lanes);
        for (int c = 0; c < dim; ++c) {
            d[c] = (d[c] - q[c] * d[dim]) * inverse;
        }
        jet.gradient[i] = product(q, d, dim);
        for (int l = 0; l <= k; ++l) {
            const auto j = static_cast<size_t>(l);
            const double *e = q + static_cast<ptrdiff_t>((l + 1) * shape_.lanes);
            const double *s = q + second(axes, k, l) * shape_.lanes;
            jet.metric[i][j] = jet.metric[j][i] = product(d, e, dim);
            jet.curvature[i][j] = jet.curvature[j][i] = (product(q, s, dim) - jet.gradient[i] * e[dim] -
                                                         jet.gradient[j] * d[dim] - jet.square * s[dim]) *
                                                        inverse;
        }
    }
    return jet;
}

pieces::Descent PatchDescent::descend(const double *values, const PatchBox &box, double sign, double floor,
                                      AxisValues &at, int steps) const {
    const auto jet_at = [&](const AxisValues &place) { return jet(values, place); };
    return pieces::DampedDescent<max_axes, decltype(jet_at)>(shape_.axes, box, sign, floor, jet_at)
        .run(at, steps);
}

} // namespace nrb::closest
