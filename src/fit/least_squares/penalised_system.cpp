// SPDX-License-Identifier: MIT
#include "fit/least_squares/penalised_system.h"

#include "base/error.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

// Pivots relative to the diagonal below which factors in double precision are not tried, and below which nothing is known of
// those with twice the precision; and how exact the sums of functions are (normal_equations.h).
constexpr double least_pivot = 0x1p-36, least_precise_pivot = 0x1p-92, noise_of_sums = 0x1p-56;

template <class Number>
std::vector<double> diagonal_of(const ColumnsOf<Number> &columns) {
    std::vector<double> diagonal;
    for (int64_t j = 0; j < columns.size(); ++j) {
        const auto first = columns.rows.begin() + columns.starts[static_cast<size_t>(j)];
        const auto end = columns.rows.begin() + columns.starts[static_cast<size_t>(j) + 1];
        const auto found = std::lower_bound(first, end, static_cast<int32_t>(j));
        diagonal.push_back(DoubleDouble(columns.values[static_cast<size_t>(found - columns.rows.begin())]).high);
    }
    return diagonal;
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
    : equations_(equations), penalty_(penalty), order_(equations.matrix.elimination_order()),
      place_(order_.size()), data_(equations.matrix.columns<double>(order_)) {
    for (size_t i = 0; i < order_.size(); ++i) {
        place_[static_cast<size_t>(order_[i])] = static_cast<int64_t>(i);
    }
    if (penalty != nullptr) {
        smooth_ = penalty->columns<double>(order_);
    }
    factors_.emplace(data_);
}

void PenalisedSystem::factorise(double lambda) {
    lambda_ = penalty_ == nullptr ? 0 : lambda;
    in_double_ = factorise_in_double();
    if (!in_double_) {
        factorise_precisely();
    }
}

bool PenalisedSystem::factorise_in_double() {
    SparseColumns sum = data_;
    for (size_t e = 0; lambda_ > 0 && e < sum.values.size(); ++e) {
        sum.values[e] += lambda_ * smooth_.values[e];
    }
    std::vector<double> floors = diagonal_of(sum);
    for (double &floor : floors) {
        floor *= least_pivot;
    }
    return factors_->factorise(sum, floors) < 0;
}

void PenalisedSystem::factorise_precisely() {
    StencilMatrix sum = equations_.matrix;
    if (lambda_ > 0) {
        sum.add(*penalty_, lambda_);
    }
    const auto columns = sum.columns<DoubleDouble>(order_);
    std::vector<double> floors = diagonal_of(columns);
    for (size_t i = 0; i < floors.size(); ++i) {
        floors[i] = least_precise_pivot * floors[i] +
                    noise_of_sums * equations_.support[static_cast<size_t>(order_[i])];
    }
    if (!precise_) {
        precise_.emplace(columns);
    }
    if (const int64_t bad = precise_->factorise(columns, floors); bad >= 0) {
        fail_rank(order_[static_cast<size_t>(bad)]);
    }
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
    fail(Status::rank, "the data do not determine control point %lld, whose function lives on %s; those before it are "
                       "determined",
         static_cast<long long>(unknown), text);
}

template <class T>
std::vector<T> PenalisedSystem::ordered(const std::vector<DoubleDouble> &x, int64_t width) const {
    std::vector<T> result(x.size());
    for (size_t i = 0; i < order_.size(); ++i) {
        for (int64_t c = 0; c < width; ++c) {
            const DoubleDouble &value = x[static_cast<size_t>(order_[i] * width + c)];
            if constexpr (std::is_same_v<T, double>) {
                result[i * static_cast<size_t>(width) + static_cast<size_t>(c)] = value.high;
            } else {
                result[i * static_cast<size_t>(width) + static_cast<size_t>(c)] = value;
            }
        }
    }
    return result;
}

// The residual becomes what the factors make of it.
void PenalisedSystem::correct(std::vector<DoubleDouble> &residual, int64_t width) const {
    const auto put = [&](const auto &x) {
        for (size_t i = 0; i < order_.size(); ++i) {
            for (int64_t c = 0; c < width; ++c) {
                residual[static_cast<size_t>(order_[i] * width + c)] =
                    x[i * static_cast<size_t>(width) + static_cast<size_t>(c)];
            }
        }
    };
    if (in_double_) {
        auto x = ordered<double>(residual, width);
        factors_->solve(x.data(), width);
        put(x);
    } else {
        auto x = ordered<DoubleDouble>(residual, width);
        precise_->solve(x.data(), width);
        put(x);
    }
}

void PenalisedSystem::multiply(const std::vector<DoubleDouble> &x, int64_t width,
                               std::vector<DoubleDouble> &y) const {
    equations_.matrix.multiply(x, width, y);
    if (lambda_ > 0) {
        std::vector<DoubleDouble> smooth;
        penalty_->multiply(x, width, smooth);
        for (size_t i = 0; i < y.size(); ++i) {
            y[i] = y[i] + DoubleDouble(lambda_) * smooth[i];
        }
    }
}

// Until a correction is below 2^-64 of the solution, or no smaller than half of the one before it; true if that is below
// 2^-50.
bool PenalisedSystem::refine(const std::vector<DoubleDouble> &right, int64_t width,
                             std::vector<DoubleDouble> &x) const {
    constexpr double enough = 0x1p-64, least = 0x1p-50;
    constexpr int most = 40;
    std::vector<DoubleDouble> residual = right, image;
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
        multiply(x, width, image);
        for (size_t i = 0; i < x.size(); ++i) {
            residual[i] = right[i] - image[i];
        }
    }
    return before <= least;
}

std::vector<DoubleDouble> PenalisedSystem::solve(const std::vector<DoubleDouble> &right, int64_t width) {
    std::vector<DoubleDouble> x;
    if (!refine(right, width, x) && in_double_) {
        in_double_ = false;
        factorise_precisely();
        (void)refine(right, width, x);
    }
    return x;
}

SelectedInverse PenalisedSystem::inverse() const {
    return in_double_ ? SelectedInverse(*factors_) : SelectedInverse(*precise_);
}

double PenalisedSystem::freedom() const {
    return inverse().trace_of_product(data_);
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
