// SPDX-License-Identifier: MIT
#include "fit/interpolate.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "base/small_width.h"
#include "base/watch.h"
#include "fit/mixed_derivatives.h"
#include "fit/tangent_lengths.h"

#include <algorithm>

namespace nrb::fit {

namespace {

constexpr int64_t work_of_a_value = 4; // of moving it

// A range of the outer blocks of an axis of a grid (GridLayers).
struct Blocks {
    int64_t first, end;
    [[nodiscard]] int64_t count() const noexcept { return end - first; }
};

// Copies the layers of a block, which are contiguous, to places `step` doubles apart; collect() copies them
// back.
void spread(const double *block, int64_t layers, int64_t inner, double *places, int64_t step) noexcept {
    with_width(inner, [=](auto width) {
        for (int64_t i = 0; i < layers; ++i) {
            std::copy_n(block + i * width, static_cast<int64_t>(width), places + i * step);
        }
    });
}
void collect(const double *places, int64_t step, int64_t layers, int64_t inner, double *block) noexcept {
    with_width(inner, [=](auto width) {
        for (int64_t i = 0; i < layers; ++i) {
            std::copy_n(places + i * step, static_cast<int64_t>(width), block + i * width);
        }
    });
}

// Puts the right-hand sides of each condition together for all blocks, [conditions][blocks * inner]: layer
// sources[i] of the grid, zeros for -1; without sources, layer i.
void gather(const PointGrid &grid, const GridLayers &of, int64_t conditions, std::span<const int64_t> sources,
            const Blocks &blocks, std::vector<double> &values) {
    const int64_t step = blocks.count() * of.inner;
    values.resize(static_cast<size_t>(conditions * step));
    for (int64_t o = blocks.first; o < blocks.end; ++o) {
        count_work(work_of_a_value * conditions * of.inner);
        const double *const block = grid.points.data() + o * of.count * of.inner;
        double *const places = values.data() + (o - blocks.first) * of.inner;
        if (sources.empty()) {
            spread(block, conditions, of.inner, places, step);
            continue;
        }
        for (size_t i = 0; i < sources.size(); ++i) {
            double *const place = places + static_cast<int64_t>(i) * step;
            sources[i] < 0 ? std::fill_n(place, of.inner, 0.0)
                           : std::copy_n(block + sources[i] * of.inner, of.inner, place);
        }
    }
}

// Writes the layers of control points back, `stored` of them per block; on a periodic axis the first ones are
// repeated at the end.
void scatter(const std::vector<double> &values, int64_t inner, int64_t stored, int64_t distinct,
             const Blocks &blocks, double *points) {
    const int64_t step = blocks.count() * inner;
    for (int64_t o = blocks.first; o < blocks.end; ++o) {
        count_work(work_of_a_value * stored * inner);
        const double *const places = values.data() + (o - blocks.first) * inner;
        for (int64_t first = 0; first < stored; first += distinct) {
            collect(places, step, std::min(distinct, stored - first), inner,
                    points + (o * stored + first) * inner);
        }
    }
}

// Replaces the layers of data along axis k by layers of control points.
void solve_axis(const AxisInterpolation &axis, std::span<const int64_t> sources, size_t k, PointGrid &grid) {
    const GridLayers of = layers_of(grid, k);
    const int64_t stored = axis.knots()->count();
    if (of.outer == 1 && stored == of.count && sources.empty()) {
        return axis.solve(grid.points, of.inner);
    }
    std::vector<double> other; // where their number is not that of the data
    if (stored != of.count) {
        other.resize(static_cast<size_t>(of.outer * stored * of.inner));
    }
    const int64_t together = std::max<int64_t>(1, axis.best_width() / of.inner);
    std::vector<double> values;
    for (Blocks blocks{0, 0}; blocks.first < of.outer; blocks.first = blocks.end) {
        blocks.end = std::min(blocks.first + together, of.outer);
        gather(grid, of, axis.conditions(), sources, blocks, values);
        axis.solve(values, blocks.count() * of.inner);
        scatter(values, of.inner, stored, axis.knots()->distinct_layers(), blocks,
                stored == of.count ? grid.points.data() : other.data());
    }
    if (stored != of.count) {
        grid.counts[k] = stored;
        grid.points = std::move(other);
    }
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

// Calls body(k, parameters of axis k, index of the first of them).
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
        check_layers({{own, {}}}, 0, false, k, offset);
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
        axes.push_back({{own, orders.empty() ? orders : orders.subspan(first, own.size())}});
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
        axes.push_back(interpolation_knots(degrees[k], layers[k].params_of_values(room), ends[k],
                                           grid.periodic[k], static_cast<int>(k), layers[k].derivatives()));
    }
    check_closed(grid);
    estimate_mixed(layers, degrees, grid);
    Steps steps(std::ssize(axes));
    for (size_t k = 0; k < layers.size(); ++k) {
        const AxisConditions all = conditions_of(layers[k], degrees[k], ends[k], grid.periodic[k]);
        solve_axis({axes[k], all.sites(), static_cast<int>(k)}, all.sources(), k, grid);
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
        solve_axis({axes[k], {own, {}}, static_cast<int>(k)}, {}, k, grid);
        steps.next();
    });
    check_representable(grid);
    return make_result(axes, grid.dim, Form::polynomial, std::move(grid.points));
}

namespace {

// Throws Status::outside_domain for a condition outside the domain of the knots, and what AxisInterpolation
// throws.
AxisInterpolation checked_axis(const CurveConditions &given, KnotVectorPtr knots) {
    for (size_t i = 0; i < given.params.size(); ++i) {
        check_inside(given.params[i], knots->domain(), 0, static_cast<int64_t>(i));
    }
    return {std::move(knots), {given.params, given.orders}, 0};
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
    PointGrid grid{{{axis.conditions()}, given.dim}, std::move(given.targets)};
    solve_axis(axis, {}, 0, grid);
    check_representable(grid);
    return make_result({std::move(knots)}, grid.dim, Form::polynomial, std::move(grid.points));
}

} // namespace nrb::fit
