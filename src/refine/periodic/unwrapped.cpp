// SPDX-License-Identifier: MIT
#include "refine/periodic/unwrapped.h"

#include "base/checked.h"
#include "refine/periodic/period.h"

#include <algorithm>

namespace nrb::refine {

namespace {

void check_runs(int degree, std::span<const double> period, int axis, int64_t offset) {
    const size_t limit = static_cast<size_t>(degree) + 1;
    for (size_t i = 0; i + limit < period.size(); ++i) {
        if (period[i] == period[i + limit]) {
            fail(Status::multiplicity,
                 "knots[%lld] = %s on axis %d is the same knot as knots[%lld]; degree %d allows %d equal "
                 "knots",
                 offset + static_cast<long long>(i + limit), Number(period[i]).text, axis,
                 offset + static_cast<long long>(i), degree, degree + 1);
        }
    }
}

// The first and the last knot of the period are copies of one knot; one of these copies is counted twice.
void check_seam(int degree, std::span<const double> period, int axis, int64_t offset) {
    const int copies = multiplicity(period, period.front()) + multiplicity(period, period.back()) - 1;
    if (copies > degree + 1) {
        fail(Status::multiplicity,
             "knots[%lld] and knots[%lld] on axis %d are one knot a period apart, which occurs %d times; "
             "degree %d "
             "allows %d equal knots",
             static_cast<long long>(offset), static_cast<long long>(offset) + std::ssize(period) - 1, axis,
             copies, degree, degree + 1);
    }
}

} // namespace

void check_period(int degree, std::span<const double> period, int axis, int64_t offset) {
    check_finite_and_sorted(period, axis, offset);
    if (period.front() == period.back()) {
        fail(Status::empty_domain, "knots[%lld] = knots[%lld] = %s on axis %d: the domain is empty",
             static_cast<long long>(offset), static_cast<long long>(offset) + std::ssize(period) - 1,
             Number(period.front()).text, axis);
    }
    check_runs(degree, period, axis, offset);
    check_seam(degree, period, axis, offset);
}

std::vector<double> wrapped_knots(int degree, std::span<const double> period) {
    const auto p = static_cast<size_t>(degree), step = period.size() - 1;
    std::vector<double> knots(step + 2 * p + 1);
    std::copy(period.begin(), period.end(), knots.begin() + degree);
    continue_knots(knots, p, p + step, step);
    for (size_t i = 0; i + p + 1 < knots.size(); ++i) {
        if (knots[i] == knots[i + p + 1]) {
            fail(Status::not_representable,
                 "knots: those of the periods beside the domain, near %s, cannot be "
                 "told apart in double precision",
                 Number(knots[i]).text);
        }
    }
    return knots;
}

std::span<const double> unwrapped_knots(const KnotVector &axis) noexcept {
    const auto period = static_cast<size_t>(axis.distinct_layers()) + 1;
    return axis.periodic() ? axis.knots().subspan(static_cast<size_t>(axis.degree()), period) : axis.knots();
}

std::vector<double> wrapped_layers(std::span<const double> values, const AxisView &view, int64_t distinct,
                                   int64_t count) {
    const auto size = static_cast<size_t>(view.outer * count * view.inner);
    std::vector<double> result;
    result.reserve(size + Spline::padding);
    for (int64_t o = 0; o < view.outer; ++o) {
        const double *const first = values.data() + o * view.count * view.inner;
        for (int64_t i = 0; i < count; ++i) {
            const double *const layer = first + i % distinct * view.inner;
            result.insert(result.end(), layer, layer + view.inner);
        }
    }
    return result;
}

// The last axis is wrapped first, so that the axes before it still have their distinct layers only.
std::vector<double> wrapped(std::vector<double> values, const Spline::Axes &axes, int64_t width) {
    AxisView view{1, 1, width};
    for (const KnotVectorPtr &axis : axes) {
        view.outer *= axis->distinct_layers();
    }
    for (size_t k = axes.size(); k-- > 0;) {
        const KnotVector &axis = *axes[k];
        view.count = axis.distinct_layers();
        view.outer /= view.count;
        if (axis.periodic()) {
            values = wrapped_layers(values, view, view.count, axis.count());
        }
        view.inner *= axis.count();
    }
    return values;
}

} // namespace nrb::refine
