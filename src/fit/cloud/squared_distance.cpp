// SPDX-License-Identifier: MIT
#include "fit/cloud/squared_distance.h"

#include "numeric/norm.h"

#include <algorithm>

namespace nrb::fit {

SquaredDistance::SquaredDistance(int axes, int dim)
    : axes_(axes), dim_(dim), frame_(static_cast<size_t>(axes * dim)),
      matrix_(static_cast<size_t>(dim * (dim + 1) / 2)), force_(static_cast<size_t>(dim)) {}

const double *SquaredDistance::tangent(size_t axis) const noexcept {
    eval::Orders orders{};
    orders[axis] = 1;
    return derivatives_ + eval::slot(axes_, orders) * dim_;
}

double SquaredDistance::curvature(size_t a, size_t b, const double *r) const noexcept {
    eval::Orders orders{};
    ++orders[a];
    ++orders[b];
    return dot(r, derivatives_ + eval::slot(axes_, orders) * dim_, dim_);
}

// Gram-Schmidt orthogonalisation, twice; false for a tangent that depends linearly on those of other axes, up
// to rounding.
bool SquaredDistance::add_tangent(size_t axis) noexcept {
    constexpr double least = 0x1p-40;
    const double *given = tangent(axis);
    double *own = frame_.data() + found_ * static_cast<size_t>(dim_);
    const double size = norm(given, dim_);
    std::copy_n(given, dim_, own);
    AxisVector &row = factor_[found_];
    row = {};
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t j = 0; j < found_; ++j) {
            const double *other = frame_.data() + j * static_cast<size_t>(dim_);
            const double part = dot(own, other, dim_);
            row[j] += part;
            for (int c = 0; c < dim_; ++c) {
                own[c] -= part * other[c];
            }
        }
    }
    const double rest = norm(own, dim_);
    if (!(rest > least * size)) {
        return false;
    }
    for (int c = 0; c < dim_; ++c) {
        own[c] /= rest;
    }
    row[found_] = rest;
    axis_of_[found_++] = axis;
    return true;
}

// The matrix K, the solution of F K F^T = -(r.s_ab) with F = factor_.
AxisMatrix SquaredDistance::bends(const double *r) const noexcept {
    AxisMatrix k{};
    for (size_t i = 0; i < found_; ++i) {
        for (size_t j = 0; j < found_; ++j) {
            k[i][j] = -curvature(axis_of_[i], axis_of_[j], r);
        }
    }
    const auto reduce = [&](auto &&element) { // by F^-1 from the left
        for (size_t j = 0; j < found_; ++j) {
            for (size_t i = 0; i < found_; ++i) {
                for (size_t m = 0; m < i; ++m) {
                    element(i, j) -= factor_[i][m] * element(m, j);
                }
                element(i, j) /= factor_[i][i];
            }
        }
    };
    reduce([&](size_t i, size_t j) -> double & { return k[i][j]; });
    reduce([&](size_t i, size_t j) -> double & { return k[j][i]; });
    return k;
}

void SquaredDistance::combine(const AxisMatrix &slide, const double *r) noexcept {
    size_t place = 0;
    std::ranges::fill(force_, 0.0);
    const auto width = static_cast<size_t>(dim_);
    for (size_t a = 0; a < width; ++a) {
        for (size_t b = 0; b <= a; ++b) {
            double value = a == b ? 1 : 0;
            for (size_t i = 0; i < found_; ++i) {
                for (size_t j = 0; j < found_; ++j) {
                    value -= slide[i][j] * frame_[i * width + a] * frame_[j * width + b];
                }
            }
            matrix_[place++] = value;
            force_[a] += value * r[b];
            if (a != b) {
                force_[b] += value * r[a];
            }
        }
    }
}

void SquaredDistance::set(const double *derivatives, const std::array<bool, max_axes> &stays,
                          const double *r) noexcept {
    derivatives_ = derivatives;
    found_ = 0;
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        if (!stays[k]) {
            (void)add_tangent(k);
        }
    }
    const AxisMatrix bent = bends(r);
    const bool finite = std::ranges::all_of(bent, [](const AxisVector &row) {
        return std::ranges::all_of(row, [](double x) { return std::isfinite(x); });
    });
    const int n = static_cast<int>(found_);
    combine(inverse_of_positive_part(n, finite ? bent : AxisMatrix{}), r);
}

} // namespace nrb::fit
