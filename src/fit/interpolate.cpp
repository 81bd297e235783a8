// SPDX-License-Identifier: MIT
#include "fit/interpolate.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::fit {

namespace {

constexpr int64_t work_of_a_value = 4; // which is moved

// What belongs to one condition together, [conditions][outer * inner]: layer sources[i] of the grid, zeros for -1.
std::vector<double> gathered(const PointGrid &grid, const GridLayers &of,
                             const std::vector<int64_t> &sources) {
    std::vector<double> values(sources.size() * static_cast<size_t>(of.outer * of.inner), 0.0);
    double *target = values.data();
    for (const int64_t source : sources) {
        count_work(work_of_a_value * of.outer * of.inner);
        for (int64_t o = 0; o < of.outer; ++o, target += of.inner) {
            if (source >= 0) {
                std::copy_n(grid.points.data() + (o * of.count + source) * of.inner, of.inner, target);
            }
        }
    }
    return values;
}

// Puts the layers of control points in the place of those of the data; on a periodic axis the first ones repeat.
void scatter(const std::vector<double> &values, const GridLayers &of, int64_t stored, int64_t distinct,
             size_t k, PointGrid &grid) {
    std::vector<double> points(static_cast<size_t>(of.outer * stored * of.inner));
    double *target = points.data();
    for (int64_t o = 0; o < of.outer; ++o) {
        count_work(work_of_a_value * stored * of.inner);
        for (int64_t i = 0; i < stored; ++i) {
            target = std::copy_n(values.data() + (i % distinct * of.outer + o) * of.inner, of.inner, target);
        }
    }
    grid.counts[k] = stored;
    grid.points = std::move(points);
}

void solve_axis(const AxisInterpolation &axis, const std::vector<int64_t> &sources, size_t k,
                PointGrid &grid) {
    const GridLayers of = layers_of(grid, k);
    if (of.outer == 1 && axis.knots()->count() == of.count && axis.conditions() == of.count) {
        return axis.solve(grid.points, of.inner); // in place
    }
    std::vector<double> values = gathered(grid, of, sources);
    axis.solve(values, of.outer * of.inner);
    scatter(values, of, axis.knots()->count(), axis.knots()->distinct_layers(), k, grid);
}

void check_closed_along(const PointGrid &grid, size_t k) {
    const GridLayers of = layers_of(grid, k);
    for (int64_t o = 0; o < of.outer; ++o) {
        const double *const first = grid.points.data() + o * of.count * of.inner;
        const double *const last = first + (of.count - 1) * of.inner;
        const auto [one, other] = std::mismatch(first, first + of.inner, last);
        if (one != first + of.inner) {
            fail(Status::periodic_points,
                 "points: the last layer on axis %zu has the coordinate %s where the first one has %s; "
                 "expected a copy "
                 "of the first layer on a periodic axis",
                 k, Number(*other).text, Number(*one).text);
        }
    }
}

void check_representable(const PointGrid &grid) {
    require_representable(grid.points, "control points");
}

// The values at the parameters, and zeros for what natural ends ask for; from which layers of the data they come.
struct Conditions {
    std::vector<Condition> conditions;
    std::vector<int64_t> sources;

    void add(double param, int order, int64_t source) {
        conditions.push_back({param, order});
        sources.push_back(source);
    }
    void add_natural(double param, End end, int degree) {
        for (int order = degree - conditions_at(end, degree); order < degree; ++order) {
            add(param, order, -1);
        }
    }
};

Conditions conditions_of(std::span<const double> params, int degree, Ends ends, bool periodic) {
    Conditions all;
    const auto count = params.size() + 2 * static_cast<size_t>(degree);
    all.conditions.reserve(count);
    all.sources.reserve(count);
    const auto last = std::ssize(params) - 1;
    all.add(params.front(), 0, 0);
    all.add_natural(params.front(), ends[0], degree);
    for (int64_t i = 1; i < last; ++i) {
        all.add(params[static_cast<size_t>(i)], 0, i);
    }
    if (!periodic) {
        all.add_natural(params.back(), ends[1], degree);
        all.add(params.back(), 0, last);
    }
    return all;
}

void check_inside(double t, Interval domain, size_t k, int64_t index) {
    if (!(t >= domain.lower && t <= domain.upper)) {
        fail(Status::outside_domain, "params[%lld] = %s on axis %zu is outside the domain [%s, %s]",
             static_cast<long long>(index), Number(t).text, k, Number(domain.lower).text,
             Number(domain.upper).text);
    }
}

// Calls body(k, params of axis k, their place).
template <class Body>
void for_each_axis(const std::vector<int64_t> &counts, std::span<const double> params, Body &&body) {
    int64_t offset = 0;
    for (size_t k = 0; k < counts.size(); ++k) {
        const auto first = static_cast<size_t>(offset), count = static_cast<size_t>(counts[k]);
        body(k, params.subspan(first, count), offset);
        offset += counts[k];
    }
}

} // namespace

void check_params(std::span<const double> params, const std::vector<int64_t> &counts) {
    for_each_axis(counts, params, [](size_t k, std::span<const double> own, int64_t offset) {
        for (size_t i = 0; i < own.size(); ++i) {
            const long long at = offset + static_cast<long long>(i);
            if (!std::isfinite(own[i])) {
                fail(Status::parameter_not_finite, "params[%lld] = %s is not finite", at,
                     Number(own[i]).text);
            }
            if (i > 0 && !(own[i] > own[i - 1])) {
                fail(Status::knots_decreasing,
                     "params[%lld] = %s on axis %zu, expected more than params[%lld] = %s", at,
                     Number(own[i]).text, k, at - 1, Number(own[i - 1]).text);
            }
        }
    });
}

void check_closed(const PointGrid &grid) {
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        if (grid.periodic[k]) {
            check_closed_along(grid, k);
        }
    }
}

SplinePtr interpolate(const std::vector<int> &degrees, std::span<const double> params, PointGrid grid,
                      const std::vector<Ends> &ends) {
    check_params(params, grid.counts);
    Spline::Axes axes(degrees.size());
    const std::vector<int64_t> counts = grid.counts;
    for_each_axis(counts, params, [&](size_t k, std::span<const double> own, int64_t) {
        axes[k] = interpolation_knots(degrees[k], own, ends[k], grid.periodic[k], static_cast<int>(k));
    });
    check_closed(grid);
    Steps steps(std::ssize(axes));
    for_each_axis(counts, params, [&](size_t k, std::span<const double> own, int64_t) {
        Conditions all = conditions_of(own, degrees[k], ends[k], grid.periodic[k]);
        solve_axis(AxisInterpolation(axes[k], std::move(all.conditions), static_cast<int>(k)), all.sources, k,
                   grid);
        steps.next();
    });
    check_representable(grid);
    return make_result(std::move(axes), grid.dim, Form::polynomial, std::move(grid.points));
}

SplinePtr interpolate(const Spline::Axes &axes, std::span<const double> params, PointGrid grid) {
    check_params(params, grid.counts);
    const std::vector<int64_t> counts = grid.counts;
    for_each_axis(counts, params, [&](size_t k, std::span<const double> own, int64_t offset) {
        for (size_t i = 0; i < own.size(); ++i) {
            check_inside(own[i], axes[k]->domain(), k, offset + static_cast<int64_t>(i));
        }
    });
    Steps steps(std::ssize(axes));
    for_each_axis(counts, params, [&](size_t k, std::span<const double> own, int64_t) {
        std::vector<int64_t> sources(own.size());
        std::iota(sources.begin(), sources.end(), 0);
        std::vector<Condition> conditions;
        conditions.reserve(own.size());
        std::ranges::transform(own, std::back_inserter(conditions), [](double t) { return Condition{t, 0}; });
        solve_axis(AxisInterpolation(axes[k], std::move(conditions), static_cast<int>(k)), sources, k, grid);
        steps.next();
    });
    check_representable(grid);
    return make_result(axes, grid.dim, Form::polynomial, std::move(grid.points));
}

SplinePtr interpolate_conditions(KnotVectorPtr knots, const std::vector<Condition> &conditions, int dim,
                                 std::vector<double> targets) {
    const auto [lower, upper] = knots->domain();
    for (size_t i = 0; i < conditions.size(); ++i) {
        check_inside(conditions[i].param, {lower, upper}, 0, static_cast<int64_t>(i));
    }
    PointGrid grid{{std::ssize(conditions)}, dim, std::move(targets)};
    std::vector<int64_t> sources(conditions.size());
    std::iota(sources.begin(), sources.end(), 0);
    solve_axis(AxisInterpolation(knots, conditions, 0), sources, 0, grid);
    check_representable(grid);
    return make_result({std::move(knots)}, dim, Form::polynomial, std::move(grid.points));
}

double largest_miss(const Spline &spline, std::span<const double> params, const PointGrid &grid) {
    std::array<ConstRecords, max_axes> axes{};
    for_each_axis(grid.counts, params, [&](size_t k, std::span<const double> own, int64_t) {
        axes[k] = {own.data(), std::ssize(own)};
    });
    eval::AxisRules rules{};
    for (int k = 0; k < spline.axes(); ++k) {
        rules[static_cast<size_t>(k)].outside =
            spline.axis(k).periodic() ? eval::Outside::wrap : eval::Outside::refuse;
    }
    std::vector<double> values(grid.points.size());
    const int64_t dim = grid.dim, count = std::ssize(values) / dim;
    eval::evaluate_grid(spline, rules, 0, axes, {values.data(), count, dim, dim});
    double largest = 0;
    for (int64_t i = 0; i < count; ++i) {
        largest =
            std::max(largest, distance(values.data() + i * dim, grid.points.data() + i * dim, grid.dim));
    }
    return largest;
}

} // namespace nrb::fit
