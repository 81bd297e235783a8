// SPDX-License-Identifier: MIT
// The search for the spans of a block of parameters of a curve. Included once for every instruction set: see
// base/simd.h.
#if defined(NURBS_EVAL_KERNELS_CURVE_TABLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_CURVE_TABLES_INL_H_
#undef NURBS_EVAL_KERNELS_CURVE_TABLES_INL_H_
#else
#define NURBS_EVAL_KERNELS_CURVE_TABLES_INL_H_
#endif

#include "eval/kernels/curve_kernel.h"
#include "eval/kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// The tables that the loops over ordinary parameters read, kept in registers.
struct CurveTables {
    explicit CurveTables(const CurveJob &job)
        : domain(job.spline.axis(0).domain()), find(job.spans->finder()), power_spans((*job.power_spans)[0]),
          power_span_size(job.power_spans->size()), degree(job.spline.axis(0).degree()),
          lanes(job.shape.lanes), bernstein_lanes(job.spline.span_lanes()), dim(job.shape.dim) {}

    // Finds the spans of `count` parameters inside the domain. Returns false unless every parameter lies
    // strictly inside its span and every span has a power span.
    [[nodiscard]] HWY_INLINE bool locate(const double *HWY_RESTRICT params, int count,
                                         const double **HWY_RESTRICT found) const {
        bool all = true;
        for (int i = 0; i < count; ++i) {
            const double *power_span = power_spans + find.number_inside(params[i]) * power_span_size;
            found[i] = power_span;
            all &= params[i] > power_span[PowerSpan::lower];
        }
        return all;
    }
    // The same for any parameters. found[i] is null if parameter i does not lie strictly inside the domain.
    HWY_INLINE void locate_some(const double *HWY_RESTRICT params, int count,
                                const double **HWY_RESTRICT found) const {
        for (int i = 0; i < count; ++i) {
            const bool inside = params[i] > domain.lower && params[i] < domain.upper;
            found[i] = inside ? power_spans + find.number_inside(params[i]) * power_span_size : nullptr;
        }
    }

    Interval domain;
    SpanTable::Finder find;
    const double *power_spans;
    int64_t power_span_size;
    int degree;
    int lanes;
    int bernstein_lanes;
    int dim;
};

// Whether all parameters of a block lie strictly between two bounds, which NaN does not.
HWY_INLINE bool between(const double *block, int count, double lower_bound, double upper_bound) {
    if (count < curve_block) {
        bool all = true;
        for (int i = 0; i < count; ++i) {
            all = all && block[i] > lower_bound && block[i] < upper_bound;
        }
        return all;
    }
    const Vec8 d;
    const auto lower = hn::Set(d, lower_bound);
    const auto upper = hn::Set(d, upper_bound);
    auto all = hn::And(hn::Lt(lower, hn::LoadU(d, block)), hn::Lt(hn::LoadU(d, block), upper));
    for (int i = vec8_lanes; i < curve_block; i += vec8_lanes) {
        const auto t = hn::LoadU(d, block + i);
        all = hn::And(all, hn::And(hn::Lt(lower, t), hn::Lt(t, upper)));
    }
    return hn::AllTrue(d, all);
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
