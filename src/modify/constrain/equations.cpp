// SPDX-License-Identifier: MIT
#include "modify/constrain/equations.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::modify {

namespace {

double sum_of_magnitudes(const std::vector<double> &values) noexcept {
    return std::accumulate(values.begin(), values.end(), 0.0,
                           [](double sum, double x) { return sum + std::abs(x); });
}

// A factor times a size; 0 if the factor is, even if the size is infinite.
double scaled(double factor, double size) noexcept {
    return factor == 0 ? 0 : factor * size;
}

// The largest residual of an equation if the derivatives are off by the given sizes: the sum of the sizes
// times the magnitudes of the coefficients.
double largest_limit(const LocalEquations &local, const std::vector<double> &sizes, int dim) {
    double largest = 0;
    const size_t width = sizes.size() * static_cast<size_t>(dim);
    for (size_t k = 0; k < local.residual.size(); ++k) {
        double limit = 0;
        for (size_t i = 0; i < width; ++i) {
            limit += scaled(std::abs(local.jacobian[k * width + i]), sizes[i / static_cast<size_t>(dim)]);
        }
        largest = std::max(largest, limit);
    }
    return largest;
}

} // namespace

double LocalEquations::length() const noexcept {
    return norm(residual.data(), static_cast<int>(residual.size()));
}

LocalEquations local_equations(const NetState &state, const Condition &condition, double tolerance) {
    constexpr double rounding = 64 * eps;
    const LocalBasis basis(state, condition);
    const int dim = state.start().dim();
    LocalEquations local;
    local.points = basis.points();
    constexpr int64_t work_of_a_condition = 3000, work_of_a_value = 160;
    count_work(work_of_a_condition +
               work_of_a_value * std::ssize(local.points) * dim * std::ssize(condition.derivatives()));
    std::vector<double> values, sizes;
    for (const eval::Orders &a : condition.derivatives()) {
        const std::vector<double> &functions = local.functions.emplace_back(basis.functions(a));
        const std::vector<double> value = basis.value(a, functions);
        values.insert(values.end(), value.begin(), value.end());
        sizes.push_back(tolerance > 0 ? scaled(sum_of_magnitudes(functions), tolerance)
                                      : rounding * basis.magnitude(functions));
        if (!state.columns().weight_costs.empty()) {
            local.slopes.push_back(basis.weight_slopes(a));
        }
    }
    local.residual.resize(static_cast<size_t>(condition.equations()));
    local.jacobian.resize(local.residual.size() * values.size());
    condition.evaluate(values.data(), local.residual.data(), local.jacobian.data());
    local.limit = largest_limit(local, sizes, dim) + (tolerance > 0 ? 0 : rounding * condition.target_size());
    if (!(tolerance > 0) && !condition.linear() && condition.target_size() > 0) {
        // Where C' nearly vanishes, the limit for rounding would admit any curvature.
        local.limit = std::min(local.limit, 1e-6 * condition.target_size());
    }
    return local;
}

std::vector<LocalEquations> all_equations(const NetState &state, const std::vector<Condition> &conditions,
                                          double tolerance) {
    std::vector<LocalEquations> all;
    all.reserve(conditions.size());
    for (const Condition &condition : conditions) {
        all.push_back(local_equations(state, condition, tolerance));
    }
    return all;
}

void check_influence(const NetState &state, const std::vector<LocalEquations> &all) {
    for (size_t i = 0; i < all.size(); ++i) {
        bool acts = false;
        for (size_t j = 0; j < all[i].points.size(); ++j) {
            const auto point = static_cast<size_t>(all[i].points[j]);
            const bool free = state.columns().points[point] >= 0 || state.columns().weights[point] >= 0;
            for (const std::vector<double> &functions : all[i].functions) {
                acts = acts || (free && functions[j] != 0);
            }
        }
        if (!acts) {
            fail(Status::influence, "constraint %zu: no control point that may move acts on it", i);
        }
    }
}

void check_finite(const std::vector<LocalEquations> &all) {
    const auto finite = [](const std::vector<double> &values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    };
    for (size_t i = 0; i < all.size(); ++i) {
        if (!finite(all[i].residual) || !finite(all[i].jacobian)) {
            fail(Status::not_representable,
                 "constraint %zu is not finite: C' is zero where a curvature is asked for, or a value "
                 "overflows",
                 i);
        }
    }
}

int64_t worst_missed(const std::vector<LocalEquations> &all) noexcept {
    int64_t worst = -1;
    double most = 1;
    for (size_t i = 0; i < all.size(); ++i) {
        const double length = all[i].length(), times = length == 0 ? 0 : length / all[i].limit;
        if (!(times <= most)) {
            most = times;
            worst = static_cast<int64_t>(i);
        }
    }
    return worst;
}

void fail_missed(Status status, const std::vector<LocalEquations> &all) {
    const int64_t worst = worst_missed(all);
    const LocalEquations &local = all[static_cast<size_t>(worst)];
    if (!std::isfinite(local.length())) {
        status = Status::not_representable;
    }
    fail(status, "constraint %lld is missed by %s, more than %s", static_cast<long long>(worst),
         Number(local.length()).text, Number(local.limit).text);
}

} // namespace nrb::modify
