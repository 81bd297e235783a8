// SPDX-License-Identifier: MIT
#include "closest/curve_side.h"

#include "basis/bspline.h"
#include "numeric/binomial.h"
#include "numeric/norm.h"
#include "spline/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

// H_0, H_1, ...: for each derivative a bound on its largest active control point, from the magnitudes of the
// curve's control points. Overwrites `magnitudes`.
std::vector<double> sizes_of(const KnotVector &axis, int64_t span, int order, double *magnitudes) {
    const int p = axis.degree();
    std::vector<double> sizes(static_cast<size_t>(order) + 1, 0);
    for (int k = 0; k <= std::min(order, p); ++k) {
        for (int j = k > 0 ? 0 : p + 1; j <= p - k;
             ++j) { // in place: derivative k has p - k + 1 active points
            const int64_t i = span - p + j;
            magnitudes[j] =
                (p - k + 1) * (magnitudes[j] + magnitudes[j + 1]) / (axis[i + p + 1] - axis[i + k]);
        }
        sizes[static_cast<size_t>(k)] = *std::max_element(magnitudes, magnitudes + p - k + 1);
    }
    return sizes;
}

} // namespace

CurveSide::CurveSide(const Spline &curve, double t, bool left, int order, double accuracy)
    : dim_(curve.dim()) {
    const KnotVector &axis = curve.axis(0);
    const int p = axis.degree();
    const int64_t width = curve.width();
    const int64_t span = axis.find_span(t, left);
    span_ = axis[span + 1] - axis[span];
    std::vector<double> basis(static_cast<size_t>((order + 1) * (p + 1)));
    basis_derivs(axis.knots().data(), p, span, t, order, basis.data());
    std::vector<double> points(static_cast<size_t>((p + 1) * width)),
        records(static_cast<size_t>((order + 1) * width));
    double sizes[max_basis] = {}, weights[max_basis] = {};
    for (int j = 0; j <= p; ++j) {
        double *point = points.data() + j * width;
        curve.record_part(span - p + j, 0, curve.width(), point);
        sizes[j] = norm(point, dim_);
        weights[j] = curve.rational() ? std::abs(point[dim_]) : 1;
    }
    for (int k = 0; k <= order; ++k) {
        contract(basis.data() + int64_t{k} * (p + 1), p + 1, points.data(), width, width,
                 records.data() + k * width);
    }
    const std::vector<double> magnitudes = sizes_of(axis, span, order, sizes);
    if (curve.rational()) {
        divide(records, magnitudes, sizes_of(axis, span, order, weights));
    } else {
        derivs_ = std::move(records);
        errors_ = magnitudes;
    }
    for (int k = 0; k <= order; ++k) {
        errors_[static_cast<size_t>(k)] *= 2 * (accuracy + 2 * k) * std::numeric_limits<double>::epsilon();
    }
}

// The quotient rule, applied to the derivatives and to the bounds on their magnitudes.
void CurveSide::divide(const std::vector<double> &records, const std::vector<double> &sizes,
                       const std::vector<double> &weight_sizes) {
    const int64_t width = dim_ + 1;
    const auto orders = static_cast<int>(sizes.size());
    const double w = records[static_cast<size_t>(dim_)];
    derivs_.resize(static_cast<size_t>(orders * dim_));
    errors_.resize(static_cast<size_t>(orders));
    for (int k = 0; k < orders; ++k) {
        const double *record = records.data() + k * width;
        double *derivative = derivs_.data() + int64_t{k} * dim_;
        std::copy_n(record, dim_, derivative);
        double size = sizes[static_cast<size_t>(k)];
        for (int i = 1; i <= k; ++i) {
            const double factor = binomial(k, i) * records[static_cast<size_t>(i * width + dim_)];
            for (int c = 0; c < dim_; ++c) {
                derivative[c] -= factor * at(k - i)[c];
            }
            size +=
                binomial(k, i) * weight_sizes[static_cast<size_t>(i)] * errors_[static_cast<size_t>(k - i)];
        }
        for (int c = 0; c < dim_; ++c) {
            derivative[c] /= w;
        }
        errors_[static_cast<size_t>(k)] = size / std::abs(w);
    }
}

double CurveSide::length(int k) const noexcept {
    return norm(at(k), dim_);
}

void CurveSide::reverse() noexcept {
    for (int k = 1; k <= order(); k += 2) {
        for (int c = 0; c < dim_; ++c) {
            double &x = derivs_[static_cast<size_t>(k * dim_ + c)];
            x = -x;
        }
    }
}

} // namespace nrb::closest
