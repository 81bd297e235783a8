// SPDX-License-Identifier: MIT
#include "fit/interpolate.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "base/watch.h"
#include "fit/mixed_derivatives.h"
#include "fit/tangent_lengths.h"

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

// Whether conditions belong to layers one by one.
bool in_place(const std::vector<int64_t> &sources) noexcept {
    for (size_t i = 0; i < sources.size(); ++i) {
        if (sources[i] != static_cast<int64_t>(i)) {
            return false;
        }
    }
    return true;
}

void solve_axis(const AxisInterpolation &axis, const std::vector<int64_t> &sources, size_t k,
                PointGrid &grid) {
    const GridLayers of = layers_of(grid, k);
    if (of.outer == 1 && axis.knots()->count() == of.count && in_place(sources)) {
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
                 "expected a copy of the first layer on a periodic axis",
                 k, Number(*other).text, Number(*one).text);
        }
    }
}

void check_representable(const PointGrid &grid) {
    require_representable(grid.points, "control points");
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
        check_layers({own, {}}, 0, false, k, offset);
    });
}

void check_closed(const PointGrid &grid) {
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        if (grid.periodic[k]) {
            check_closed_along(grid, k);
        }
    }
}

std::vector<AxisLayers> layers_by_axis(const std::vector<int64_t> &counts, std::span<const double> params,
                                       std::span<const int32_t> orders) {
    std::vector<AxisLayers> axes;
    for_each_axis(counts, params, [&](size_t, std::span<const double> own, int64_t offset) {
        const auto first = static_cast<size_t>(offset);
        axes.push_back({own, orders.empty() ? orders : orders.subspan(first, own.size())});
    });
    return axes;
}

SplinePtr interpolate(const std::vector<int> &degrees, const std::vector<AxisLayers> &layers, PointGrid grid,
                      const std::vector<Ends> &ends) {
    int64_t first = 0;
    Spline::Axes axes;
    for (size_t k = 0; k < layers.size(); first += layers[k].count(), ++k) {
        check_layers(layers[k], degrees[k], grid.periodic[k], k, first);
    }
    for (size_t k = 0; k < layers.size(); ++k) {
        std::vector<double> room;
        axes.push_back(interpolation_knots(degrees[k], layers[k].sites(room), ends[k], grid.periodic[k],
                                           static_cast<int>(k), layers[k].derivatives()));
    }
    check_closed(grid);
    estimate_mixed(layers, degrees, grid);
    Steps steps(std::ssize(axes));
    for (size_t k = 0; k < layers.size(); ++k) {
        AxisConditions all = conditions_of(layers[k], degrees[k], ends[k], grid.periodic[k]);
        solve_axis(AxisInterpolation(axes[k], std::move(all.conditions), static_cast<int>(k)), all.sources, k,
                   grid);
        steps.next();
    }
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

namespace {

// Throws Status::outside_domain for a condition outside the knots, and what AxisInterpolation does.
AxisInterpolation checked_axis(const CurveConditions &given, KnotVectorPtr knots) {
    for (size_t i = 0; i < given.conditions.size(); ++i) {
        check_inside(given.conditions[i].param, knots->domain(), 0, static_cast<int64_t>(i));
    }
    return {std::move(knots), given.conditions, 0};
}

} // namespace

std::vector<double> tangent_lengths(const CurveConditions &given, KnotVectorPtr knots) {
    return tangent_lengths(checked_axis(given, std::move(knots)), given.directions, given.dim, given.targets);
}

SplinePtr interpolate_conditions(CurveConditions given, KnotVectorPtr knots) {
    const AxisInterpolation axis = checked_axis(given, knots);
    if (!given.directions.empty()) {
        const std::vector<double> lengths = tangent_lengths(axis, given.directions, given.dim, given.targets);
        check_along(given.directions, given.dim, given.targets, lengths);
        for (size_t i = 0; i < given.targets.size(); ++i) {
            given.targets[i] *= lengths[i / static_cast<size_t>(given.dim)];
        }
    }
    PointGrid grid{{{std::ssize(given.conditions)}, given.dim}, std::move(given.targets)};
    std::vector<int64_t> sources(given.conditions.size());
    std::iota(sources.begin(), sources.end(), 0);
    solve_axis(axis, sources, 0, grid);
    check_representable(grid);
    return make_result({std::move(knots)}, grid.dim, Form::polynomial, std::move(grid.points));
}

} // namespace nrb::fit
