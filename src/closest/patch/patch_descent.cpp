#include "closest/patch/patch_descent.h"

#include "eval/kernels/slots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double product(const double *a, const double *b, int n) noexcept {
    double sum = a[0] * b[0];
    for (int c = 1; c < n; ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

// The slot of the second derivative along two axes, and the first derivative along one.
int64_t second(int axes, int k, int l) noexcept {
    eval::Orders orders{};
    ++orders[static_cast<size_t>(k)];
    ++orders[static_cast<size_t>(l)];
    return eval::slot(axes, orders);
}

using Matrix = std::array<AxisValues, max_axes>;

// Cholesky's factorisation and both substitutions; false unless positive definite.
bool solve(int n, Matrix a, AxisValues &x) noexcept {
    for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        for (size_t j = 0; j < i; ++j) {
            for (size_t m = 0; m < j; ++m) {
                a[i][j] -= a[i][m] * a[j][m];
            }
            a[i][j] /= a[j][j];
            x[i] -= a[i][j] * x[j];
        }
        double pivot = a[i][i];
        for (size_t m = 0; m < i; ++m) {
            pivot -= a[i][m] * a[i][m];
        }
        if (!(pivot > 8 * eps * a[i][i]) || !(pivot > 0)) {
            return false;
        }
        a[i][i] = std::sqrt(pivot);
        x[i] /= a[i][i];
    }
    for (auto i = static_cast<size_t>(n); i-- > 0;) {
        for (size_t m = i + 1; m < static_cast<size_t>(n); ++m) {
            x[i] -= a[m][i] * x[m];
        }
        x[i] /= a[i][i];
    }
    return true;
}

} // namespace

double PatchDescent::distance(const double *values, const AxisValues &at) const {
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(evaluation_work(shape_)), *q = memory_.take(shape_.lanes);
    evaluate_patch(shape_, values, at, 0, work, q);
    return std::sqrt(product(q, q, shape_.dim)) / std::abs(q[shape_.dim]);
}

void PatchDescent::point(const double *values, const AxisValues &at, double *out) const {
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(evaluation_work(shape_)), *q = memory_.take(shape_.lanes);
    evaluate_patch(shape_, values, at, 0, work, q);
    for (int c = 0; c < shape_.dim; ++c) {
        out[c] = q[c] / q[shape_.dim];
    }
}

PatchValues PatchDescent::values(const double *values, const AxisValues &at) const {
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(evaluation_work(shape_));
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
    double *work = memory_.take(evaluation_work(shape_));
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

bool PatchDescent::step(const PatchJet &jet, double sign, double damping,
                        const std::array<bool, max_axes> &free, AxisValues &out) const noexcept {
    std::array<size_t, max_axes> axes{};
    int n = 0;
    double trace = 0;
    for (size_t k = 0; k < static_cast<size_t>(shape_.axes); ++k) {
        trace += jet.metric[k][k];
        if (free[k]) {
            axes[static_cast<size_t>(n++)] = k;
        }
    }
    Matrix matrix{};
    AxisValues x{};
    for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        for (size_t j = 0; j < static_cast<size_t>(n); ++j) {
            matrix[i][j] = sign * (jet.metric[axes[i]][axes[j]] + jet.curvature[axes[i]][axes[j]]);
        }
        matrix[i][i] += damping * (jet.metric[axes[i]][axes[i]] + 1e-6 * trace);
        x[i] = -sign * jet.gradient[axes[i]];
    }
    out = {};
    if (!solve(n, matrix, x)) {
        return false;
    }
    for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        out[axes[i]] = x[i];
    }
    return true;
}

// Levenberg and Marquardt's damping where the matrix is not positive definite or a step does not descend, the
// gradient projected to the box. A last step is taken without looking where it decreases |S|^2 by less than
// rounding: Newton's method has squared the error by then.
PatchDescent::Result PatchDescent::descend(const double *values, const PatchBox &box, double sign,
                                           double floor, AxisValues &at, int steps) const {
    PatchJet now = jet(values, at);
    double damping = 0;
    for (int i = 0; i < steps; ++i) {
        if (!(now.square > floor * floor) && sign > 0) {
            return {std::sqrt(std::max(now.square, 0.0)), true};
        }
        std::array<bool, max_axes> free{};
        bool any = false;
        for (size_t k = 0; k < static_cast<size_t>(shape_.axes); ++k) {
            const double down = -sign * now.gradient[k];
            free[k] = !((at[k] <= box.lower[k] && down <= 0) || (at[k] >= box.upper[k] && down >= 0));
            any = any || free[k];
        }
        AxisValues move{};
        if (!any) {
            return {std::sqrt(now.square), true};
        }
        while (!step(now, sign, damping, free, move)) {
            damping = std::max(4 * damping, 1e-3);
            if (damping > 1e12) {
                return {std::sqrt(now.square), true};
            }
        }
        AxisValues next = at;
        double decrease = 0;
        bool moves = false;
        for (size_t k = 0; k < static_cast<size_t>(shape_.axes); ++k) {
            next[k] = std::clamp(at[k] + move[k], box.lower[k], box.upper[k]);
            decrease -= sign * now.gradient[k] * (next[k] - at[k]);
            moves = moves || next[k] != at[k];
        }
        if (!moves) {
            return {std::sqrt(now.square), true};
        }
        const PatchJet then = jet(values, next);
        const double gain = sign * (now.square - then.square);
        if (std::abs(decrease) <= 16 * eps * now.square) {
            if (std::abs(gain) <= 64 * eps * now.square || gain > 0) {
                at = next;
                now = then;
            }
            return {std::sqrt(now.square), true};
        }
        if (gain > 0 && std::isfinite(then.square)) {
            const bool good = gain > 0.5 * decrease;
            at = next;
            now = then;
            damping = good ? (damping < 1e-2 ? 0 : damping / 8) : damping;
        } else {
            damping = std::max(8 * damping, 1e-3);
            if (damping > 1e12) {
                return {std::sqrt(now.square), true};
            }
        }
    }
    return {std::sqrt(now.square), false};
}

} // namespace nrb::closest
