// SPDX-License-Identifier: MIT
#include "eval/frames/curve_frames.h"

#include "eval/blocks.h"
#include "eval/derivative_errors.h"
#include "eval/evaluate.h"
#include "eval/frames/curve_limit.h"
#include "eval/frames/waiting_outputs.h"

namespace nrb::eval {

namespace {

// The derivatives of orders 1 to 3 at a point; the third is 0 if the torsion is not wanted.
struct Derivatives {
    Vector3 first;
    Vector3 second;
    Vector3 third;
};

// Bounds of the errors of the first two derivatives.
struct Errors {
    double first = 0;
    double second = 0;
};

// Whether the point may be irregular (C' = 0 or, in space, C' x C'' = 0 within the error bounds), or so large
// or small that squares leave the range of double. An infinite bound makes every point doubtful.
bool doubtful(const Derivatives &d, int dim, const Errors &errors) noexcept {
    const double speed = dot(d.first, d.first);
    if (!(in_range(speed) && speed > errors.first * errors.first)) {
        return true;
    }
    const Vector3 product = cross(d.first, d.second);
    const double squared = dot(product, product);
    const double noise = std::sqrt(speed) * errors.second + std::sqrt(dot(d.second, d.second)) * errors.first;
    return dim == 3 && !(in_range(squared) && squared > noise * noise);
}

CurveFrame plane_frame(const Derivatives &d) noexcept {
    CurveFrame frame;
    const double speed = std::sqrt(dot(d.first, d.first));
    frame.tangent = (1 / speed) * d.first;
    frame.normal = {-frame.tangent.y, frame.tangent.x, 0};
    frame.curvature = dot(d.second, frame.normal) / speed / speed;
    return frame;
}

CurveFrame space_frame(const Derivatives &d) noexcept {
    CurveFrame frame;
    const double speed = std::sqrt(dot(d.first, d.first));
    const Vector3 product = cross(d.first, d.second);
    const double area = std::sqrt(dot(product, product));
    frame.tangent = (1 / speed) * d.first;
    const Vector3 across = (1 / area) * product; // perpendicular to T only up to the rounding of the product
    frame.binormal = unit(across - dot(across, frame.tangent) * frame.tangent);
    frame.normal = cross(frame.binormal, frame.tangent);
    frame.curvature = area / speed / speed / speed;
    frame.torsion = dot(frame.binormal, d.third) / area;
    return frame;
}

CurveFrame regular_frame(const Derivatives &d, int dim) noexcept {
    return dim == 2 ? plane_frame(d) : space_frame(d);
}

// Multiplies each derivative by a power of two of its own that brings it near 1.
class NearOne {
public:
    explicit NearOne(const Derivatives &d) noexcept
        : first_(size_exponent(d.first)), second_(size_exponent(d.second)),
          third_(size_exponent(d.third)), scaled_{times_power(d.first, -first_),
                                                  times_power(d.second, -second_),
                                                  times_power(d.third, -third_)} {}

    [[nodiscard]] const Derivatives &derivatives() const noexcept { return scaled_; }
    [[nodiscard]] Errors scaled(const Errors &errors) const noexcept {
        return {std::ldexp(errors.first, -first_), std::ldexp(errors.second, -second_)};
    }
    [[nodiscard]] CurveFrame unscaled(CurveFrame frame) const noexcept {
        frame.curvature = std::ldexp(frame.curvature, second_ - 2 * first_);
        frame.torsion = std::ldexp(frame.torsion, third_ - first_ - second_);
        return frame;
    }

private:
    int first_, second_, third_;
    Derivatives scaled_;
};

// Computes the frames of each block of points and derivatives.
class CurveSink final : public BlockSink {
public:
    CurveSink(const Spline &spline, const AxisRules &rules, ConstRecords params, int order,
              const CurveFrames &out)
        : spline_(spline), rules_(rules), params_(params), order_(order), out_(out) {
        Jet::prepare(spline);
        errors_ = derivative_errors(spline, rules, params.count);
    }

    void operator()(int64_t first, ConstRecords values) noexcept override {
        write_rows(values.data, first, values.count, out_.points);
        for (int64_t i = 0; i < values.count; ++i) {
            write(frame(values.data, i, first + i), first + i);
        }
    }

private:
    // Points that turn out to be regular after a closer look use the same formula as all other regular
    // points, so that no result depends on the batch.
    [[nodiscard]] CurveFrame frame(const double *rows, int64_t i, int64_t index) const noexcept {
        const int dim = spline_.dim();
        const int64_t slot_rows = dim * block_size;
        const Derivatives d{row_vector(rows + slot_rows, dim, i), row_vector(rows + 2 * slot_rows, dim, i),
                            order_ > 2 ? row_vector(rows + 3 * slot_rows, dim, i) : Vector3{}};
        const Errors errors{errors_.u, errors_.uu};
        return doubtful(d, dim, errors) ? frame_in_doubt(d, errors, index) : regular_frame(d, dim);
    }

    [[nodiscard]] CurveFrame frame_in_doubt(const Derivatives &given, const Errors &errors,
                                            int64_t index) const noexcept {
        const int dim = spline_.dim();
        const NearOne near(given);
        const Derivatives &d = near.derivatives();
        if (doubtful(d, dim, near.scaled(errors))) {
            const CurveFrame limit = limit_frame(spline_, rules_, params_(index, 0));
            if (limit.status != 0 || doubtful(d, dim, {})) {
                return limit;
            }
        }
        return near.unscaled(regular_frame(d, dim));
    }

    void write(const CurveFrame &frame, int64_t i) const noexcept {
        write_vector(frame.tangent, i, out_.tangents);
        write_vector(frame.normal, i, out_.normals);
        write_vector(frame.binormal, i, out_.binormals);
        write_value(frame.curvature, i, out_.curvatures);
        write_value(frame.torsion, i, out_.torsions);
        write_status(frame.status, i, out_.status);
    }

    const Spline &spline_;
    const AxisRules &rules_;
    ConstRecords params_;
    int order_;
    CurveFrames out_;
    DerivativeErrors errors_;
};

void frames_of_usual_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                          const CurveFrames &out) {
    const int order = out.torsions.data == nullptr ? 2 : 3;
    CurveSink sink(spline, rules, params, order, out);
    evaluate_points(spline, rules, order, params, sink);
}

void frames_of_any_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const CurveFrames &out) {
    WaitingOutputs waiting(
        {{out.tangents}, {out.normals}, {out.binormals}, {out.curvatures, 1}, {out.torsions, 1}}, out.status,
        params.count);
    const std::vector<int64_t> order =
        for_each_magnitude(spline, rules, params, [&](const MagnitudeRun &run) {
            frames_of_usual_size(run.spline, run.rules, run.params,
                                 {{},
                                  waiting.part(0, run),
                                  waiting.part(1, run),
                                  waiting.part(2, run),
                                  waiting.part(3, run),
                                  waiting.part(4, run),
                                  waiting.status(run)});
            waiting.finish(run);
        });
    if (out.points.data != nullptr) {
        evaluate_points(spline, rules, 0, params, out.points);
    }
    waiting.write(order);
}

} // namespace

void curve_frames(const Spline &spline, const AxisRules &rules, ConstRecords params, const CurveFrames &out) {
    usual_magnitude(spline) ? frames_of_usual_size(spline, rules, params, out)
                            : frames_of_any_size(spline, rules, params, out);
}

} // namespace nrb::eval
