// SPDX-License-Identifier: MIT
#include "build/conics/conic_focus.h"

#include "base/error.h"
#include "build/conics/conic_arc.h"
#include "numeric/norm.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace nrb::build {

namespace {

// A vector of the frame as a vector of space.
std::vector<double> vector_in(const Placement &place, const Point2 &v) {
    Placement at_origin = place;
    at_origin.origin = {};
    std::vector<double> out(static_cast<size_t>(place.dim));
    at_origin.point(v.x, v.y, DoubleDouble(0), out.data());
    return out;
}

std::vector<double> point_in(const Placement &place, const Point2 &p) {
    std::vector<double> out(static_cast<size_t>(place.dim));
    place.point(p.x, p.y, DoubleDouble(0), out.data());
    return out;
}

// The point of the conic at the angle a about the focus.
struct Ray {
    Point2 point;
    DoubleDouble divisor; // 1 + e cos a
};

Ray ray_at(double parameter, double e, const Direction &d) {
    const DoubleDouble divisor = DoubleDouble(1) + DoubleDouble(e) * DoubleDouble(d.cos);
    return {{DoubleDouble(parameter) * DoubleDouble(d.cos) / divisor,
             DoubleDouble(parameter) * DoubleDouble(d.sin) / divisor},
            divisor};
}

// The arc of the conic r (1 + e cos a) = e d between two angles at most half a turn apart. `parameter` is e
// d, angles[1] is halfway, and half_cosine is the cosine of half the difference. The homogeneous points (e d
// cos a, e d sin a; 1 + e cos a) are a linear image of those of the circle, and so are the control points.
ConicArc focal_arc(const Placement &place, double parameter, double e, const std::array<Angle, 3> &angles,
                   double half_cosine) {
    const Ray a = ray_at(parameter, e, angles[0].direction()),
              b = ray_at(parameter, e, angles[2].direction());
    const Direction m = angles[1].direction();
    const DoubleDouble root = square_root(a.divisor * b.divisor);
    const DoubleDouble weight = (DoubleDouble(half_cosine) + DoubleDouble(e) * DoubleDouble(m.cos)) / root;
    const Point2 middle{DoubleDouble(parameter) * DoubleDouble(m.cos) / root - weight * a.point.x,
                        DoubleDouble(parameter) * DoubleDouble(m.sin) / root - weight * a.point.y};
    return make_conic_arc(point_in(place, a.point), point_in(place, b.point), b.point - a.point, middle,
                          weight, [&place](const Point2 &v) { return vector_in(place, v); });
}

// With e >= 1 the conic reaches infinity where cos a = -1 / e, and 1 + e cos a <= 0 from there to the angle
// pi. So a turn that meets such an angle contains pi, or 1 + e cos a <= 0 at one of its ends.
void check_finite(const Turn &turn, double e) {
    constexpr double full = 2 * std::numbers::pi;
    const double sweep = turn.sweep.radians(), sign = sweep < 0 ? -1 : 1;
    const double way =
        std::fmod(std::fmod(sign * (std::numbers::pi - turn.start.radians()), full) + full, full);
    const auto divisor = [&](int64_t at) {
        return 1 + e * turn.start.plus(turn.sweep, at, 1).direction().cos;
    };
    const double least = std::min(divisor(0), divisor(1));
    if ((e >= 1 && way <= std::fabs(sweep)) || !(least > 0)) {
        fail(Status::conic,
             "the angles from %s over %s reach infinity: 1 + eccentricity * cos(angle) has to stay positive",
             Number(turn.start.radians()).text, Number(sweep).text);
    }
}

} // namespace

FocalFrame focal_frame(int32_t dim, const double *focus, const double *axis, const double *foot) {
    make_placement(dim, focus, axis, nullptr, "focus");
    check_point(foot, dim, "foot");
    std::array<double, 3> x{};
    for (size_t c = 0; c < static_cast<size_t>(dim); ++c) {
        x[c] = foot[c] - focus[c];
    }
    check_direction(x.data(), dim, "foot - focus");
    const double way = distance(foot, focus, dim);
    if (dim == 2) {
        return {make_placement(dim, focus, nullptr, x.data(), "focus"), way};
    }
    const std::array<double, 3> up = {0, 0, 1};
    const Vector3 along = unit(scaled_to_one({x[0], x[1], x[2]}));
    const double *given = axis != nullptr ? axis : up.data();
    const Vector3 normal = unit(scaled_to_one({given[0], given[1], given[2]}));
    if (largest(cross(normal, along)) <= 4 * 0x1p-52) {
        fail(Status::direction, "axis = (%s, %s, %s) is parallel to foot - focus", Number(given[0]).text,
             Number(given[1]).text, Number(given[2]).text);
    }
    const Vector3 across = unit_across(normal, along);
    const std::array<double, 3> z = {across.x, across.y, across.z};
    return {make_placement(dim, focus, z.data(), x.data(), "focus"), way};
}

SplinePtr conic_focus(const FocalFrame &frame, double eccentricity, const Turn &turn, int32_t form) {
    check_arc_form(form, arc_thirds);
    if (!std::isfinite(eccentricity) || !(eccentricity > 0)) {
        fail(Status::factor, "eccentricity = %s, expected a finite number above 0",
             Number(eccentricity).text);
    }
    check_finite(turn, eccentricity);
    const int64_t arcs = std::fabs(turn.sweep.radians()) > 3 ? 2 : 1; // so that no arc exceeds half a turn
    const double half_cosine = turn.sweep.part(1, 2 * arcs).direction().cos;
    std::vector<ConicArc> pieces;
    for (int64_t i = 0; i < arcs; ++i) {
        const auto at = [&](int64_t half) { return turn.start.plus(turn.sweep, 2 * i + half, 2 * arcs); };
        pieces.push_back(focal_arc(frame.place, eccentricity * frame.distance, eccentricity,
                                   {at(0), at(1), at(2)}, half_cosine));
    }
    if (turn.sweep.full_turn()) {
        pieces.back().end = pieces.front().start;
    }
    return conic_curve(pieces, form);
}

} // namespace nrb::build
