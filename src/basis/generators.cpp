// SPDX-License-Identifier: MIT
#include "basis/generators.h"

#include "base/checked.h"
#include "basis/knot_vector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::inline basis {

namespace {

void check_size(std::span<double> knots, int64_t expected) {
    if (static_cast<int64_t>(knots.size()) != expected) {
        fail(Status::size, "knot_count = %zu, expected %lld", knots.size(), static_cast<long long>(expected));
    }
}

void check_interval(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b)) {
        fail(Status::knot_not_finite, "[a, b] = [%s, %s] is not finite", Number(a).text, Number(b).text);
    }
    if (!(a < b)) {
        fail(Status::empty_domain, "[a, b] = [%s, %s], expected a < b", Number(a).text, Number(b).text);
    }
}

void check_increasing(std::span<const double> breaks) {
    for (size_t i = 0; i < breaks.size(); ++i) {
        if (!std::isfinite(breaks[i])) {
            fail(Status::knot_not_finite, "breaks[%zu] = %s is not finite", i, Number(breaks[i]).text);
        }
        if (i > 0 && !(breaks[i - 1] < breaks[i])) {
            fail(Status::knots_decreasing, "breaks[%zu] = %s, expected more than breaks[%zu] = %s", i,
                 Number(breaks[i]).text, i - 1, Number(breaks[i - 1]).text);
        }
    }
}

// Point i of n equal steps from a to b. Both ends are exact; points outside [0, n] extrapolate.
double even(double a, double b, int64_t i, int64_t n) noexcept {
    if (i == n) {
        return b;
    }
    const double s = static_cast<double>(i) / static_cast<double>(n);
    return std::abs(s) <= 1 ? std::lerp(a, b, s) : a + s * (b - a);
}

// Knots computed by a rule must still be valid: in a short interval rounding may merge knots, and distant
// knots may overflow.
void check_result(int degree, std::span<const double> knots) {
    if (std::any_of(knots.begin(), knots.end(), [](double t) { return !std::isfinite(t); }) ||
        !std::isfinite(knots.back() - knots.front())) {
        fail(Status::not_representable, "knots: the range of the knots overflows double precision");
    }
    check_knots(degree, knots, -1, 0);
}

void fill_checked(int degree, const std::vector<double> &result, std::span<double> knots) {
    check_result(degree, result);
    std::copy(result.begin(), result.end(), knots.begin());
}

void check_steps(double a, double b, int64_t n) {
    for (int64_t i = 0; i < n; ++i) {
        if (!(even(a, b, i, n) < even(a, b, i + 1, n))) {
            fail(Status::not_representable,
                 "[a, b] = [%s, %s] has no room for %lld spans in double precision", Number(a).text,
                 Number(b).text, static_cast<long long>(n));
        }
    }
}

// Knot i is point step_of(i - degree, n) of n = count - degree equal steps from a to b.
template <class StepOf>
void fill_even(int degree, int64_t count, double a, double b, std::span<double> knots, StepOf &&step_of) {
    check_degree(degree, -1);
    check_count(degree, count, -1);
    check_knot_total(static_cast<int64_t>(knots.size()), degree, count);
    check_interval(a, b);
    check_steps(a, b, count - degree);
    std::vector<double> result(knots.size());
    for (size_t i = 0; i < result.size(); ++i) {
        result[i] = even(a, b, step_of(static_cast<int64_t>(i) - degree, count - degree), count - degree);
    }
    fill_checked(degree, result, knots);
}

int break_multiplicity(const int32_t *multiplicities, size_t i) noexcept {
    return multiplicities == nullptr ? 1 : multiplicities[i];
}

void check_multiplicities(int degree, size_t n, const int32_t *multiplicities) {
    for (size_t i = 0; i < n; ++i) {
        const int m = break_multiplicity(multiplicities, i);
        if (m < 1 || m > degree + 1) {
            fail(Status::multiplicity, "multiplicities[%zu] = %d, expected 1 to %d", i, m, degree + 1);
        }
    }
    if (break_multiplicity(multiplicities, 0) != break_multiplicity(multiplicities, n - 1)) {
        fail(Status::periodic_knots, "multiplicities[%zu] = %d, expected multiplicities[0] = %d", n - 1,
             break_multiplicity(multiplicities, n - 1), break_multiplicity(multiplicities, 0));
    }
}

} // namespace

void uniform_knots(int degree, int64_t count, double a, double b, std::span<double> knots) {
    fill_even(degree, count, a, b, knots, [](int64_t step, int64_t) { return step; });
}

void open_uniform_knots(int degree, int64_t count, double a, double b, std::span<double> knots) {
    fill_even(degree, count, a, b, knots,
              [](int64_t step, int64_t last) { return std::clamp(step, int64_t{0}, last); });
}

int64_t bezier_knot_count(int degree, int64_t pieces) {
    const int64_t inner = checked_product(pieces, std::max(degree, 1), "knots");
    return checked_sum(inner, degree == 0 ? 1 : degree + 2, "knots");
}

void bezier_knots(int degree, int64_t pieces, const double *breaks, std::span<double> knots) {
    check_degree(degree, -1);
    if (pieces < 1) {
        fail(Status::count, "pieces = %lld, expected at least 1", static_cast<long long>(pieces));
    }
    check_size(knots, bezier_knot_count(degree, pieces));
    if (breaks != nullptr) {
        check_increasing({breaks, static_cast<size_t>(pieces) + 1});
    }
    std::vector<double> result;
    result.reserve(knots.size());
    for (int64_t i = 0; i <= pieces; ++i) {
        const bool end = i == 0 || i == pieces;
        const double knot = breaks == nullptr ? even(0, 1, i, pieces) : breaks[i];
        result.insert(result.end(), static_cast<size_t>(end ? degree + 1 : std::max(degree, 1)), knot);
    }
    fill_checked(degree, result, knots);
}

void averaged_knots(int degree, std::span<const double> params, std::span<double> knots) {
    const auto count = static_cast<int64_t>(params.size());
    check_degree(degree, -1);
    check_count(degree, count, -1);
    check_knot_total(static_cast<int64_t>(knots.size()), degree, count);
    for (size_t i = 0; i < params.size(); ++i) {
        if (!std::isfinite(params[i])) {
            fail(Status::parameter_not_finite, "params[%zu] = %s is not finite", i, Number(params[i]).text);
        }
        if (i > 0 && params[i] < params[i - 1]) {
            fail(Status::knots_decreasing, "params[%zu] = %s is smaller than params[%zu] = %s", i,
                 Number(params[i]).text, i - 1, Number(params[i - 1]).text);
        }
    }
    const auto p = static_cast<size_t>(degree);
    std::vector<double> result(p + 1, params.front());
    for (size_t j = 1; j + p < params.size(); ++j) {
        // At degree 0, the mean of the two parameters next to the knot. Offsets from the first parameter make
        // the mean of equal values exact.
        const size_t first = p == 0 ? j - 1 : j;
        const size_t terms = p == 0 ? 2 : p;
        double offset = 0;
        for (size_t i = 1; i < terms; ++i) {
            offset += params[first + i] - params[first];
        }
        result.push_back(params[first] + offset / static_cast<double>(terms));
    }
    result.insert(result.end(), p + 1, params.back());
    fill_checked(degree, result, knots);
}

void periodic_knots(int degree, std::span<const double> breaks, const int32_t *multiplicities,
                    std::span<double> knots) {
    check_degree(degree, -1);
    if (breaks.size() < 2) {
        fail(Status::count, "n = %zu, expected at least 2 breaks", breaks.size());
    }
    check_multiplicities(degree, breaks.size(), multiplicities);
    check_increasing(breaks);
    // One period: from the last copy of the first break to the copy before the last copy of the last break.
    std::vector<double> period;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        period.insert(period.end(), static_cast<size_t>(break_multiplicity(multiplicities, i)), breaks[i]);
    }
    const auto distinct = static_cast<int64_t>(period.size());
    check_size(knots, distinct + 2 * int64_t{degree} + 1);
    const int64_t last_copy = break_multiplicity(multiplicities, 0) - 1;
    const double length = breaks.back() - breaks.front();
    std::vector<double> result(knots.size());
    for (size_t i = 0; i < result.size(); ++i) {
        int64_t at = last_copy + static_cast<int64_t>(i) - degree;
        int64_t periods = 0;
        for (; at < 0; at += distinct) {
            --periods;
        }
        for (; at >= distinct; at -= distinct) {
            ++periods;
        }
        const double knot = period[static_cast<size_t>(at)];
        // The last break itself, not first + length, closes the period.
        result[i] = knot == breaks.front() && periods == 1 ? breaks.back()
                                                           : knot + static_cast<double>(periods) * length;
    }
    fill_checked(degree, result, knots);
}

} // namespace nrb::inline basis
