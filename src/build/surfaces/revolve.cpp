// SPDX-License-Identifier: MIT
#include "build/surfaces/revolve.h"

#include "base/checked.h"
#include "base/representable.h"
#include "build/conics/arc.h"
#include "build/surfaces/points_in_rotation.h"
#include "build/surfaces/ruled_extruded.h"

#include <algorithm>
#include <span>
#include <vector>

namespace nrb::build {

namespace {

AxisLine make_line(const double *point, const double *axis) {
    AxisLine line{};
    if (point != nullptr) {
        check_point(point, 3, "point");
        std::copy_n(point, 3, line.origin.begin());
    }
    const Placement place = make_placement(3, nullptr, axis, nullptr, "point");
    line.along = {DoubleDouble(place.z.x, place.z_rest.x), DoubleDouble(place.z.y, place.z_rest.y),
                  DoubleDouble(place.z.z, place.z_rest.z)};
    return line;
}

void check_turned(const Spline &spline) {
    check_room_for_axis(spline, "g");
    if (spline.dim() < 3) {
        fail(Status::dimension,
             "dimension %d of g, expected 3; nurbs_transform() with a matrix of 3 x %d lifts g into space",
             spline.dim(), spline.dim());
    }
    if (spline.dim() != 3) {
        fail(Status::dimension, "dimension %d of g, expected 3", spline.dim());
    }
}

// Homogeneous records are multiplied by the weights of the arc.
void multiply(double factor, std::span<double> values) noexcept {
    if (factor != 1) {
        std::ranges::transform(values, values.begin(), [factor](double x) { return factor * x; });
    }
}

std::vector<double> turned_points(const Spline &spline, const AxisLine &line, const Arc &arc, bool closed) {
    const std::span<const double> start = spline.points();
    const size_t size = start.size(), layers = arc.points.size();
    std::vector<double> points;
    points.reserve(static_cast<size_t>(checked_product(std::ssize(start), std::ssize(arc.points), "points") +
                                       int64_t{Spline::padding}));
    points.assign(start.begin(), start.end());
    points.resize(size * layers);
    const PointsInRotation rotating(spline, line);
    for (size_t j = 1; j < layers; ++j) {
        const std::span<double> layer = std::span(points).subspan(j * size, size);
        if (closed && j + 1 == layers) {
            std::ranges::copy(start, layer.begin());
        } else {
            rotating.values(arc.points[j].x, arc.points[j].y, layer.data());
            multiply(spline.form() == Form::homogeneous ? arc.points[j].weight : 1, layer);
        }
    }
    require_representable(points, "control points");
    return points;
}

std::vector<double> turned_weights(const Spline &spline, const Arc &arc) {
    if (spline.form() == Form::homogeneous) {
        return {};
    }
    const auto count = static_cast<size_t>(spline.point_count());
    const std::vector<double> ones(spline.rational() ? 0 : count, 1.0);
    const std::span<const double> start = spline.rational() ? spline.weights() : ones;
    std::vector<double> weights(count * arc.points.size());
    auto layer = weights.begin();
    for (const ArcPoint &at : arc.points) {
        layer = std::ranges::transform(start, layer, [&](double w) { return at.weight * w; }).out;
    }
    return weights;
}

} // namespace

SplinePtr revolve(const Spline &spline, const double *point, const double *axis, double sweep, int32_t form) {
    check_turned(spline);
    const AxisLine line = make_line(point, axis);
    const Turn turn = make_turn(0, sweep);
    const Arc arc = unit_arc(turn, form);
    Spline::Axes axes = spline.knot_vectors();
    axes.insert(axes.begin(), arc.axis);
    return make_result(std::move(axes), 3, std::max(spline.form(), Form::rational),
                       turned_points(spline, line, arc, turn.sweep.full_turn()), turned_weights(spline, arc));
}

} // namespace nrb::build
