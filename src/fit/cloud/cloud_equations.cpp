// SPDX-License-Identifier: MIT
#include "fit/cloud/cloud_equations.h"

#include "base/watch.h"
#include "fit/least_squares/penalty.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nrb::fit {

namespace {

int possible_order(const Spline::Axes &axes, int order) noexcept {
    return std::max(1, std::min(order, highest_degree(axes)));
}

std::vector<int64_t> natural_order(int64_t size) {
    std::vector<int64_t> order(static_cast<size_t>(size));
    std::iota(order.begin(), order.end(), int64_t{0});
    return order;
}

} // namespace

// --- The penalty ---

CloudPenalty::CloudPenalty(const Spline::Axes &axes, int order)
    : order_(possible_order(axes, order)), form_(penalty(axes, order_)),
      columns_(form_.columns(natural_order(form_.size()))) {}

// The smallest positive eigenvalue of a bar with free ends, (-1)^m y^(2m) = least y on [0, 1]: exact for
// m = 1, within 2% for m = 2.
double CloudPenalty::least() const noexcept {
    return std::pow((order_ + 1) * std::numbers::pi / 2, 2 * order_);
}

std::vector<double> CloudPenalty::times(const std::vector<double> &x) const {
    constexpr int work_of_a_product = 8; // in double-double precision
    const auto dim = static_cast<int64_t>(x.size()) / size();
    std::vector<double> result(x.size());
    std::vector<DoubleDouble> sums(static_cast<size_t>(dim));
    for (int64_t j = 0; j < size(); ++j) { // the columns of a symmetric matrix are its rows
        std::ranges::fill(sums, DoubleDouble{});
        for_each_of(j, [&](int64_t row, const DoubleDouble &value) {
            for (int64_t c = 0; c < dim; ++c) {
                DoubleDouble &sum = sums[static_cast<size_t>(c)];
                sum = sum + value * DoubleDouble(x[static_cast<size_t>(row * dim + c)]);
            }
        });
        for (int64_t c = 0; c < dim; ++c) {
            result[static_cast<size_t>(j * dim + c)] = sums[static_cast<size_t>(c)].high;
        }
    }
    count_work(work_of_a_product * dim * static_cast<int64_t>(columns_.values.size()));
    return result;
}

double CloudPenalty::of(const std::vector<double> &x) const {
    return std::max(0.0, dot(std::span(x), times(x)));
}

std::vector<int64_t> CloudPenalty::elimination_order(int dim) const {
    std::vector<int64_t> order;
    for (const int64_t unknown : form_.elimination_order()) {
        for (int c = 0; c < dim; ++c) {
            order.push_back(unknown * dim + c);
        }
    }
    return order;
}

// --- The equations ---

CloudEquations::CloudEquations(const Spline::Axes &axes, int dim, const CloudPenalty &penalty)
    : penalty_(penalty), pattern_(penalty.pattern()), dim_(static_cast<size_t>(dim)),
      half_(dim_ * (dim_ + 1) / 2) {
    const ActiveFunctions functions(axes);
    for (size_t a = 0; a < functions.size(); ++a) {
        for (size_t b = a; b < functions.size(); ++b) {
            pairs_.push_back({a, b, pattern_.step(functions.step(a), functions.step(b))});
        }
    }
    unknowns_.resize(functions.size());
    grow_watched(matrix_, static_cast<size_t>(pattern_.elements()) * half_);
    right_.assign(static_cast<size_t>(pattern_.size()) * dim_, 0.0);
}

void CloudEquations::add(const ActiveFunctions &functions, double weight, const SquaredDistance &model) {
    const std::span<const double> values = functions.values();
    for (size_t a = 0; a < unknowns_.size(); ++a) {
        unknowns_[a] = pattern_.unknown(functions.layer(a));
        double *const right = right_.data() + static_cast<size_t>(unknowns_[a]) * dim_;
        for (size_t c = 0; c < dim_; ++c) {
            right[c] += weight * values[a] * model.force()[c];
        }
    }
    const double *const w = model.matrix().data();
    for (const Pair &pair : pairs_) {
        const double factor = weight * values[pair.a] * values[pair.b];
        const int64_t place = pattern_.start(unknowns_[pair.a]) + pair.step;
        double *const own = matrix_.data() + static_cast<size_t>(place) * half_;
        for (size_t e = 0; e < half_; ++e) {
            own[e] += factor * w[e];
        }
    }
    count_work(static_cast<int64_t>(pairs_.size() * (half_ + 2)));
}

double CloudEquations::trace() const noexcept {
    double sum = 0;
    pattern_.for_each_element([&](int64_t first, int64_t second, int64_t place) {
        const double factor = first != second ? 0 : place == pattern_.start(first) ? 1 : 2;
        for (size_t a = 0; factor > 0 && a < dim_; ++a) {
            sum += factor * element(place)[a * (a + 3) / 2];
        }
    });
    return sum;
}

// Appends an element and its mirror image.
void CloudEquations::append_element(std::vector<Entry> &entries, int64_t first, int64_t second,
                                    int64_t place) const {
    const auto dim = static_cast<int64_t>(dim_);
    for (int64_t a = 0; a < dim; ++a) {
        for (int64_t b = 0; b < dim; ++b) {
            const int64_t high = std::max(a, b), low = std::min(a, b);
            const double value = element(place)[high * (high + 1) / 2 + low];
            entries.push_back({first * dim + a, second * dim + b, value});
            if (place != pattern_.start(first)) {
                entries.push_back({second * dim + b, first * dim + a, value});
            }
        }
    }
}

void CloudEquations::append_penalty(std::vector<Entry> &entries, double lambda) const {
    const auto dim = static_cast<int64_t>(dim_);
    penalty_.for_each([&](int64_t row, int64_t column, double value) {
        for (int64_t c = 0; c < dim; ++c) {
            entries.push_back({row * dim + c, column * dim + c, lambda * value});
        }
    });
}

void CloudEquations::finish(double lambda, const std::vector<double> &x) {
    std::vector<Entry> entries;
    pattern_.for_each_element(
        [&](int64_t first, int64_t second, int64_t place) { append_element(entries, first, second, place); });
    count_work(16 * pattern_.elements());
    unit_ = trace() / static_cast<double>(right_.size());
    if (lambda > 0) {
        append_penalty(entries, lambda);
        const std::vector<double> paid = penalty_.times(x);
        for (size_t i = 0; i < right_.size(); ++i) {
            right_[i] -= lambda * paid[i];
        }
    }
    system_ = std::make_unique<SparseSystem>(entries, std::vector<double>(right_.size(), unit_),
                                             penalty_.elimination_order(static_cast<int>(dim_)));
}

std::optional<CloudEquations::Step> CloudEquations::step(double mu) {
    Step step{std::vector<double>(right_.size()), 0};
    if (!(unit_ > 0)) { // the models do not depend on the step
        return step;
    }
    if (!system_->solve(mu, right_, 1, step.change)) {
        return std::nullopt;
    }
    const std::span<const double> d = step.change;
    step.promise = dot(d, right_) + mu * unit_ * dot(d, d); // 2 d.g - d.A d, where A d = g - mu u d
    return step;
}

} // namespace nrb::fit
