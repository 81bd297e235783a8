// SPDX-License-Identifier: MIT
#include "fit/axis_interpolation.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "basis/bspline.h"
#include "numeric/solvers/banded_least_squares.h"

#include <algorithm>

namespace nrb::fit {

AxisInterpolation::AxisInterpolation(KnotVectorPtr knots, std::vector<Condition> conditions, int axis)
    : knots_(std::move(knots)), conditions_(std::move(conditions)), axis_(axis) {
    const bool values_only =
        std::ranges::all_of(conditions_, [](const Condition &condition) { return condition.order == 0; });
    if (values_only && !knots_->periodic()) {
        factor();
    }
}

int64_t AxisInterpolation::next_function(int64_t i, int64_t first) const noexcept {
    const double t = conditions_[static_cast<size_t>(i)].param;
    const int p = knots_->degree();
    int64_t span = first + p;
    const int64_t last = knots_->count() - 1;
    while (span < last && ((*knots_)[span + 1] <= t || (*knots_)[span + 1] == (*knots_)[span])) {
        ++span;
    }
    while (span > p && (*knots_)[span] == (*knots_)[span + 1]) { // the end of the domain
        --span;
    }
    return span - p;
}

void AxisInterpolation::read(int64_t i, int64_t first, double *values) const noexcept {
    const auto [t, order] = conditions_[static_cast<size_t>(i)];
    const int p = knots_->degree();
    if (order == 0) {
        return basis_values(knots_->knots().data(), p, first + p, t, values);
    }
    double derivatives[max_basis * max_basis];
    basis_derivs(knots_->knots().data(), p, first + p, t, order, derivatives);
    std::copy_n(derivatives + order * (p + 1), p + 1, values);
}

// A function is 0 at the first knot of its support, but for the first one of a clamped end.
void AxisInterpolation::check_support(int64_t i, int64_t first) const {
    const int p = knots_->degree();
    double values[max_basis];
    read(i, first, values);
    if (i >= first && i <= first + p && values[i - first] > 0) {
        return;
    }
    fail(Status::schoenberg_whitney,
         "params[%lld] = %s on axis %d is outside (%s, %s), between knots %lld and %lld, the support of "
         "control point "
         "%lld",
         static_cast<long long>(i), Number(conditions_[static_cast<size_t>(i)].param).text, axis_,
         Number((*knots_)[i]).text, Number((*knots_)[i + p + 1]).text, static_cast<long long>(i),
         static_cast<long long>(i + p + 1), static_cast<long long>(i));
}

void AxisInterpolation::factor() {
    const int p = knots_->degree();
    int64_t below = 0, above = 0, first = 0;
    for (int64_t i = 0; i < conditions(); ++i) {
        first = next_function(i, first);
        const bool on_knot = conditions_[static_cast<size_t>(i)].param == (*knots_)[first + p];
        if (i <= first || i >= first + p || on_knot) { // else it is inside the support for certain
            check_support(i, first);
        }
        below = std::max(below, i - first);
        above = std::max(above, first + p - i);
    }
    direct_.emplace(conditions(), static_cast<int>(below), static_cast<int>(above));
    first = 0;
    for (int64_t i = 0; i < conditions(); ++i) {
        count_work(int64_t{4} * (p + 1) * (p + 1));
        first = next_function(i, first);
        read(i, first, direct_->row(i) + (first - (i - below)));
    }
    if (!direct_->factor()) {
        fail(Status::rank, "params: the interpolation on axis %d is singular to working precision", axis_);
    }
}

void AxisInterpolation::solve(std::vector<double> &values, int64_t width) const {
    const auto last = static_cast<size_t>((conditions() - 1) * width);
    const std::vector<double> start(values.begin(), values.begin() + width),
        end(values.begin() + last, values.end());
    if (direct_.has_value()) {
        direct_->solve(values.data(), width);
    } else {
        rotate(values, width);
    }
    const auto [lower, upper] = knots_->domain();
    const auto value_at = [](const Condition &condition, double t) {
        return condition.param == t && condition.order == 0;
    };
    if (knots_->clamped_start() && value_at(conditions_.front(), lower)) {
        std::ranges::copy(start, values.begin());
    }
    if (knots_->clamped_end() && value_at(conditions_.back(), upper)) {
        std::ranges::copy(end, values.begin() + last);
    }
}

// Rows are divided by their largest entry: derivatives of high order would outweigh the values else.
void AxisInterpolation::rotate(std::vector<double> &values, int64_t width) const {
    const int p = knots_->degree();
    const int64_t columns = conditions();
    const int border = knots_->periodic() ? static_cast<int>(std::min<int64_t>(p, columns)) : 0;
    BandedLeastSquares system(columns, p + 1, border, width);
    std::vector<double> right(static_cast<size_t>(width));
    int64_t first = 0;
    for (int64_t i = 0; i < columns; ++i) {
        first = next_function(i, first);
        double row[max_basis];
        read(i, first, row);
        double largest = 0;
        std::for_each_n(row, p + 1, [&](double x) { largest = std::max(largest, std::abs(x)); });
        const double scale = largest > 0 ? 1 / largest : 1;
        for (int j = 0; j <= p; ++j) {
            system.enter((first + j) % columns, row[j] * scale);
        }
        std::transform(values.begin() + i * width, values.begin() + (i + 1) * width, right.begin(),
                       [scale](double x) { return x * scale; });
        system.add_entered(right.data());
    }
    if (!system.solve(values.data())) {
        fail(Status::rank, "params: the conditions on axis %d do not determine the control points", axis_);
    }
}

} // namespace nrb::fit
