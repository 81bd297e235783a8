// SPDX-License-Identifier: MIT
// Points and derivatives of curves by the Cox-de Boor recurrence, for spans without power spans. Included
// once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_CURVE_RECURRENCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_CURVE_RECURRENCE_INL_H_
#undef NURBS_EVAL_KERNELS_CURVE_RECURRENCE_INL_H_
#else
#define NURBS_EVAL_KERNELS_CURVE_RECURRENCE_INL_H_
#endif

#include "basis/bspline.h"
#include "eval/kernels/contract-inl.h"
#include "eval/kernels/curve_kernel.h"
#include "eval/kernels/finish-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// Computes the homogeneous record at a parameter into job.records; the quotient rule is left to the caller.
//
// Derivative k is made from the functions of degree p - k and the control points of that derivative. With
// derivatives of the functions instead, which sum to 0, the rounding errors of the part that all control
// points have in common would remain. For the same reason the quotient rule is applied to the curve relative
// to its own point at t; the point itself is written afterwards.
class CurveRecurrence {
public:
    explicit CurveRecurrence(const CurveJob &job) : job_(job), axis_(job.spline.axis(0)) {}

    // Returns whether the derivatives are relative to the point of the curve, which is then in job.point.
    bool run(int64_t span, double t) {
        const int order = job_.shape.order;
        basis_values_of_lower_degrees(axis_.knots().data(), degree(), span, t, order, job_.values);
        const ActiveRows rows = active_rows(span);
        contract(0, rows);
        if (order == 0 || job_.quotient == nullptr) {
            contract_derivatives(span, rows);
            return false;
        }
        std::copy_n(job_.records, job_.shape.lanes, job_.point);
        divide_record<1, 0>(job_.shape, job_.point);
        const ActiveRows moved = rows_from(job_.point, span, rows);
        contract(0, moved);
        contract_derivatives(span, moved);
        return true;
    }

private:
    // The active records, `stride` doubles apart.
    struct ActiveRows {
        const double *data;
        int64_t stride;
    };

    // The active records, from the table or made anew by the same code.
    ActiveRows active_rows(int64_t span) {
        const int width = job_.shape.width;
        const int64_t first = span - degree();
        if (job_.net != nullptr) {
            return {job_.net + first * width, width};
        }
        const int lanes = job_.shape.lanes;
        for (int j = 0; j <= degree(); ++j) {
            double *record = job_.window + static_cast<int64_t>(j) * lanes;
            job_.spline.record_part(first + j, 0, width, record);
            std::fill(record + width, record + lanes, 0.0);
        }
        return {job_.window, lanes};
    }

    // The active records of the curve minus `point`. For stored Cartesian points the difference and its
    // product with the weight are rounded once each; for homogeneous records the fused product and difference
    // are rounded once.
    ActiveRows rows_from(const double *point, int64_t span, const ActiveRows &rows) {
        const Vec4 d;
        const Spline &spline = job_.spline;
        const int lanes = job_.shape.lanes;
        const int dim = job_.shape.dim;
        const double *stored = spline.points().data() + (span - degree()) * spline.stored_width();
        double *record = job_.window;
        for (int j = 0; j <= degree(); ++j, record += lanes, stored += spline.stored_width()) {
            const double weight = rows.data[j * rows.stride + dim];
            for (int c = 0; spline.form() == Form::homogeneous && c < dim; ++c) {
                record[c] = std::fma(-point[c], weight, stored[c]);
            }
            for (int l = 0; spline.form() == Form::rational && l < dim; l += vec4_lanes) {
                const auto step = hn::Sub(hn::LoadU(d, stored + l), hn::LoadU(d, point + l));
                const auto product = hn::Mul(hn::Set(d, weight), step);
                hn::StoreU(weight == 0 ? hn::Zero(d) : product, d,
                           record + l); // even if the difference overflows
            }
            record[dim] = weight;
        }
        return {job_.window, lanes};
    }

    // Writes derivative k: the sum of the first p - k + 1 rows times the functions of degree p - k. The
    // padding lanes of a record may hold anything.
    void contract(int k, const ActiveRows &rows) {
        contract_rows(job_.values + static_cast<int64_t>(k) * (degree() + 1), degree() + 1 - k, rows.data,
                      rows.stride, job_.shape.lanes,
                      job_.records + static_cast<int64_t>(k) * job_.shape.lanes);
    }

    void contract_derivatives(int64_t span, ActiveRows rows) {
        const int highest = std::min(job_.shape.order, degree());
        for (int k = 1; k <= highest; ++k) {
            rows = differences(span, k, rows);
            contract(k, rows);
        }
        std::fill(job_.records + static_cast<int64_t>(highest + 1) * job_.shape.lanes,
                  job_.records + job_.shape.size(), 0.0);
    }

    // The control points of derivative k, from those of derivative k - 1, of which there is one more (Piegl &
    // Tiller 3.4). May work in place.
    ActiveRows differences(int64_t span, int k, const ActiveRows &rows) {
        const Vec4 d;
        const int lanes = job_.shape.lanes;
        const double *left = axis_.knots().data() + span - degree() + k;
        const double *right = axis_.knots().data() + span + 1;
        const auto factor = hn::Set(d, degree() - k + 1);
        for (int j = 0; j <= degree() - k; ++j) {
            const auto length = hn::Set(d, right[j] - left[j]);
            const double *row = rows.data + j * rows.stride;
            double *record = job_.window + static_cast<int64_t>(j) * lanes;
            for (int l = 0; l < lanes; l += vec4_lanes) {
                const auto step = hn::Sub(hn::LoadU(d, row + rows.stride + l), hn::LoadU(d, row + l));
                hn::StoreU(hn::Mul(factor, hn::Div(step, length)), d, record + l);
            }
        }
        return {job_.window, lanes};
    }

    [[nodiscard]] HWY_INLINE int degree() const { return axis_.degree(); }

    const CurveJob &job_;
    const KnotVector &axis_;
};

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
