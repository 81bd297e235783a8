// SPDX-License-Identifier: MIT
// The arguments that all batch functions share: a spline or a knot vector, parameters, and evaluation flags.
#pragma once

#include "checks.h"
#include "evaluation_flags.h"

#include "base/checked.h"
#include "eval/parameters.h"

namespace nrb::capi {

struct SplineBatch {
    const Spline &spline;
    eval::AxisRules rules;
    ConstRecords params;
};

// Checks the handle, the flags and the layout. The values of the parameters are left to check_values(), which
// is called after all other checks.
inline SplineBatch spline_batch(const ::nurbs *g, int64_t n, const double *params, int64_t stride,
                                int64_t component_stride, uint32_t flags) {
    const Spline &spline = spline_of(g);
    const eval::AxisRules rules = decode_rules(flags, spline.axes());
    check_length(n, "n");
    return {spline, rules, input("params", params, n, spline.axes(), stride, component_stride)};
}

inline void check_values(const SplineBatch &batch) {
    eval::check_parameters(batch.spline, batch.rules, batch.params);
}

// The parameters of a grid as one view for each axis, and the caller's array of counts.
struct Grid {
    std::array<ConstRecords, max_axes> params;
    int64_t param_count = 0;
    int64_t point_count = 1;
    const int64_t *counts = nullptr;
    int axes = 0;
};

inline Grid grid_of(const Spline &spline, const int64_t *counts, const double *params) {
    require(counts, "counts");
    Grid grid;
    grid.counts = counts;
    grid.axes = spline.axes();
    for (int k = 0; k < spline.axes(); ++k) {
        if (counts[k] < 0) {
            fail(Status::count, "counts[%d] = %lld, expected >= 0", k, static_cast<long long>(counts[k]));
        }
        const int64_t first = grid.param_count;
        grid.param_count = checked_sum(first, counts[k], "params");
        grid.point_count = checked_product(grid.point_count, counts[k], "grid");
        grid.params[static_cast<size_t>(k)] = {params == nullptr ? nullptr : params + first, counts[k], 1, 1,
                                               1};
    }
    if (grid.param_count > 0) {
        require(params, "params");
    }
    return grid;
}

template <class Value>
void check_overlap(const char *name, RecordView<Value> out, const Grid &grid) {
    check_overlap(name, out, "params", input("params", grid.params[0].data, grid.param_count, 0));
    check_overlap(name, out.data, out.extent() * static_cast<int64_t>(sizeof(Value)), "counts", grid.counts,
                  grid.axes * static_cast<int64_t>(sizeof *grid.counts));
}

inline void check_values(const Spline &spline, const eval::AxisRules &rules, const Grid &grid) {
    int64_t first = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        eval::check_axis_parameters(spline.axis(k), rules[at], grid.params[at], first);
        first += grid.params[at].count;
    }
}

struct KnotBatch {
    KnotVectorPtr axis;
    eval::AxisRule rule;
    ConstRecords params;
};

inline KnotBatch knot_batch(int32_t degree, int64_t count, const double *knots, int64_t knot_count, int64_t n,
                            const double *params, int64_t stride, uint32_t flags) {
    check_degree(degree, -1);
    check_count(degree, count, -1);
    check_knot_total(knot_count, degree, count);
    require(knots, "knots");
    checked_array(knot_count, "knots");
    KnotVectorPtr axis = make_knot_vector(degree, std::vector<double>(knots, knots + knot_count));
    const eval::AxisRule rule = decode_rules(flags, 1)[0];
    check_length(n, "n");
    return {std::move(axis), rule, input("params", params, n, stride)};
}

inline void check_values(const KnotBatch &batch) {
    eval::check_axis_parameters(*batch.axis, batch.rule, batch.params, 0);
}

} // namespace nrb::capi
