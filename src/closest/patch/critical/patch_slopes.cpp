// SPDX-License-Identifier: MIT
#include "closest/patch/critical/patch_slopes.h"

#include "base/numbers.h"
#include "numeric/norm.h"
#include "numeric/solvers/small_systems.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

// The largest row sum of |A| |B|.
double product_norm(int n, const AxisMatrix &a, const AxisMatrix &b) noexcept {
    const auto size = static_cast<size_t>(n);
    double largest = 0;
    for (size_t i = 0; i < size; ++i) {
        double sum = 0;
        for (size_t j = 0; j < size; ++j) {
            double entry = 0;
            for (size_t k = 0; k < size; ++k) {
                entry += std::abs(a[i][k]) * std::abs(b[k][j]);
            }
            sum += entry;
        }
        largest = std::max(largest, sum);
    }
    return largest;
}

} // namespace

void PatchSlopes::Range::add(double x) noexcept {
    low = std::min(low, x);
    high = std::max(high, x);
}

double PatchSlopes::Range::size() const noexcept {
    return std::max(std::abs(low), std::abs(high));
}

PatchSlopes::PatchSlopes(const PatchShape &shape, const pieces::PatchSquares &squares, const double *patch,
                         double moved, PatchMemory &memory)
    : shape_(shape), patch_(patch), squares_(memory.take(shape.products())),
      weights_(memory.take(shape.products())), centre_(memory.take(shape.dim)), moved_(moved) {
    std::fill_n(weights_, shape.products(), 1.0);
    square_patch(shape, squares.tables(), patch, memory.take(pieces::product_work(shape)), squares_,
                 weights_);
    measure(patch);
    const double magnitude = 1.05 * squares.error() * (reach_ * reach_ + most_);
    error_ = (magnitude + 2.2 * moved * reach_) * most_weight_ * most_weight_;
}

void PatchSlopes::measure(const double *patch) noexcept {
    least_weight_ = infinity;
    for (int64_t i = 0; i < shape_.coefficients(); ++i, patch += shape_.lanes) {
        const double w = patch[shape_.dim];
        least_weight_ = std::min(least_weight_, w);
        most_weight_ = std::max(most_weight_, w);
        reach_ = std::max(reach_, norm(patch, shape_.dim) / w);
    }
    least_ = infinity;
    for (int64_t i = 0; i < shape_.products(); ++i) {
        least_ = std::min(least_, squares_[i] / weights_[i]);
        most_ = std::max(most_, squares_[i] / weights_[i]);
    }
}

// Visits all positions in the net of the product except the last shrink[k] along each axis.
template <class Visit>
void PatchSlopes::for_products(const std::array<int, max_axes> &shrink, Visit &&visit) const {
    std::array<int64_t, max_axes> end{1, 1, 1}, steps{};
    for (int k = 0; k < shape_.axes; ++k) {
        const auto place = static_cast<size_t>(k + max_axes - shape_.axes);
        end[place] = 2 * shape_.degree(k) + 1 - shrink[static_cast<size_t>(k)];
        steps[place] = step(k);
    }
    for (int64_t i = 0; i < end[0]; ++i) {
        for (int64_t j = 0; j < end[1]; ++j) {
            for (int64_t k = 0; k < end[2]; ++k) {
                visit(i * steps[0] + j * steps[1] + k * steps[2]);
            }
        }
    }
}

int64_t PatchSlopes::step(int axis) const noexcept {
    int64_t result = 1;
    for (int k = shape_.axes; k-- > axis + 1;) {
        result *= 2 * shape_.degree(k) + 1;
    }
    return result;
}

bool PatchSlopes::monotone() noexcept {
    for (int k = 0; k < shape_.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        const int64_t s = step(k);
        std::array<int, max_axes> shrink{};
        shrink[i] = 1;
        Range range{infinity, -infinity};
        double weight = 0;
        for_products(shrink, [&](int64_t at) {
            const double d = squares_[at + s] - squares_[at], w = weights_[at + s] - weights_[at];
            range.add(d - least_ * w);
            range.add(d - most_ * w);
            weight = std::max(weight, std::abs(w));
        });
        if (range.low > 2 * error_ || range.high < -2 * error_) {
            return true;
        }
        const int n = 2 * shape_.degree(k);
        first_[i] = {n * (range.low - 2 * error_), n * (range.high + 2 * error_)};
        weight_slopes_[i] = n * weight / (least_weight_ * least_weight_);
    }
    return false;
}

// The sign of S . S_k for S = Q / w. Let c be the quotient of a coefficient in the middle, r = S - c and
// E = Q_k - c w_k; then w S . S_k = c . E + r . E - (c . r + |r|^2) w_k. The control points bound r and
// c . r; differences of coefficients bound E and w_k. A coefficient has an error of w moved_ plus the
// rounding of its difference.
bool PatchSlopes::slanted() const noexcept {
    const int dim = shape_.dim;
    const double *middle = patch_ + shape_.coefficients() / 2 * shape_.lanes;
    for (int c = 0; c < dim; ++c) {
        centre_[c] = middle[c] / middle[dim];
    }
    Range heights{infinity, -infinity};
    double radius = 0;
    const double *q = patch_;
    for (int64_t i = 0; i < shape_.coefficients(); ++i, q += shape_.lanes) {
        double height = 0, square = 0;
        for (int c = 0; c < dim; ++c) {
            const double r = q[c] / q[dim] - centre_[c];
            height += centre_[c] * r;
            square += r * r;
        }
        heights.add(height);
        radius = std::max(radius, std::sqrt(square));
    }
    for (int k = 0; k < shape_.axes; ++k) {
        if (slanted_along(k, centre_, heights, radius)) {
            return true;
        }
    }
    return false;
}

bool PatchSlopes::slanted_along(int axis, const double *centre, const Range &heights,
                                double radius) const noexcept {
    const int dim = shape_.dim;
    int64_t step = shape_.lanes;
    for (int k = shape_.axes; k-- > axis + 1;) {
        step *= shape_.degree(k) + 1;
    }
    const int64_t period = step * (shape_.degree(axis) + 1);
    Range slope{infinity, -infinity};
    double longest = 0, weight = 0;
    for (int64_t i = 0; i < shape_.values(); i += shape_.lanes) {
        if (i % period + step >= period) {
            continue;
        }
        const double *q = patch_ + i, *next = q + step;
        const double dw = next[dim] - q[dim];
        double sum = 0, square = 0;
        for (int c = 0; c < dim; ++c) {
            const double e = (next[c] - q[c]) - centre[c] * dw;
            sum += centre[c] * e;
            square += e * e;
        }
        slope.add(sum);
        longest = std::max(longest, std::sqrt(square));
        weight = std::max(weight, std::abs(dw));
    }
    const double rounding = (8 + dim) * eps * reach_, off = moved_ + rounding;
    const double away = radius + 2 * off;
    const double along = heights.size() + 2 * off * reach_ + away * away;
    const double error = 2.2 * reach_ * (moved_ + 2 * rounding) * most_weight_ +
                         1.01 * away * (longest + 2 * off * most_weight_) +
                         1.01 * along * (weight + 2 * eps * most_weight_);
    return slope.low > error || slope.high < -error;
}

double PatchSlopes::off() const noexcept {
    return 2 * error_ / (least_weight_ * least_weight_);
}

double PatchSlopes::least() const noexcept {
    return std::sqrt(std::max(0.0, least_ - off())) * (1 - 4 * eps);
}

double PatchSlopes::most() const noexcept {
    return std::sqrt(most_ + off()) * (1 + 4 * eps);
}

double PatchSlopes::spread() const noexcept {
    return std::sqrt(most_) - std::sqrt(std::max(0.0, least_));
}

double PatchSlopes::extent(const double *point) const noexcept {
    double result = 0;
    const double *q = patch_;
    for (int64_t i = 0; i < shape_.coefficients(); ++i, q += shape_.lanes) {
        const double w = q[shape_.dim];
        result = std::max(result, norm_of(shape_.dim, [&](int c) { return q[c] / w - point[c]; }));
    }
    return result;
}

PatchSlopes::Range PatchSlopes::second(int k, int l) const {
    const int64_t s = step(k), t = step(l);
    std::array<int, max_axes> shrink{};
    ++shrink[static_cast<size_t>(k)];
    ++shrink[static_cast<size_t>(l)];
    Range range{infinity, -infinity};
    for_products(shrink, [&](int64_t at) {
        const auto twice = [&](const double *g) { return (g[at + s + t] - g[at + s]) - (g[at + t] - g[at]); };
        const double d = twice(squares_), w = twice(weights_);
        range.add(d - least_ * w);
        range.add(d - most_ * w);
    });
    return range;
}

// w^2 d_kl phi = (d_kl |Q|^2 - phi d_kl w^2) - d_k phi d_l w^2 - d_l phi d_k w^2. By the mean value theorem,
// the difference of the gradients at two points is the product of a matrix in this interval matrix with the
// difference of the points. The gradient is therefore injective if all these matrices are regular. They are
// if, after multiplication by the inverse of the centre, they differ from the identity by less than 1 in the
// maximum norm.
PatchSlopes::Matrix PatchSlopes::matrix() noexcept {
    AxisMatrix centre{}, radius{};
    double bend = -1;
    for (int k = 0; k < shape_.axes; ++k) {
        for (int l = 0; l <= k; ++l) {
            const auto i = static_cast<size_t>(k), j = static_cast<size_t>(l);
            const double n =
                2 * shape_.degree(k) * (k == l ? 2 * shape_.degree(k) - 1 : 2 * shape_.degree(l));
            const Range range = second(k, l);
            const double more =
                first_[i].size() * weight_slopes_[j] + first_[j].size() * weight_slopes_[i] + 4 * error_ * n;
            centre[i][j] = centre[j][i] = n * (range.low / 2 + range.high / 2);
            radius[i][j] = radius[j][i] = n * (range.high / 2 - range.low / 2) + more;
            if (k == l && n * range.size() > bend) {
                bend = n * range.size();
                widest_ = k;
            }
        }
    }
    const std::optional<AxisMatrix> factor = inverse(shape_.axes, centre);
    if (!factor) {
        return Matrix::singular;
    }
    const double rounding = 64 * eps * product_norm(shape_.axes, *factor, centre);
    const double rest = product_norm(shape_.axes, *factor, radius) + rounding;
    return rest < 1 ? Matrix::regular : Matrix::unknown;
}

} // namespace nrb::closest
