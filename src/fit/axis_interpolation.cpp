// SPDX-License-Identifier: MIT
#include "fit/axis_interpolation.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "basis/bspline.h"
#include "numeric/solvers/banded_least_squares.h"

#include <algorithm>
#include <limits>

namespace nrb::fit {

namespace {

// Givens rotations leave residuals of a few eps times the largest control point. Where the control points
// exceed the data by more than this factor, the residuals are too large for the conditions to count as met.
constexpr double most_growth = 0x1p36;

void scale_rows(const std::vector<double> &scales, int64_t width, std::vector<double> &values) noexcept {
    for (size_t i = 0; i < scales.size(); ++i) {
        std::for_each_n(values.begin() + static_cast<std::ptrdiff_t>(i) * width, width,
                        [&](double &x) { x *= scales[i]; });
    }
}

} // namespace

AxisInterpolation::AxisInterpolation(KnotVectorPtr knots, const Sites &sites, int axis)
    : knots_(std::move(knots)), sites_(sites), axis_(axis) {
    const bool values_only = std::ranges::all_of(sites.orders, [](int32_t order) { return order == 0; });
    if (knots_->periodic()) {
        return;
    }
    direct_.emplace(conditions(), knots_->degree() + 1);
    if (values_only) {
        factor_values();
    } else if (!factor_derivatives()) {
        direct_.reset();
    }
}

// With stored factors, enough right-hand sides to fill the vector registers several times over. Rotations
// factorise anew in every call, so that all right-hand sides should go into one.
int64_t AxisInterpolation::best_width() const noexcept {
    constexpr int64_t many = 64;
    return direct_.has_value() ? many : std::numeric_limits<int64_t>::max();
}

int64_t AxisInterpolation::next_function(int64_t i, int64_t first) const noexcept {
    const double t = sites_.param(i);
    const int p = knots_->degree();
    const double *const knots = knots_->knots().data();
    int64_t span = first + p;
    const int64_t last = knots_->count() - 1;
    while (span < last && (knots[span + 1] <= t || knots[span + 1] == knots[span])) {
        ++span;
    }
    while (span > p && knots[span] == knots[span + 1]) { // the end of the domain
        --span;
    }
    return span - p;
}

void AxisInterpolation::read(int64_t i, int64_t first, double *values) const noexcept {
    const double t = sites_.param(i);
    const int order = sites_.order(i), p = knots_->degree();
    const double *const knots = knots_->knots().data();
    if (order == 0) {
        return t == knots[first + p] ? basis_values_at_knot(knots, p, first + p, values)
                                     : basis_values(knots, p, first + p, t, values);
    }
    double derivatives[max_basis * max_basis];
    basis_derivs(knots, p, first + p, t, order, derivatives);
    std::copy_n(derivatives + order * (p + 1), p + 1, values);
}

void AxisInterpolation::fail_outside_support(int64_t i) const {
    const int64_t end = i + knots_->degree() + 1;
    fail(Status::schoenberg_whitney,
         "params[%lld] = %s on axis %d is outside (%s, %s), "
         "between knots %lld and %lld, the support of control point %lld",
         static_cast<long long>(i), Number(sites_.param(i)).text, axis_, Number((*knots_)[i]).text,
         Number((*knots_)[end]).text, static_cast<long long>(i), static_cast<long long>(end),
         static_cast<long long>(i));
}

void AxisInterpolation::factor_values() {
    const int p = knots_->degree();
    int64_t first = 0;
    for (int64_t i = 0; i < conditions(); ++i) {
        count_work(int64_t{4} * (p + 1) * (p + 1));
        first = next_function(i, first);
        double *const row = direct_->next_row(i, first);
        if (row == nullptr) {
            fail_outside_support(i);
        }
        read(i, first, row);
        // A basis function vanishes at the ends of its support, except at a clamped end.
        if (!(row[i - first] > 0)) {
            fail_outside_support(i);
        }
        if (!direct_->factor_row(i)) {
            fail(Status::rank, "params: the interpolation on axis %d is singular to working precision",
                 axis_);
        }
    }
}

// Returns whether elimination without row exchanges is as accurate as rotations.
bool AxisInterpolation::factor_derivatives() {
    constexpr double most = 16; // rows of B-spline values reach as much at some degree
    const int p = knots_->degree();
    int64_t first = 0;
    scales_.reserve(sites_.params.size());
    for (int64_t i = 0; i < conditions(); ++i) {
        count_work(int64_t{8} * (p + 1) * (p + 1));
        first = next_function(i, first);
        double *const row = direct_->next_row(i, first);
        if (row == nullptr) {
            return false;
        }
        scales_.push_back(read_scaled(i, first, row));
        if (!direct_->factor_row(i)) {
            return false;
        }
    }
    return direct_->grows_little(most);
}

double AxisInterpolation::read_scaled(int64_t i, int64_t first, double *values) const noexcept {
    read(i, first, values);
    double largest = 0;
    std::for_each_n(values, knots_->degree() + 1,
                    [&](double x) { largest = std::max(largest, std::abs(x)); });
    const double scale = largest > 0 ? 1 / largest : 1;
    std::for_each_n(values, knots_->degree() + 1, [scale](double &x) { x *= scale; });
    return scale;
}

void AxisInterpolation::solve(std::vector<double> &values, int64_t width) const {
    const int64_t last = (conditions() - 1) * width;
    const std::vector<double> start(values.begin(), values.begin() + width),
        end(values.begin() + last, values.end());
    if (direct_.has_value()) {
        scale_rows(scales_, width, values);
        direct_->solve(values.data(), width);
    } else {
        rotate(values, width);
    }
    const auto [lower, upper] = knots_->domain();
    const auto value_at = [this](int64_t i, double t) {
        return sites_.param(i) == t && sites_.order(i) == 0;
    };
    if (knots_->clamped_start() && value_at(0, lower)) {
        std::ranges::copy(start, values.begin());
    }
    if (knots_->clamped_end() && value_at(conditions() - 1, upper)) {
        std::ranges::copy(end, values.begin() + last);
    }
}

void AxisInterpolation::rotate(std::vector<double> &values, int64_t width) const {
    const int p = knots_->degree();
    const int64_t columns = conditions();
    const int border = knots_->periodic() ? static_cast<int>(std::min<int64_t>(p, columns)) : 0;
    BandedLeastSquares system(columns, p + 1, border, width);
    std::vector<double> right(static_cast<size_t>(width));
    double size = 0;
    int64_t first = 0;
    for (int64_t i = 0; i < columns; ++i) {
        first = next_function(i, first);
        double row[max_basis];
        const double scale = read_scaled(i, first, row);
        for (int j = 0; j <= p; ++j) {
            system.enter((first + j) % columns, row[j]);
        }
        std::transform(values.begin() + i * width, values.begin() + (i + 1) * width, right.begin(),
                       [scale](double x) { return x * scale; });
        size = std::max(size, largest_magnitude(right));
        system.add_entered(right.data());
    }
    if (!system.solve(values.data()) || !(largest_magnitude(values) <= most_growth * size)) {
        fail(Status::rank, "params: the conditions on axis %d do not determine the control points", axis_);
    }
}

void AxisInterpolation::solve_transposed(std::vector<double> &values, int64_t width) const {
    if (direct_.has_value()) {
        direct_->solve_transposed(values.data(), width);
        return scale_rows(scales_, width, values);
    }
    rotate_transposed(values, width);
}

// One equation per layer of control points, in the multipliers of the conditions. A basis function that is
// wrapped round the seam has its conditions at the end of the domain in the border of the matrix.
void AxisInterpolation::rotate_transposed(std::vector<double> &values, int64_t width) const {
    struct Element {
        int64_t condition;
        double value;
    };
    const int p = knots_->degree();
    const int64_t columns = conditions();
    std::vector<std::vector<Element>> functions(static_cast<size_t>(columns + p));
    std::vector<double> scales;
    int64_t first = 0;
    for (int64_t i = 0; i < columns; ++i) {
        first = next_function(i, first);
        double row[max_basis];
        scales.push_back(read_scaled(i, first, row));
        for (int j = 0; j <= p; ++j) {
            functions[static_cast<size_t>(first + j)].push_back({i, row[j]});
        }
    }
    for (size_t j = 0; knots_->periodic() && j < static_cast<size_t>(p); ++j) {
        auto &wrapped = functions[static_cast<size_t>(columns) + j];
        auto &own = functions[j % std::max<size_t>(static_cast<size_t>(columns), 1)];
        own.insert(own.end(), wrapped.begin(), wrapped.end());
    }
    int64_t bandwidth = 1;
    std::for_each_n(functions.begin(), columns,
                    [&](const auto &own) { bandwidth = std::max(bandwidth, std::ssize(own)); });
    // Where the supports reach round the whole period, the conditions of a function are not consecutive.
    const int64_t border = !knots_->periodic() ? 0 : 2 * bandwidth > columns ? columns : bandwidth - 1;
    BandedLeastSquares system(columns, static_cast<int>(bandwidth), static_cast<int>(border), width);
    for (int64_t j = 0; j < columns; ++j) {
        for (const Element &element : functions[static_cast<size_t>(j)]) {
            system.enter(element.condition, element.value);
        }
        system.add_entered(values.data() + j * width);
    }
    if (!system.solve(values.data())) {
        fail(Status::rank, "params: the conditions on axis %d do not determine the control points", axis_);
    }
    scale_rows(scales, width, values);
}

} // namespace nrb::fit
