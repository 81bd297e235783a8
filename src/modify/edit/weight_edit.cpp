// SPDX-License-Identifier: MIT
#include "modify/edit/weight_edit.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "modify/edit/influence.h"
#include "modify/edit/net_editor.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>

namespace nrb::modify {

namespace {

double checked_weight(double weight, int64_t point) {
    if (std::isinf(weight)) {
        fail(Status::not_representable, "the weight of control point %lld overflows",
             static_cast<long long>(point));
    }
    if (!(weight > 0)) {
        fail(Status::weight_sign, "the weight of control point %lld would be %s, expected > 0",
             static_cast<long long>(point), Number(weight).text);
    }
    return weight;
}

// -|S B|; infinite if the others make no point.
double lowest_distance(const Contribution &sums) noexcept {
    return -sums.reach() * std::abs(sums.weight / sums.rest);
}

double factor_for(const Contribution &sums, double distance) {
    const double reach = sums.reach();
    if (!(distance < reach)) { // also if it is not finite
        fail(Status::length, "distance = %s, expected less than %s, the distance to the control points",
             Number(distance).text, Number(reach).text);
    }
    const double factor = (reach + sums.rest / sums.weight * distance) / (reach - distance);
    if (!(factor > 0)) {
        fail(Status::weight_sign, "distance = %s, expected more than %s, where the weights would be 0",
             Number(distance).text, Number(reach == 0 || sums.rest == 0 ? 0 : lowest_distance(sums)).text);
    }
    return factor;
}

} // namespace

WeightEdit pull_weights(const Spline &spline, std::span<const int64_t> originals, const double *param,
                        double distance) {
    const double factor = factor_for(contribution_of(spline, originals, param), distance);
    NetEditor editor(spline);
    for (const int64_t point : originals) {
        if (const double old = spline.weight(point); old != 0) { // of either sign; the sign stays
            editor.set_weight(point, std::copysign(checked_weight(std::abs(old) * factor, point), old));
        }
    }
    return {factor, editor.finish()};
}

WeightEdit pull_weight(const Spline &spline, int64_t original, const double *param, double distance) {
    WeightEdit edit = pull_weights(spline, {&original, 1}, param, distance);
    edit.value = edit.spline->weight(original);
    return edit;
}

SplinePtr set_weights(const Spline &spline, std::span<const int64_t> originals, const double *weights) {
    for (int64_t i = 0; spline.form() == Form::homogeneous && i < spline.point_count(); ++i) {
        const double *record = spline.points().data() + i * spline.stored_width();
        if (spline.weight(i) == 0 && largest_magnitude({record, static_cast<size_t>(spline.dim())}) > 0) {
            fail(Status::point_not_finite, "g: control point %lld is at infinity", static_cast<long long>(i));
        }
    }
    NetEditor editor(spline);
    for (size_t i = 0; i < originals.size(); ++i) {
        editor.set_weight(originals[i], weights[i]);
    }
    return editor.finish();
}

namespace {

// Q + offset / weight; the centre if the offset is 0.
std::vector<double> point_at(const Contribution &sums, double weight) {
    std::vector<double> point = sums.centre;
    for (size_t c = 0; c < point.size(); ++c) {
        point[c] += sums.offset[c] == 0 && weight != 0 ? 0 : sums.offset[c] / weight;
    }
    return point;
}

void copy_if(const std::vector<double> &point, double *out) noexcept {
    if (out != nullptr) {
        std::copy(point.begin(), point.end(), out);
    }
}

} // namespace

void weight_points(const Spline &spline, int64_t original, const double *param, double *at_zero,
                   double *at_one, double *at_weight) {
    const Contribution sums = contribution_about(spline, original, param);
    std::vector<double> zero(sums.centre.size(), nan_value);
    if (sums.rest != 0) {
        zero = point_at(sums, sums.rest);
        require_representable(zero, "the point at weight 0");
    }
    const std::vector<double> one = point_at(sums, sums.function * sums.unit + sums.rest);
    const std::vector<double> present = point_at(sums, sums.weight + sums.rest);
    require_representable(one, "the point at weight 1");
    require_representable(present, "the point at the present weight");
    copy_if(zero, at_zero);
    copy_if(one, at_one);
    copy_if(present, at_weight);
}

namespace {

// Differences of points that are scaled near 1 by a power of two, so that products do not overflow.
class Differences {
public:
    Differences(int dim, std::initializer_list<const double *> points) : dim_(dim) {
        double largest = 0;
        for (const double *point : points) {
            largest = std::max(largest, largest_magnitude({point, static_cast<size_t>(dim)}));
        }
        exponent_ = largest > 0 ? -std::ilogb(largest) : 0;
    }
    [[nodiscard]] std::vector<double> operator()(const double *to, const double *from) const {
        std::vector<double> difference;
        difference.reserve(static_cast<size_t>(dim_));
        for (int c = 0; c < dim_; ++c) {
            difference.push_back(std::ldexp(to[c], exponent_) - std::ldexp(from[c], exponent_));
        }
        return difference;
    }

private:
    int dim_;
    int exponent_;
};

} // namespace

double weight_cross_ratio(int dim, const double *control_point, const double *at_zero, const double *at_one,
                          const double *at_weight) {
    const Differences minus(dim, {control_point, at_zero, at_one, at_weight});
    std::vector<double> line = minus(at_zero, control_point);
    const double length = norm(line.data(), dim);
    if (length == 0) {
        fail(Status::collinear, "control_point and at_zero are the same point, expected two of a line");
    }
    std::transform(line.begin(), line.end(), line.begin(), [length](double x) { return x / length; });
    const double to_one = dot(minus(at_one, control_point), line),
                 from_one = dot(minus(at_zero, at_one), line);
    if (to_one == 0 || from_one == 0) {
        fail(Status::collinear, "at_one is %s, expected a point between the two",
             to_one == 0 ? "control_point" : "at_zero");
    }
    const double to_weight = dot(minus(at_weight, control_point), line);
    const double from_weight = dot(minus(at_zero, at_weight), line);
    return to_weight == 0 ? infinity : to_one / from_one * (from_weight / to_weight);
}

namespace {

// The distance of the target from the line through the control point along the unit vector `line`.
double distance_from_line(const std::vector<double> &to_target, const std::vector<double> &line) noexcept {
    const double along = dot(to_target, line);
    return norm_of(static_cast<int>(line.size()), [&](int c) {
        const auto i = static_cast<size_t>(c);
        return to_target[i] - along * line[i];
    });
}

// The weight for the target T: (1 - alpha rest) / (alpha N) with alpha = (T - P) . offset / |offset|^2.
double weight_at(const Contribution &sums, const double *target, double tolerance) {
    const auto dim = static_cast<int>(sums.centre.size());
    const double size = norm(sums.offset.data(), dim);
    std::vector<double> line = sums.offset, to_target(line.size()), ahead(line.size());
    for (size_t c = 0; c < line.size(); ++c) {
        line[c] /= size;
        to_target[c] = target[c] - sums.centre[c];
        ahead[c] = sums.offset[c] - sums.rest * to_target[c]; // rest (B - T)
    }
    const double gap = distance_from_line(to_target, line);
    if (!(gap <= tolerance)) {
        fail(Status::gap,
             "target: distance %s from the line that the weight moves the point on, tolerance = %s",
             Number(gap).text, Number(tolerance).text);
    }
    return dot(ahead, line) / dot(to_target, line) / sums.function / sums.unit;
}

} // namespace

WeightEdit weight_through(const Spline &spline, int64_t original, const double *param, const double *target,
                          double tolerance) {
    const Contribution sums = contribution_about(spline, original, param);
    if (sums.function == 0 || largest_magnitude(sums.offset) == 0) {
        fail_influence(spline, original, param);
    }
    const double weight = checked_weight(weight_at(sums, target, tolerance), original);
    NetEditor editor(spline);
    editor.set_weight(original, weight);
    return {weight, editor.finish()};
}

} // namespace nrb::modify
