// SPDX-License-Identifier: MIT
#include "fit/least_squares/penalised_system.h"

#include "base/error.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::fit {

namespace {

// Factorisations of more multiply-adds than this are not repeated in double-double precision, which takes 20
// times as long.
constexpr double most_precise_work = 1e7;
// Pivots relative to the diagonal: below the first value factors in double precision are rejected, below the
// second nothing is known of double-double ones. The third value is the accuracy of the sums
// (normal_equations.h).
constexpr double least_pivot = 0x1p-36, least_precise_pivot = 0x1p-92, noise_of_sums = 0x1p-56;

std::vector<double> diagonal_of(const ColumnsOf<DoubleDouble> &columns) {
    std::vector<double> diagonal;
    for (int64_t j = 0; j < columns.size(); ++j) {
        const auto first = columns.rows.begin() + columns.starts[static_cast<size_t>(j)];
        const auto end = columns.rows.begin() + columns.starts[static_cast<size_t>(j) + 1];
        const auto found = std::lower_bound(first, end, static_cast<int32_t>(j));
        diagonal.push_back(columns.values[static_cast<size_t>(found - columns.rows.begin())].high);
    }
    return diagonal;
}

double trace_of(const ColumnsOf<DoubleDouble> &columns) {
    const std::vector<double> diagonal = diagonal_of(columns);
    return std::accumulate(diagonal.begin(), diagonal.end(), 0.0);
}

SparseColumns rounded(const ColumnsOf<DoubleDouble> &columns) {
    SparseColumns result{columns.starts, columns.rows, {}};
    result.values.reserve(columns.values.size());
    for (const DoubleDouble &value : columns.values) {
        result.values.push_back(value.high);
    }
    return result;
}

// y = right - matrix x; the columns of a symmetric matrix are its rows.
std::vector<DoubleDouble> residual_of(const ColumnsOf<DoubleDouble> &matrix,
                                      const std::vector<DoubleDouble> &right,
                                      const std::vector<DoubleDouble> &x, int64_t width) {
    std::vector<DoubleDouble> y = right;
    for (int64_t j = 0; j < matrix.size(); ++j) {
        const int64_t first = matrix.starts[static_cast<size_t>(j)],
                      end = matrix.starts[static_cast<size_t>(j) + 1];
        count_work(24 * width * (end - first));
        DoubleDouble *const out = y.data() + j * width;
        for (int64_t p = first; p < end; ++p) {
            const DoubleDouble value = matrix.values[static_cast<size_t>(p)];
            const DoubleDouble *const from = x.data() + int64_t{matrix.rows[static_cast<size_t>(p)]} * width;
            for (int64_t c = 0; c < width; ++c) {
                out[c] = out[c] - value * from[c];
            }
        }
    }
    return y;
}

// Row i of the result is row order[i] of x[unknowns][width].
std::vector<DoubleDouble> permuted(const std::vector<DoubleDouble> &x, const std::vector<int64_t> &order,
                                   int64_t width) {
    std::vector<DoubleDouble> result;
    result.reserve(x.size());
    for (const int64_t i : order) {
        result.insert(result.end(), x.begin() + i * width, x.begin() + (i + 1) * width);
    }
    return result;
}

double largest(const std::vector<DoubleDouble> &x, int64_t first, int64_t width) noexcept {
    double most = 0;
    for (int64_t i = first; i < std::ssize(x); i += width) {
        most = std::max(most, std::abs(x[static_cast<size_t>(i)].high));
    }
    return most;
}

} // namespace

PenalisedSystem::PenalisedSystem(const NormalEquations &equations, const StencilMatrix *penalty)
    : equations_(equations), order_(equations.matrix.elimination_order()), place_(order_.size()),
      data_(equations.matrix.columns(order_)), sum_(data_) {
    for (size_t i = 0; i < order_.size(); ++i) {
        place_[static_cast<size_t>(order_[i])] = static_cast<int64_t>(i);
    }
    if (penalty != nullptr) {
        smooth_ = penalty->columns(order_);
    }
}

void PenalisedSystem::set_matrix(const StencilMatrix &matrix) {
    data_ = matrix.columns(order_);
    sum_ = data_;
}

double PenalisedSystem::limited(double lambda) const {
    constexpr double stiffest = 0x1p64; // penalties are off by 2^-95
    const double data = trace_of(data_), smooth = trace_of(smooth_);
    return smooth > 0 ? std::min(lambda, stiffest * data / smooth) : lambda;
}

void PenalisedSystem::factorise(double lambda) {
    if (const int64_t unknown = try_factorise(lambda); unknown >= 0) {
        fail_rank(unknown);
    }
}

int64_t PenalisedSystem::try_factorise(double lambda) {
    lambda_ = smooth_.values.empty() ? 0 : lambda;
    for (size_t e = 0; e < smooth_.values.size(); ++e) {
        sum_.values[e] = data_.values[e] + DoubleDouble(lambda_) * smooth_.values[e];
    }
    const int64_t bad = factorise_in_double();
    in_double_ = bad < 0;
    if (in_double_ || factors_->cost() > most_precise_work) {
        return bad;
    }
    return factorise_precisely();
}

int64_t PenalisedSystem::try_factorise_surely(double lambda) {
    const int64_t bad = try_factorise(lambda);
    if (bad >= 0 || factors_->cost() > most_precise_work) {
        return bad;
    }
    return in_double_ ? unsure_pivot(*factors_) : unsure_pivot(*precise_);
}

// Pivot k is v^T A v with v = L^-T e_k, whose element k is 1 and whose later elements are 0. An error of an
// element of A therefore enters the pivot multiplied by the product of two elements of v. Only pivots that
// are small relative to their diagonal element can be lost in such errors.
template <class Number>
int64_t PenalisedSystem::unsure_pivot(const LdltOf<Number> &factors) const {
    constexpr double suspicious = 0x1p-16, noise = 0x1p-58;
    const std::vector<double> diagonal = diagonal_of(sum_);
    for (size_t k = 0; k < diagonal.size(); ++k) {
        const double pivot = DoubleDouble(factors.diagonal()[k]).high;
        if (pivot > suspicious * diagonal[k]) {
            continue;
        }
        std::vector<double> v(k + 1, 0.0);
        v[k] = 1;
        double sum = 0;
        for (size_t j = k + 1; j-- > 0;) {
            for (auto p = static_cast<size_t>(factors.starts()[j]);
                 p < static_cast<size_t>(factors.starts()[j + 1]); ++p) {
                const auto row = static_cast<size_t>(factors.rows()[p]);
                v[j] -= row <= k ? DoubleDouble(factors.values()[p]).high * v[row] : 0;
            }
            sum += std::abs(v[j]) * std::sqrt(equations_.support[static_cast<size_t>(order_[j])]);
        }
        if (!(pivot > noise * sum * sum)) {
            return order_[k];
        }
    }
    return -1;
}

int64_t PenalisedSystem::factorise_in_double() {
    std::vector<double> floors = diagonal_of(sum_);
    for (double &floor : floors) {
        floor *= least_pivot;
    }
    const SparseColumns sum = rounded(sum_);
    if (!factors_) {
        factors_.emplace(sum);
    }
    const int64_t bad = factors_->factorise(sum, floors);
    return bad < 0 ? -1 : order_[static_cast<size_t>(bad)];
}

int64_t PenalisedSystem::factorise_precisely() {
    std::vector<double> floors = diagonal_of(sum_);
    for (size_t i = 0; i < floors.size(); ++i) {
        floors[i] = least_precise_pivot * floors[i] +
                    noise_of_sums * equations_.support[static_cast<size_t>(order_[i])];
    }
    if (!precise_) {
        precise_.emplace(sum_);
    }
    const int64_t bad = precise_->factorise(sum_, floors);
    return bad < 0 ? -1 : order_[static_cast<size_t>(bad)];
}

void PenalisedSystem::fail_rank(int64_t unknown) const {
    char text[96] = "";
    int length = 0;
    int64_t rest = unknown, index[max_axes] = {};
    for (size_t k = equations_.axes.size(); k-- > 0;) {
        index[k] = rest % equations_.axes[k]->distinct_layers();
        rest /= equations_.axes[k]->distinct_layers();
    }
    for (size_t k = 0; k < equations_.axes.size() && length < 64; ++k) {
        const KnotVector &axis = *equations_.axes[k];
        length += std::snprintf(text + length, sizeof text - static_cast<size_t>(length), "%s[%s, %s]",
                                k > 0 ? " x " : "", Number(axis[index[k]]).text,
                                Number(axis[index[k] + axis.degree() + 1]).text);
    }
    fail(Status::rank,
         "the data do not determine control point %lld, whose function lives on %s; those before it are "
         "determined",
         static_cast<long long>(unknown), text);
}

PenalisedSystem::Numbers PenalisedSystem::ordered(const Numbers &x, int64_t width) const {
    return permuted(x, order_, width);
}

PenalisedSystem::Numbers PenalisedSystem::restored(const Numbers &x, int64_t width) const {
    return permuted(x, place_, width);
}

// Replaces the residual by the correction that the factors give for it.
void PenalisedSystem::correct(Numbers &residual, int64_t width) const {
    if (!in_double_) {
        return precise_->solve(residual.data(), width);
    }
    std::vector<double> x;
    x.reserve(residual.size());
    for (const DoubleDouble &value : residual) {
        x.push_back(value.high);
    }
    factors_->solve(x.data(), width);
    std::copy(x.begin(), x.end(), residual.begin());
}

// Iterative refinement, until a correction is below 2^-64 of the solution, or not less than half of the one
// before it. Returns whether the last correction is below 2^-50.
bool PenalisedSystem::refine(const Numbers &right, int64_t width, Numbers &x) const {
    constexpr double enough = 0x1p-64, least = 0x1p-50;
    constexpr int most = 40;
    Numbers residual = right;
    double before = 0;
    x.assign(right.size(), DoubleDouble{});
    for (int step = 0; step < most; ++step) {
        correct(residual, width);
        double change = 0;
        for (size_t i = 0; i < x.size(); ++i) {
            x[i] = x[i] + residual[i];
        }
        for (int64_t c = 0; c < width; ++c) {
            const double size = largest(x, c, width), part = largest(residual, c, width);
            change = std::max(change, size > 0 ? part / size : 0);
        }
        if (!(change > enough)) {
            return change <= enough;
        }
        if (step > 1 && !(change < before / 2)) {
            return change <= least;
        }
        before = change;
        residual = residual_of(sum_, right, x, width);
    }
    return before <= least;
}

PenalisedSystem::Numbers PenalisedSystem::solve(const Numbers &right, int64_t width) {
    const Numbers own = ordered(right, width);
    Numbers x;
    if (!refine(own, width, x) && in_double_ && factors_->cost() <= most_precise_work) {
        in_double_ = false;
        if (const int64_t unknown = factorise_precisely(); unknown >= 0) {
            fail_rank(unknown);
        }
        (void)refine(own, width, x);
    }
    return restored(x, width);
}

PenalisedSystem::Numbers PenalisedSystem::estimate() {
    if (!in_double_) {
        return solve(equations_.right, equations_.dim);
    }
    Numbers x = ordered(equations_.right, equations_.dim);
    correct(x, equations_.dim);
    return restored(x, equations_.dim);
}

PenalisedSystem::Numbers PenalisedSystem::product(const Numbers &x, int64_t width) const {
    Numbers image = restored(residual_of(data_, Numbers(x.size()), ordered(x, width), width), width);
    for (DoubleDouble &value : image) {
        value = -value;
    }
    return image;
}

PenalisedSystem::Numbers PenalisedSystem::missing(const Numbers &x) const {
    const int dim = equations_.dim;
    return restored(residual_of(data_, ordered(equations_.right, dim), ordered(x, dim), dim), dim);
}

// s - x^T r - x^T (r - G x) with the sum s of the squares of the data; the terms may cancel almost
// completely.
double PenalisedSystem::remaining_squares(const Numbers &x) const {
    const Numbers rest = missing(x);
    DoubleDouble sum;
    for (const DoubleDouble &square : equations_.squares) {
        sum = sum + square;
    }
    for (size_t i = 0; i < x.size(); ++i) {
        sum = sum - x[i] * (equations_.right[i] + rest[i]);
    }
    return std::max(sum.high, 0.0);
}

double PenalisedSystem::relative_residual(const Numbers &x) const {
    const int dim = equations_.dim;
    const auto length = [](const Numbers &values) {
        std::vector<double> rounded;
        rounded.reserve(values.size());
        for (const DoubleDouble &value : values) {
            rounded.push_back(value.high);
        }
        return norm(rounded.data(), static_cast<int>(rounded.size()));
    };
    const double size = length(equations_.right);
    const double rest = length(residual_of(sum_, ordered(equations_.right, dim), ordered(x, dim), dim));
    return size > 0 ? rest / size : rest;
}

SelectedInverse PenalisedSystem::inverse() const {
    return in_double_ ? SelectedInverse(*factors_) : SelectedInverse(*precise_);
}

PenalisedSystem::Freedom PenalisedSystem::freedom() const {
    const SelectedInverse all = inverse();
    const double unknowns = static_cast<double>(order_.size());
    return {all.trace_of_product(rounded(data_)), std::abs(all.trace_of_product(rounded(sum_)) - unknowns)};
}

double PenalisedSystem::trace_with(const StencilMatrix &matrix) const {
    return inverse().trace_of_product(rounded(matrix.columns(order_)));
}

double PenalisedSystem::log_determinant() const {
    double sum = 0;
    if (in_double_) {
        for (const double pivot : factors_->diagonal()) {
            sum += std::log(pivot);
        }
    } else {
        for (const DoubleDouble &pivot : precise_->diagonal()) {
            sum += std::log(pivot.high);
        }
    }
    return sum;
}

} // namespace nrb::fit
