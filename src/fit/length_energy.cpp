// SPDX-License-Identifier: MIT
#include "fit/length_energy.h"

#include "fit/least_squares/penalty.h"
#include "numeric/direction.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::fit {

Bending::Bending(const KnotVectorPtr &knots) {
    const StencilMatrix form = penalty({knots}, 2);
    std::vector<int64_t> order(static_cast<size_t>(form.size()));
    std::iota(order.begin(), order.end(), 0);
    columns_ = form.columns(order);
}

std::vector<double> Bending::operator()(const std::vector<double> &layers, int64_t width) const {
    std::vector<double> result(layers.size());
    for (int64_t j = 0; j < columns_.size(); ++j) {
        const auto from = static_cast<size_t>(columns_.starts[static_cast<size_t>(j)]),
                   end = static_cast<size_t>(columns_.starts[static_cast<size_t>(j) + 1]);
        for (size_t e = from; e < end; ++e) {
            const double factor = columns_.values[e].value();
            const double *const source = layers.data() + int64_t{columns_.rows[e]} * width;
            std::transform(source, source + width, result.begin() + j * width, result.begin() + j * width,
                           [factor](double x, double sum) { return sum + factor * x; });
        }
    }
    return result;
}

LengthEnergy::LengthEnergy(const AxisInterpolation &axis, std::span<const int64_t> directions, int dim,
                           const std::vector<double> &targets)
    : axis_(axis), where_(directions), dim_(dim), bending_(axis.knots()) {
    const Interval domain = axis.knots()->domain();
    const double length = domain.upper - domain.lower;
    for (const int64_t i : directions) {
        const std::vector<double> unit = unit_vector(targets.data() + i * dim, dim);
        units_.insert(units_.end(), unit.begin(), unit.end());
        scales_.push_back(1 / (length * std::sqrt(length * stiffness_at(i))));
    }
}

std::vector<double> LengthEnergy::slope(std::vector<double> values) const {
    axis_.solve(values, dim_);
    values = bending_(values, dim_);
    axis_.solve_transposed(values, dim_);
    std::vector<double> result;
    for (size_t j = 0; j < where_.size(); ++j) {
        result.push_back(scales_[j] * dot(unit(j), values.data() + where_[j] * dim_, dim_));
    }
    return result;
}

std::vector<double> LengthEnergy::product(const std::vector<double> &u) const {
    std::vector<double> values(static_cast<size_t>(axis_.conditions() * dim_));
    for (size_t j = 0; j < where_.size(); ++j) {
        std::transform(unit(j), unit(j) + dim_, values.begin() + where_[j] * dim_,
                       [factor = u[j] * scales_[j]](double x) { return x * factor; });
    }
    return slope(std::move(values));
}

// The stiffness of the curve against a tangent at condition i: the sum of 1 / h over the nearest other
// parameters on both sides, at distances h; at least 1 over the length of the domain.
double LengthEnergy::stiffness_at(int64_t i) const noexcept {
    const double t = axis_.sites().param(i);
    int64_t before = i, after = i;
    while (before >= 0 && axis_.sites().param(before) == t) {
        --before;
    }
    while (after < axis_.conditions() && axis_.sites().param(after) == t) {
        ++after;
    }
    const double sum = (before >= 0 ? 1 / (t - axis_.sites().param(before)) : 0) +
                       (after < axis_.conditions() ? 1 / (axis_.sites().param(after) - t) : 0);
    const Interval domain = axis_.knots()->domain();
    return std::max(sum, 1 / (domain.upper - domain.lower));
}

} // namespace nrb::fit
