// SPDX-License-Identifier: MIT
#include "fit/cloud/cloud_equations.h"

#include "base/watch.h"
#include "fit/least_squares/penalty.h"
#include "numeric/norm.h"

#include <algorithm>
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
    : form_(penalty(axes, possible_order(axes, order))),
      columns_(form_.columns(natural_order(form_.size()))) {}

std::vector<double> CloudPenalty::times(const std::vector<double> &x) const {
    std::vector<double> result(x.size(), 0.0);
    const auto dim = static_cast<int64_t>(x.size()) / size();
    for_each([&](int64_t row, int64_t column, double value) {
        for (int64_t c = 0; c < dim; ++c) {
            result[static_cast<size_t>(row * dim + c)] += value * x[static_cast<size_t>(column * dim + c)];
        }
    });
    count_work(2 * dim * static_cast<int64_t>(columns_.values.size()));
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
    : penalty_(penalty), dim_(static_cast<size_t>(dim)), half_(dim_ * (dim_ + 1) / 2) {
    int64_t all = 1;
    for (size_t k = 0; k < axes.size(); ++k) {
        counts_[k] = axes[k]->distinct_layers();
        reach_[k] = axes[k]->degree();
        periodic_[k] = axes[k]->periodic();
        all *= 2 * reach_[k] + 1;
    }
    Index offset{}; // those from no offset on: the second half of all, last axis fastest
    for (int64_t i = 0; i < all / 2 + 1; ++i) {
        offsets_.push_back(offset);
        for (size_t k = offset.size(); k-- > 0;) {
            if (++offset[k] <= reach_[k]) {
                break;
            }
            offset[k] = -reach_[k];
        }
    }
    make_pairs(axes);
    grow_watched(matrix_, static_cast<size_t>(penalty.size()) * offsets_.size() * half_);
    right_.assign(static_cast<size_t>(penalty.size()) * dim_, 0.0);
}

void CloudEquations::make_pairs(const Spline::Axes &axes) {
    Index widths{1, 1, 1};
    for (size_t k = 0; k < axes.size(); ++k) {
        widths[k] = reach_[k] + 1;
    }
    for_each_index({}, widths, [&](const Index &function) { functions_.push_back(function); });
    for (size_t a = 0; a < functions_.size(); ++a) {
        for (size_t b = a; b < functions_.size(); ++b) {
            int64_t place = 0;
            for (size_t k = 0; k < widths.size(); ++k) {
                place = place * (2 * reach_[k] + 1) + functions_[b][k] - functions_[a][k];
            }
            pairs_.push_back({a, b, place});
        }
    }
    values_.resize(functions_.size());
    unknowns_.resize(functions_.size());
}

void CloudEquations::add(const Index &first, const std::array<std::span<const double>, max_axes> &functions,
                         double weight, const SquaredDistance &model) {
    for (size_t a = 0; a < functions_.size(); ++a) {
        Index layer = first;
        double value = 1;
        for (size_t k = 0; k < layer.size(); ++k) {
            layer[k] += functions_[a][k];
            value *= functions[k].empty() ? 1 : functions[k][static_cast<size_t>(functions_[a][k])];
        }
        values_[a] = value;
        unknowns_[a] = penalty_.unknown(layer);
        double *const right = right_.data() + static_cast<size_t>(unknowns_[a]) * dim_;
        for (size_t c = 0; c < dim_; ++c) {
            right[c] += weight * value * model.force()[c];
        }
    }
    const auto offsets = static_cast<int64_t>(offsets_.size());
    const double *const w = model.matrix().data();
    for (const Pair &pair : pairs_) {
        const double factor = weight * values_[pair.a] * values_[pair.b];
        double *const element =
            matrix_.data() + static_cast<size_t>(unknowns_[pair.a] * offsets + pair.place) * half_;
        for (size_t e = 0; e < half_; ++e) {
            element[e] += factor * w[e];
        }
    }
    count_work(static_cast<int64_t>(pairs_.size() * (half_ + 2)));
}

// Calls visit(row, column, element) for the elements that are kept.
template <class Visit>
void CloudEquations::for_each_element(Visit &&visit) const {
    const double *element = matrix_.data();
    int64_t row = 0;
    for_each_index({}, counts_, [&](const Index &own) {
        for (const Index &offset : offsets_) {
            Index other{};
            bool inside = true;
            for (size_t k = 0; k < own.size(); ++k) {
                other[k] = own[k] + offset[k];
                other[k] = periodic_[k] ? (other[k] % counts_[k] + counts_[k]) % counts_[k] : other[k];
                inside = inside && other[k] >= 0 && other[k] < counts_[k];
            }
            if (inside) {
                visit(row, (other[0] * counts_[1] + other[1]) * counts_[2] + other[2], element,
                      offset == Index{});
            }
            element += half_;
        }
        count_work(16 * static_cast<int64_t>(offsets_.size()));
        ++row;
    });
}

std::vector<Entry> CloudEquations::entries(double lambda) {
    std::vector<Entry> result;
    const auto dim = static_cast<int64_t>(dim_);
    double trace = 0;
    for_each_element([&](int64_t row, int64_t column, const double *element, bool diagonal) {
        for (int64_t a = 0; a < dim; ++a) {
            for (int64_t b = 0; b < dim; ++b) {
                const double value = element[std::max(a, b) * (std::max(a, b) + 1) / 2 + std::min(a, b)];
                trace += diagonal && a == b ? value : 0;
                result.push_back({row * dim + a, column * dim + b, value});
                if (!diagonal) {
                    result.push_back({column * dim + b, row * dim + a, value});
                }
            }
        }
    });
    unit_ = trace / static_cast<double>(right_.size());
    if (lambda > 0) {
        penalty_.for_each([&](int64_t row, int64_t column, double value) {
            for (int64_t c = 0; c < dim; ++c) {
                result.push_back({row * dim + c, column * dim + c, lambda * value});
            }
        });
    }
    return result;
}

void CloudEquations::finish(double lambda, const std::vector<double> &x) {
    const std::vector<Entry> all = entries(lambda);
    const std::vector<double> paid = lambda > 0 ? penalty_.times(x) : std::vector<double>(x.size());
    for (size_t i = 0; i < right_.size(); ++i) {
        right_[i] -= lambda * paid[i];
    }
    system_ = std::make_unique<SparseSystem>(all, std::vector<double>(right_.size(), unit_),
                                             penalty_.elimination_order(static_cast<int>(dim_)));
}

std::optional<CloudEquations::Step> CloudEquations::step(double mu) {
    Step step{std::vector<double>(right_.size()), 0};
    if (!(unit_ > 0)) { // nothing moves a foot
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
