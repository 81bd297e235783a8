// The arguments that all batch functions share.
#pragma once

#include "checks.h"

#include "eval/parameters.h"

namespace nrb::capi {

struct SplineBatch {
    const Spline &spline;
    AxisRules rules;
    ConstRecords params;
};

// Checks handle, flags and layout; the values are left to admit(), which comes when nothing else can fail.
inline SplineBatch spline_batch(const ::nurbs *g, int64_t n, const double *params, int64_t stride,
                                int64_t component_stride, uint32_t flags) {
    const Spline &spline = spline_of(g);
    const AxisRules rules = decode_rules(flags, spline.axes());
    check_length(n, "n");
    return {spline, rules, input("params", params, n, spline.axes(), stride, component_stride)};
}

inline void admit(const SplineBatch &batch) {
    check_parameters(batch.spline, batch.rules, batch.params);
}

struct KnotBatch {
    KnotVectorPtr axis;
    AxisRule rule;
    ConstRecords params;
};

inline KnotBatch knot_batch(int32_t degree, int64_t count, const double *knots, int64_t knot_count, int64_t n,
                            const double *params, int64_t stride, uint32_t flags) {
    check_degree(degree, -1);
    check_count(degree, count, -1);
    check_knot_total(knot_count, degree, count);
    require(knots, "knots");
    KnotVectorPtr axis = make_knot_vector(degree, std::vector<double>(knots, knots + knot_count));
    const AxisRule rule = decode_rules(flags, 1)[0];
    check_length(n, "n");
    return {std::move(axis), rule, input("params", params, n, stride)};
}

inline void admit(const KnotBatch &batch) {
    check_axis_parameters(*batch.axis, batch.rule, batch.params, 0);
}

} // namespace nrb::capi
