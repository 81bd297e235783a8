// SPDX-License-Identifier: MIT
#include "eval/frames/curvature.h"

#include "base/numbers.h"
#include "eval/blocks.h"
#include "eval/frames/jet.h"
#include "eval/frames/shape_operator.h"
#include "eval/frames/waiting_outputs.h"

namespace nrb::eval {

namespace {

constexpr int dim = 3;

// The derivatives at point i of a block, whose slots are S, S_u, S_v, S_uu, S_uv, S_vv.
SurfaceDerivatives derivatives_at(const double *rows, int64_t i) noexcept {
    constexpr int64_t slot_rows = dim * block_size;
    const double *at = rows + slot_rows;
    return {row_vector(at, dim, i), row_vector(at + slot_rows, dim, i),
            row_vector(at + 2 * slot_rows, dim, i), row_vector(at + 3 * slot_rows, dim, i),
            row_vector(at + 4 * slot_rows, dim, i)};
}

// The derivatives with respect to parameters whose units are those of a jet, about one knot span, so that
// products of derivatives stay in the range of double.
SurfaceDerivatives in_units(const SurfaceDerivatives &d, double u, double v) noexcept {
    return {u * d.u, v * d.v, u * u * d.uu, u * v * d.uv, v * v * d.vv};
}

// Error bounds of the derivatives in these units: a Taylor coefficient times i! j! is the derivative.
DerivativeErrors errors_at(const Jet &jet) noexcept {
    return {jet.error(1, 0), jet.error(0, 1), 2 * jet.error(2, 0), jet.error(1, 1), 2 * jet.error(0, 2)};
}

// Computes the curvatures of each block of points and derivatives.
class CurvatureSink final : public BlockSink {
public:
    CurvatureSink(const Spline &spline, const AxisRules &rules, ConstRecords params,
                  const SurfaceCurvatures &out)
        : spline_(spline), rules_(rules), params_(params), out_(out) {
        Jet::prepare(spline);
        errors_ = derivative_errors(spline, rules, params.count);
    }

    void operator()(int64_t first, ConstRecords values) noexcept override {
        for (int64_t i = 0; i < values.count; ++i) {
            const SurfaceDerivatives d = derivatives_at(values.data, i);
            const ShapeOperator w(d);
            const int32_t status = status_of(d, w, first + i);
            write_status(status, first + i, out_.status);
            if (status == frame_undefined) {
                write_none(first + i);
            } else {
                write(w, status == frame_rule, first + i);
            }
        }
    }

private:
    // The status of point i. The bounds that hold everywhere are tested first; only if they leave a doubt, a
    // jet gives the bounds at this point.
    [[nodiscard]] int32_t status_of(const SurfaceDerivatives &d, const ShapeOperator &w,
                                    int64_t i) const noexcept {
        if (regular(d, errors_) && w.spread() > w.spread_error(d, errors_)) {
            return 0;
        }
        const std::array<double, 2> param{params_(i, 0), params_(i, 1)};
        Jet jet;
        if (!jet.evaluate(spline_, rules_, param.data(), 2)) {
            return frame_undefined;
        }
        const SurfaceDerivatives own = in_units(d, jet.unit(0), jet.unit(1));
        const DerivativeErrors errors = errors_at(jet);
        if (!regular(own, errors)) {
            return frame_undefined;
        }
        const ShapeOperator in_own_units(own);
        return in_own_units.spread() > in_own_units.spread_error(own, errors) ? 0 : frame_rule;
    }

    void write(const ShapeOperator &w, bool umbilic, int64_t i) const noexcept {
        if (out_.principal.data != nullptr) {
            out_.principal(i, 0) = w.mean() + w.spread();
            out_.principal(i, 1) = w.mean() - w.spread();
        }
        const Vector3 direction = umbilic ? w.e1() : w.direction();
        write_vector(direction, i, out_.directions);
        write_vector(cross(w.normal(), direction), i, out_.directions, dim);
        write_value(w.mean(), i, out_.mean);
        write_value(w.gaussian(), i, out_.gaussian);
    }

    void write_none(int64_t i) const noexcept {
        const Vector3 none{nan_value, nan_value, nan_value};
        if (out_.principal.data != nullptr) {
            out_.principal(i, 0) = nan_value;
            out_.principal(i, 1) = nan_value;
        }
        write_vector(none, i, out_.directions);
        write_vector(none, i, out_.directions, dim);
        write_value(nan_value, i, out_.mean);
        write_value(nan_value, i, out_.gaussian);
    }

    const Spline &spline_;
    const AxisRules &rules_;
    ConstRecords params_;
    SurfaceCurvatures out_;
    DerivativeErrors errors_;
};

void usual_curvatures(const Spline &spline, const AxisRules &rules, ConstRecords params,
                      const SurfaceCurvatures &out) {
    CurvatureSink sink(spline, rules, params, out);
    evaluate_points(spline, rules, 2, params, sink);
}

void curvatures_of_any_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                            const SurfaceCurvatures &out) {
    WaitingOutputs waiting({{out.principal, 1}, {out.directions}, {out.mean, 1}, {out.gaussian, 2}},
                           out.status, params.count);
    waiting.write(for_each_magnitude(spline, rules, params, [&](const MagnitudeRun &run) {
        usual_curvatures(run.spline, run.rules, run.params,
                         {waiting.part(0, run), waiting.part(1, run), waiting.part(2, run),
                          waiting.part(3, run), waiting.status(run)});
        waiting.finish(run);
    }));
}

} // namespace

void surface_curvatures(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const SurfaceCurvatures &out) {
    usual_magnitude(spline) ? usual_curvatures(spline, rules, params, out)
                            : curvatures_of_any_size(spline, rules, params, out);
}

} // namespace nrb::eval
