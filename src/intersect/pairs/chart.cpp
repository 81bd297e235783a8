// SPDX-License-Identifier: MIT
#include "intersect/pairs/chart.h"

#include "intersect/extent.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

// M is the pseudoinverse of (u, -v), the mean derivatives of both. False if they are nearly parallel, or one
// is 0.
bool Chart::set_rows(const double *u, const double *v) {
    const double uu = dot(u, u, dim_), vv = dot(v, v, dim_), uv = dot(u, v, dim_);
    const double determinant = uu * vv - uv * uv;
    sine_ = uu * vv > 0 ? determinant / (uu * vv) : 0;
    if (!(determinant > 1e-14 * uu * vv)) {
        return false;
    }
    const auto size = static_cast<size_t>(dim_);
    rows_.resize(2 * size);
    for (size_t c = 0; c < size; ++c) {
        rows_[c] = (vv * u[c] - uv * v[c]) / determinant;
        rows_[size + c] = (uv * u[c] - uu * v[c]) / determinant;
    }
    turn_ = dim_ != 2 ? 0 : u[0] * v[1] - u[1] * v[0] > 0 ? 1 : -1;
    return true;
}

void Chart::set(const pieces::Slopes &a, const pieces::Slopes &b, int dim) {
    dim_ = dim;
    turn_ = 0;
    contraction_ = {};
    if (!set_rows(a.mean(), b.mean())) {
        return;
    }
    contraction_.rho = 0;
    for (size_t k = 0; k < 2; ++k) {
        const double length = norm(row(k), dim);
        double of_a = 0, of_b = 0;
        for (size_t i = 0; i < a.count(); ++i) {
            of_a = std::max(of_a, std::abs(dot(row(k), a.vector(i), dim) - (k == 0 ? 1 : 0)));
        }
        for (size_t j = 0; j < b.count(); ++j) {
            of_b = std::max(of_b, std::abs(dot(row(k), b.vector(j), dim) + (k == 1 ? 1 : 0)));
        }
        contraction_.rho = std::max(contraction_.rho,
                                    of_a + of_b + 1.01 * length * (a.error() + b.error()) + 64 * dim * eps);
        contraction_.norm = std::max(contraction_.norm, length);
    }
}

bool Chart::excludes(const pieces::BezierPiece &a, const pieces::BezierPiece &b, double near) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const Interval of_a = extent_along(a, row(k)), of_b = extent_along(b, row(k));
        const double size = std::max(
            {std::abs(of_a.lower), std::abs(of_a.upper), std::abs(of_b.lower), std::abs(of_b.upper)});
        if (std::max(of_a.lower - of_b.upper, of_b.lower - of_a.upper) >
            1.0001 * contraction_.norm * (near + a.moved() + b.moved()) +
                4 * dim_ * eps * (size + contraction_.norm)) {
            return true;
        }
    }
    return false;
}

Place<2> Chart::step(const double *difference) const noexcept {
    return {dot(row(0), difference, dim_), dot(row(1), difference, dim_)};
}

} // namespace nrb::intersect
