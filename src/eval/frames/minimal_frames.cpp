// SPDX-License-Identifier: MIT
#include "eval/frames/minimal_frames.h"

#include "base/numbers.h"
#include "eval/blocks.h"
#include "eval/derivative_errors.h"
#include "eval/evaluate.h"
#include "eval/frames/curve_limit.h"
#include "eval/frames/frame_outputs.h"
#include "eval/frames/magnitude.h"

#include <hwy/base.h>
#include <optional>

namespace nrb::eval {

namespace {

// The reflection of a in the plane through the origin that is perpendicular to v. v may have any length
// except 0.
Vector3 reflected(const Vector3 &a, const Vector3 &v) noexcept {
    const Vector3 w = in_range(dot(v, v)) ? v : scaled_to_one(v);
    return a - (2 * dot(w, a) / dot(w, w)) * w;
}

bool is_zero(const Vector3 &v) noexcept {
    return largest(v) == 0;
}

// The frame that is carried along the sequence.
struct TransportedFrame {
    Vector3 point;
    Vector3 tangent;
    Vector3 normal;
};

// The normal after the shortest rotation that takes the tangent a to the next tangent b. The rotation
// consists of the reflections across a, which leaves the normal unchanged, and across a + b. If the tangents
// are opposite, the normal is kept.
Vector3 turned_normal(const TransportedFrame &from, const Vector3 &tangent) noexcept {
    const Vector3 sum = from.tangent + tangent;
    return is_zero(sum) ? from.normal : reflected(from.normal, sum);
}

// One step of double reflection. The normal is made perpendicular to the tangent again in each step, so that
// errors do not accumulate along the sequence. Two points closer than `noise` may be the same point: their
// chord has no meaning.
HWY_INLINE Vector3 next_normal(const TransportedFrame &from, const Vector3 &point, const Vector3 &tangent,
                               double noise) noexcept {
    const Vector3 chord = point - from.point;
    if (!(length(chord) > noise)) {
        return unit_across(turned_normal(from, tangent), tangent);
    }
    const Vector3 normal = reflected(from.normal, chord);
    const Vector3 turn = tangent - reflected(from.tangent, chord);
    return unit_across(is_zero(turn) ? normal : reflected(normal, turn), tangent);
}

// The tangents of all points. Those of regular points come from the derivatives in the block.
class Tangents {
public:
    Tangents(const Spline &spline, const AxisRules &rules, int64_t points) : spline_(spline), rules_(rules) {
        Jet::prepare(spline);
        error_ = derivative_errors(spline, rules, points).u;
    }

    [[nodiscard]] HWY_INLINE CurveTangent operator()(const Vector3 &first, double t) const noexcept {
        const double squared = dot(first, first);
        if (!in_range(squared) || !(squared > error_ * error_)) {
            const CurveTangent limit = curve_tangent(spline_, rules_, t);
            return limit.kind == 1 ? CurveTangent{1, unit(first)} : limit;
        }
        return {1, (1 / std::sqrt(squared)) * first};
    }

private:
    const Spline &spline_;
    const AxisRules &rules_;
    double error_ = 0;
};

// How far apart two computed points may be if their exact points coincide: twice c(p) eps hull of nurbs.h in
// each coordinate.
double point_noise(int degree, double size) noexcept {
    return 2 * std::sqrt(3.0) * accuracy_factor(degree) * eps * size;
}

// Carries the frame from point to point, in the order of the sequence. Its operator and what that calls are
// inlined, so that a point goes from the block to the caller's arrays in registers.
class Transport {
public:
    Transport(double noise, const std::optional<Vector3> &first_normal, const MinimalFrames &out)
        : noise_(noise), first_normal_(first_normal), out_(out) {}

    HWY_INLINE void operator()(int64_t i, const Vector3 &point, const CurveTangent &tangent) noexcept {
        if (tangent.kind > 0) {
            advance(point, tangent.direction);
            write(i, tangent.kind == 1 ? 0 : frame_limit);
        } else {
            write_none(i);
        }
    }

private:
    HWY_INLINE void advance(const Vector3 &point, const Vector3 &tangent) noexcept {
        const Vector3 normal = last_           ? next_normal(*last_, point, tangent, noise_)
                               : first_normal_ ? unit_across(scaled_to_one(*first_normal_), tangent)
                                               : any_normal(tangent);
        last_ = TransportedFrame{point, tangent, normal};
    }

    HWY_INLINE void write(int64_t i, int32_t status) const noexcept {
        write_vector(last_->tangent, i, out_.tangents);
        write_vector(last_->normal, i, out_.normals);
        write_vector(cross(last_->tangent, last_->normal), i, out_.binormals);
        write_status(status, i, out_.status);
    }

    void write_none(int64_t i) const noexcept {
        const Vector3 none{nan_value, nan_value, nan_value};
        write_vector(none, i, out_.tangents);
        write_vector(none, i, out_.normals);
        write_vector(none, i, out_.binormals);
        write_status(frame_undefined, i, out_.status);
    }

    double noise_;
    std::optional<Vector3> first_normal_;
    MinimalFrames out_;
    std::optional<TransportedFrame> last_;
};

Vector3 derivative_at(ConstRecords values, int64_t i) noexcept {
    return row_vector(values.data + space_dim * block_size, space_dim, i);
}

// Transports the frame through each block of points and derivatives; relies on blocks in rising order.
class MinimalSink final : public BlockSink {
public:
    MinimalSink(const Spline &spline, const AxisRules &rules, ConstRecords params,
                const std::optional<Vector3> &first_normal, const MinimalFrames &out)
        : tangents_(spline, rules, params.count), params_(params), points_(out.points),
          transport_(point_noise(spline.axis(0).degree(), active_size(spline)), first_normal, out) {}

    void operator()(int64_t first, ConstRecords values) noexcept override {
        write_rows(values.data, first, values.count, points_);
        for (int64_t i = 0; i < values.count; ++i) {
            const CurveTangent tangent = tangents_(derivative_at(values, i), params_(first + i, 0));
            transport_(first + i, row_vector(values.data, space_dim, i), tangent);
        }
    }

private:
    Tangents tangents_;
    ConstRecords params_;
    Records points_;
    Transport transport_;
};

struct PlaceAndTangent {
    Vector3 point;
    CurveTangent tangent;
};

// Stores the points and tangents of one run. Points of all runs are multiplied by the same power of two.
class PlaceSink final : public BlockSink {
public:
    PlaceSink(const MagnitudeRun &run, int power, PlaceAndTangent *out)
        : tangents_(run.spline, run.rules, run.params.count), params_(run.params), power_(power - run.size),
          out_(out) {}

    void operator()(int64_t first, ConstRecords values) noexcept override {
        for (int64_t i = 0; i < values.count; ++i) {
            const Vector3 p = row_vector(values.data, space_dim, i);
            out_[first + i] = {{std::ldexp(p.x, power_), std::ldexp(p.y, power_), std::ldexp(p.z, power_)},
                               tangents_(derivative_at(values, i), params_(first + i, 0))};
        }
    }

private:
    Tangents tangents_;
    ConstRecords params_;
    int power_;
    PlaceAndTangent *out_;
};

// The first tangent that exists in the sequence.
std::optional<Vector3> first_tangent(const Spline &spline, const AxisRules &rules, ConstRecords params) {
    Jet::prepare(spline);
    for (int64_t i = 0; i < params.count; ++i) {
        const CurveTangent tangent = curve_tangent(spline, rules, params(i, 0));
        if (tangent.kind > 0) {
            return tangent.direction;
        }
    }
    return std::nullopt;
}

// The first normal as the caller gave it, if it did. It counts as parallel to the tangent if its component
// across the tangent does not exceed the rounding of both.
std::optional<Vector3> checked_normal(const double *normal, const std::optional<Vector3> &tangent) {
    if (normal == nullptr) {
        return std::nullopt;
    }
    const Vector3 given{normal[0], normal[1], normal[2]};
    if (is_zero(given)) {
        fail(Status::direction, "first_normal is zero");
    }
    if (tangent && !(length(cross(unit(given), *tangent)) > 8 * eps)) {
        fail(Status::direction, "first_normal = (%s, %s, %s) is parallel to the first tangent",
             Number(given.x).text, Number(given.y).text, Number(given.z).text);
    }
    return given;
}

void frames_of_usual_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                          const double *first_normal, const MinimalFrames &out) {
    std::optional<Vector3> normal;
    if (first_normal != nullptr) {
        normal = checked_normal(first_normal, first_tangent(spline, rules, params));
    }
    MinimalSink sink(spline, rules, params, normal, out);
    evaluate_points(spline, rules, 1, params, sink);
}

// Each tangent is computed at the magnitude of its own run. The points between which frames are transported
// share one magnitude.
void frames_of_any_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const double *first_normal, const MinimalFrames &out) {
    const double size = size_of_runs(spline);
    const int power = size > 0 ? -std::ilogb(size) : 0;
    std::vector<PlaceAndTangent> found_places(static_cast<size_t>(params.count));
    const std::vector<int64_t> order =
        for_each_magnitude(spline, rules, params, [&](const MagnitudeRun &run) {
            PlaceSink sink(run, power, found_places.data() + run.first);
            evaluate_points(run.spline, run.rules, 1, run.params, sink);
        });
    std::vector<PlaceAndTangent> places(found_places.size());
    for (size_t n = 0; n < order.size(); ++n) {
        places[static_cast<size_t>(order[n])] = found_places[n];
    }
    const auto found = std::find_if(places.begin(), places.end(),
                                    [](const PlaceAndTangent &place) { return place.tangent.kind > 0; });
    const std::optional<Vector3> normal = checked_normal(
        first_normal, found != places.end() ? std::optional(found->tangent.direction) : std::nullopt);
    if (out.points.data != nullptr) {
        evaluate_points(spline, rules, 0, params, out.points);
    }
    Transport transport(point_noise(spline.axis(0).degree(), std::ldexp(size, power)), normal, out);
    for (int64_t i = 0; i < params.count; ++i) {
        const auto &[point, tangent] = places[static_cast<size_t>(i)];
        transport(i, point, tangent);
    }
}

} // namespace

void minimal_frames(const Spline &spline, const AxisRules &rules, ConstRecords params,
                    const double *first_normal, const MinimalFrames &out) {
    usual_magnitude(spline) ? frames_of_usual_size(spline, rules, params, first_normal, out)
                            : frames_of_any_size(spline, rules, params, first_normal, out);
}

} // namespace nrb::eval
