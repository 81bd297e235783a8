#include "eval/curve_frames.h"

#include "eval/blocks.h"
#include "eval/curve_limit.h"
#include "eval/derivative_errors.h"
#include "eval/evaluate.h"
#include "eval/magnitude.h"
#include "eval/outputs.h"

namespace nrb {

namespace {

// The derivatives of orders 1 to 3 at a point; the third is 0 if the torsion is not wanted.
struct Derivatives {
    Vector3 first;
    Vector3 second;
    Vector3 third;
};

// Whether the point may be irregular, given bounds of the errors of the derivatives, or so large or small
// that squares leave the range of double. An infinite bound makes everything doubtful.
bool doubtful(const Derivatives &d, int dim, double error_1, double error_2) noexcept {
    const double speed = dot(d.first, d.first);
    if (!(in_range(speed) && speed > error_1 * error_1)) {
        return true;
    }
    const Vector3 product = cross(d.first, d.second);
    const double squared = dot(product, product);
    const double noise = std::sqrt(speed) * error_2 + std::sqrt(dot(d.second, d.second)) * error_1;
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
    const Vector3 across = (1 / area) * product; // perpendicular to its own rounding only
    frame.binormal = unit(across - dot(across, frame.tangent) * frame.tangent);
    frame.normal = cross(frame.binormal, frame.tangent);
    frame.curvature = area / speed / speed / speed;
    frame.torsion = dot(frame.binormal, d.third) / area;
    return frame;
}

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
    // A point that proves to be regular has the regular formula, so that nothing depends on the batch.
    [[nodiscard]] CurveFrame frame(const double *rows, int64_t i, int64_t index) const noexcept {
        const int dim = spline_.dim();
        const int64_t slot_rows = dim * block_size;
        const Derivatives d{row_vector(rows + slot_rows, dim, i), row_vector(rows + 2 * slot_rows, dim, i),
                            order_ > 2 ? row_vector(rows + 3 * slot_rows, dim, i) : Vector3{}};
        if (doubtful(d, dim, errors_.u, errors_.uu)) {
            CurveFrame limit = limit_frame(spline_, rules_, params_(index, 0));
            if (limit.status != 0 || doubtful(d, dim, 0, 0)) {
                return limit;
            }
        }
        return dim == 2 ? plane_frame(d) : space_frame(d);
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

void usual_frames(const Spline &spline, const AxisRules &rules, ConstRecords params, const CurveFrames &out) {
    const int order = out.torsions.data == nullptr ? 2 : 3;
    CurveSink sink(spline, rules, params, order, out);
    evaluate_points(spline, rules, order, params, sink);
}

// Nothing is written before all is known: this may run out of memory.
void frames_of_any_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const CurveFrames &out) {
    Pending tangents(out.tangents), normals(out.normals), binormals(out.binormals),
        curvatures(out.curvatures), torsions(out.torsions);
    std::vector<int32_t> status(static_cast<size_t>(params.count));
    for_each_magnitude(spline, rules, params, [&](const MagnitudeRun &run) {
        const int64_t first = run.first, count = run.params.count;
        usual_frames(run.spline, run.rules, run.params,
                     {{},
                      tangents.part(first, count),
                      normals.part(first, count),
                      binormals.part(first, count),
                      curvatures.part(first, count),
                      torsions.part(first, count),
                      status.data() + first});
        curvatures.multiply(first, count, run.size);
        torsions.multiply(first, count, run.size);
    });
    if (out.points.data != nullptr) {
        evaluate_points(spline, rules, 0, params, out.points);
    }
    for (const Pending *values : {&tangents, &normals, &binormals, &curvatures, &torsions}) {
        values->write();
    }
    if (out.status != nullptr) {
        std::copy(status.begin(), status.end(), out.status);
    }
}

} // namespace

void curve_frames(const Spline &spline, const AxisRules &rules, ConstRecords params, const CurveFrames &out) {
    usual_magnitude(spline) ? usual_frames(spline, rules, params, out)
                            : frames_of_any_size(spline, rules, params, out);
}

} // namespace nrb
