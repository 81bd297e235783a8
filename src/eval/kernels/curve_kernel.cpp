// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/curve_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "basis/bspline.h"
#include "eval/kernels/bernstein-inl.h"
#include "eval/kernels/curve_kernel.h"
#include "eval/kernels/curve_recurrence-inl.h"
#include "eval/kernels/curve_tables-inl.h"
#include "eval/kernels/finish-inl.h"
#include "eval/kernels/horner-inl.h"
#include "eval/kernels/rows-inl.h"

#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

static_assert(curve_group == group_size);

// Evaluates a curve block by block. Parameters strictly inside a span with a power span or a Bernstein span
// take the fast loops; all others are evaluated one by one by run_specially(). A parameter gives the same
// bits in every loop.
class CurveKernel {
public:
    CurveKernel(const CurveJob &job, const ConstRecords &params, const Records &out)
        : job_(job), params_(params), out_(out), axis_(job.spline.axis(0)), domain_(axis_.domain()),
          recurrence_(job), write_records_(job.shape, job.quotient, job.weights, out),
          write_rows_(job.shape, out) {}

    void run() {
        switch (job_.power_spans == nullptr ? -1 : job_.shape.order) {
        case -1:
            return run_without_tables();
        case 0:
            return run_order<1>();
        case 1:
            return run_order<2>();
        case 2:
            return run_order<3>();
        case 3: // torsion
            return run_params<4, -1, 0>();
        default:
            return run_params<most_orders, -1, 0>();
        }
    }

private:
    // The most frequent shapes have loops of their own, with the same results.
    template <int kOrders>
    void run_order() {
        if (job_.shape.lanes == 4) {
            degree() == 3 ? run_params<kOrders, 3, 4>() : run_params<kOrders, -1, 4>();
        } else {
            job_.shape.lanes == 8 ? run_params<kOrders, -1, 8>() : run_params<kOrders, -1, 0>();
        }
    }

    void run_without_tables() {
        for (int64_t i = 0; i < params_.count; ++i) {
            run_specially(params_(i, 0), i);
        }
    }

    // Evaluates all parameters in blocks. A block that lies in the same span as the block before it is
    // computed by vectors across the parameters. Other blocks are computed by vectors across the components,
    // in two passes, so that the searches of a block do not wait for its divisions.
    template <int kOrders, int kDegree, int kLanes>
    HWY_NOINLINE void run_params() {
        const CurveTables tables(job_);
        const ConstRecords &params = params_;
        const double *power_span = nullptr;
        double copy[curve_block];
        for (int64_t first = 0; first < params.count; first += curve_block) {
            const int count = static_cast<int>(std::min<int64_t>(curve_block, params.count - first));
            const double *block = block_of(params, first, count, copy);
            if (job_.rule.outside == Outside::wrap && !between(block, count, domain_.lower, domain_.upper)) {
                block = wrapped(block, count, copy);
            }
            const double *power_spans[curve_block];
            if (power_span != nullptr && count == curve_block &&
                between(block, count, power_span[PowerSpan::lower], power_span[PowerSpan::upper])) {
                run_in_piece<kOrders, kDegree>(block, power_span, first);
                continue;
            }
            if (!between(block, count, tables.domain.lower, tables.domain.upper) ||
                !tables.locate(block, count, power_spans)) {
                tables.locate_some(block, count, power_spans);
                run_mixed<kOrders, kDegree, kLanes>(tables, block, power_spans, count, first);
                power_span = nullptr;
                continue;
            }
            power_span = power_spans[count - 1];
            if constexpr (kLanes > 0) {
                run_quads<kOrders, kDegree, kLanes>(tables, block, power_spans, count, first);
            } else {
                run_records<kOrders, kDegree>(tables, block, power_spans, count, first);
            }
        }
    }

    // A block of parameters, contiguous in memory: the caller's array itself, or a copy.
    static HWY_INLINE const double *block_of(const ConstRecords &params, int64_t first, int count,
                                             double *copy) {
        const double *start = params.data + first * params.stride;
        if (params.stride == 1) {
            return start;
        }
        for (int i = 0; i < count; ++i) {
            copy[i] = start[i * params.stride];
        }
        return copy;
    }

    // Wraps the parameters of a block into the domain, with the same bits as place().
    const double *wrapped(const double *block, int count, double *copy) const {
        if (block != copy) {
            std::copy_n(block, count, copy);
        }
        std::fill(copy + count, copy + curve_block, domain_.lower);
        for (int i = 0; i < curve_block; i += vec8_lanes) {
            wrap_vector(copy + i);
        }
        return copy;
    }
    void wrap_each(double *params) const {
        std::transform(params, params + vec8_lanes, params,
                       [this](double param) { return place(param, job_.rule, domain_); });
    }
    HWY_INLINE void wrap_vector(double *params) const {
        if (!HWY_NATIVE_FMA) {
            return wrap_each(params);
        }
        const Vec8 d;
        const auto t = hn::LoadU(d, params);
        const auto lower = hn::Set(d, domain_.lower), upper = hn::Set(d, domain_.upper);
        const auto period = hn::Set(d, domain_.upper - domain_.lower);
        const auto x = hn::Sub(t, lower);
        const auto quotient = hn::Trunc(hn::Div(x, period));
        const auto exact = hn::Lt(hn::Abs(quotient), hn::Set(d, most_periods));
        if (!hn::AllTrue(d, exact)) {
            return wrap_each(params);
        }
        const auto signed_period = hn::CopySign(period, x);
        auto rest = hn::NegMulAdd(quotient, period, x);
        rest = hn::IfThenElse(hn::Lt(hn::Mul(rest, signed_period), hn::Zero(d)), hn::Add(rest, signed_period),
                              rest);
        rest = hn::IfThenElse(hn::Ge(hn::Abs(rest), period), hn::Sub(rest, signed_period), rest);
        const auto offset = hn::IfThenElse(hn::Lt(rest, hn::Zero(d)), hn::Add(rest, period), rest);
        const auto placed = hn::Clamp(hn::Add(lower, offset), lower, upper);
        const auto end = job_.rule.left ? lower : upper, other = job_.rule.left ? upper : lower;
        const auto inside = hn::And(hn::Lt(lower, t), hn::Lt(t, upper));
        hn::StoreU(hn::IfThenElse(inside, t, hn::IfThenElse(hn::Eq(placed, end), other, placed)), d, params);
    }

    // A full block in one power span: vectors across the parameters.
    template <int kOrders, int kDegree>
    HWY_NOINLINE void run_in_piece(const double *block, const double *power_span, int64_t first) {
        for (int i = 0; i < curve_block; i += group_size) {
            horner_rows<kOrders, kDegree>(block + i, power_span);
            if (job_.quotient != nullptr) {
                divide_group(job_.shape, *job_.quotient, job_.records);
            }
            write_rows_(first + i, group_size, job_.records);
        }
    }

    template <int kOrders, int kDegree>
    HWY_INLINE void run_records(const CurveTables &tables, const double *block,
                                const double *const *power_spans, int count, int64_t first) {
        for (int i = 0; i < count; ++i) {
            horner_record<kOrders, kDegree>(job_.shape.order, power_spans[i], tables.degree, tables.lanes,
                                            block[i], job_.records);
            write_records_(first + i, 1, job_.records);
        }
    }

    template <int kOrders, int kDegree>
    HWY_INLINE void horner_rows(const double *HWY_RESTRICT params, const double *HWY_RESTRICT power_span) {
        using V = hn::Vec<Vec8>;
        const Vec8 d;
        const int width = job_.shape.width;
        const int64_t slot_size = static_cast<int64_t>(width) * group_size;
        double *rows = job_.records;
        const double scale = power_span[PowerSpan::scale];
        for (int i = 0; i < group_size; i += vec8_lanes) {
            const V x = hn::Mul(hn::Sub(hn::LoadU(d, params + i), hn::Set(d, power_span[PowerSpan::middle])),
                                hn::Set(d, scale));
            for (int c = 0; c < width; ++c) {
                V y[kOrders];
                horner_vector<kOrders, kDegree>(d, OneComponent(), power_span + PowerSpan::head_size + c,
                                                degree(), job_.shape.lanes, x, scale, y);
                for (int k = 0; k < kOrders; ++k) {
                    if (kOrders < most_orders || k < job_.shape.slots) {
                        hn::Store(y[k], d, rows + k * slot_size + c * group_size + i);
                    }
                }
            }
        }
        for (int64_t rest = kOrders * slot_size; rest < job_.shape.slots * slot_size; ++rest) {
            rows[rest] = 0;
        }
    }

    // Records of four or eight lanes: they stay in registers from the coefficients to the caller's array.
    template <int kOrders, int kDegree, int kLanes>
    HWY_INLINE void run_quads(const CurveTables &tables, const double *block,
                              const double *const *power_spans, int count, int64_t first) {
        QuadWriter write(job_.shape, out_);
        for (int i = 0; i < count; ++i) {
            QuadRecord<kOrders, kLanes> record;
            power_quads<kOrders, kDegree>(tables, power_spans[i], block[i], record);
            write(record, first + i);
        }
        write.template finish<kOrders, kLanes>(first + count - 1);
    }

    // A block in which only some parameters, or none, lie inside a power span or a Bernstein span.
    template <int kOrders, int kDegree, int kLanes>
    HWY_NOINLINE void run_mixed(const CurveTables &tables, const double *block, const double *const *spans,
                                int count, int64_t first) {
        unsigned left = (1U << count) - 1;
        if constexpr (kLanes > 0) {
            left = run_mixed_quads<kOrders, kDegree, kLanes>(tables, block, spans, count, first);
        }
        for (int i = 0; i < count; ++i) {
            if ((left >> i & 1) != 0) {
                run_specially(block[i], first + i);
            }
        }
    }

    // Writes the records that can be made in registers and returns a bit set of the parameters that are left.
    // Packed records have to be written in rising order, so the other parameters are evaluated in between. A
    // writer that collects rows writes later; then the other parameters are left to the caller, after the
    // rows.
    template <int kOrders, int kDegree, int kLanes>
    HWY_INLINE unsigned run_mixed_quads(const CurveTables &tables, const double *block,
                                        const double *const *spans, int count, int64_t first) {
        unsigned left = 0;
        QuadWriter write(job_.shape, out_);
        for (int i = 0; i < count; ++i) {
            QuadRecord<kOrders, kLanes> record;
            if (quads_of<kOrders, kDegree>(tables, spans[i], block[i], record)) {
                write(record, first + i);
                continue;
            }
            write.template skip<kOrders, kLanes>(first + i);
            if (write.waits()) {
                left |= 1U << i;
            } else {
                run_specially(block[i], first + i);
            }
        }
        write.template finish<kOrders, kLanes>(first + count - 1);
        return left;
    }

    // The record at t from its span; false if the span offers no form that fits.
    template <int kOrders, int kDegree, int kLanes>
    HWY_INLINE bool quads_of(const CurveTables &tables, const double *span, double t,
                             QuadRecord<kOrders, kLanes> &record) {
        if (span != nullptr && t > span[PowerSpan::lower]) {
            power_quads<kOrders, kDegree>(tables, span, t, record);
            return true;
        }
        return span != nullptr && bernstein_quads(tables, span, t, record);
    }

    template <int kOrders, int kDegree, int kLanes>
    HWY_INLINE void power_quads(const CurveTables &tables, const double *power_span, double t,
                                QuadRecord<kOrders, kLanes> &record) {
        const Vec4 d;
        const double scale = power_span[PowerSpan::scale];
        const auto x = hn::Set(d, (t - power_span[PowerSpan::middle]) * scale);
        for (int part = 0; part < record.parts; ++part) {
            horner_vector<kOrders, kDegree>(d, Components(),
                                            power_span + PowerSpan::head_size + part * vec4_lanes,
                                            tables.degree, kLanes, x, scale, record.values[part]);
        }
        if (job_.quotient != nullptr) {
            record.template divide_by_weight<1, kOrders - 1>(tables.dim);
        }
    }

    template <int kOrders, int kLanes>
    static HWY_INLINE bool bernstein_quads(const CurveTables &tables, const double *span, double t,
                                           QuadRecord<kOrders, kLanes> &record) {
        if constexpr (kOrders > 1) {
            return false;
        } else {
            if (tables.bernstein_lanes != kLanes || !inside_bernstein_span(span, t)) {
                return false;
            }
            const BernsteinPlace place(span, tables.degree, kLanes, t);
            for (int part = 0; part < record.parts; ++part) {
                record.values[part][0] = place.components(tables.degree, part * vec4_lanes);
            }
            record.template divide_by_weight<1, 0>(tables.dim);
            return true;
        }
    }

    // One parameter of any kind: outside the domain, at a knot, or without tables.
    HWY_NOINLINE void run_specially(double param, int64_t i) {
        const double t = place(param, job_.rule, domain_);
        if (t != t) {
            return write_nan(job_.shape.values(), out_, i);
        }
        const int64_t span = axis_.find_span(t, job_.rule.left);
        if (job_.spline.has_power_span(span)) {
            horner(job_.shape.order, piece_of(span, t), degree(), job_.shape.lanes, t, job_.records);
            write_records_(i, 1, job_.records);
        } else {
            write_without_power_span(span, t, i);
        }
        const int sole = sole_function(axis_.knots().data(), degree(), span, t);
        if (sole >= 0) {
            write_control_point(job_.spline, span - degree() + sole, out_, i);
        }
    }

    // Takes the point from the Bernstein span, if there is one, and everything else from the recurrences.
    void write_without_power_span(int64_t span, double t, int64_t i) {
        const double *const found =
            t > axis_[span] && t < axis_[span + 1] ? bernstein_span_of(span, t) : nullptr;
        if (found == nullptr || job_.shape.order > 0) {
            const bool moved = recurrence_.run(span, t);
            write_records_(i, 1, job_.records);
            if (moved) {
                write_point(i);
            }
        }
        if (found != nullptr) {
            bernstein_point(found, degree(), job_.shape.dim, job_.spline.span_lanes(), t, job_.point);
            write_point(i);
        }
    }
    void write_point(int64_t i) const {
        for (int c = 0; c < job_.shape.dim; ++c) {
            out_(i, c) = job_.point[c];
        }
    }

    // The Bernstein span, from the table or made anew by the same code; null if there is none.
    const double *bernstein_span_of(int64_t span, double t) {
        if (job_.power_spans != nullptr) {
            const double *const found = (*job_.power_spans)[job_.spans->number(t, job_.rule.left)];
            return std::isnan(found[BernsteinSpan::a]) ? nullptr : found;
        }
        if (!job_.spline.has_bernstein_span(span)) {
            return nullptr;
        }
        if (std::exchange(made_, span) != span) {
            job_.spline.curve_bernstein_span(span, job_.window, job_.power_span);
        }
        return job_.power_span;
    }

    // The power span, from the table or made anew by the same code.
    const double *piece_of(int64_t span, double t) {
        if (job_.power_spans != nullptr) {
            return (*job_.power_spans)[job_.spans->number(t, job_.rule.left)];
        }
        if (std::exchange(made_, span) != span) {
            job_.spline.curve_power_span(span, job_.window, job_.power_span);
        }
        return job_.power_span;
    }

    [[nodiscard]] HWY_INLINE int degree() const { return axis_.degree(); }

    const CurveJob &job_;
    const ConstRecords &params_;
    const Records &out_;
    const KnotVector &axis_;
    Interval domain_;
    CurveRecurrence recurrence_;
    RecordWriter write_records_;
    RowWriter write_rows_;
    int64_t made_ = -1; // the span that job_.power_span holds, while there is no table
};

void run_curve(const CurveJob &job, const ConstRecords &params, const Records &out) {
    CurveKernel(job, params, out).run();
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(run_curve);

void run(const CurveJob &job, const ConstRecords &params, const Records &out) noexcept {
    NURBS_BEST(run_curve)(job, params, out);
}

} // namespace nrb::eval
#endif
