// SPDX-License-Identifier: MIT
#include "build/surfaces/profile.h"

#include "base/representable.h"
#include "build/surfaces/points_in_rotation.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::build {

namespace {

// The radius of the hyperbola at a height, without cancellation near the vertex.
double radius_at(double height, double size, bool two_sheets) noexcept {
    const double far = std::fabs(height);
    return two_sheets ? std::sqrt((far - size) / size) * std::sqrt(far / size + 1)
                      : std::hypot(far / size, 1.0);
}

double parameter_at(double height, bool two_sheets) noexcept {
    return two_sheets ? std::copysign(std::acosh(std::fabs(height)), height) : std::asinh(height);
}

double height_at(double u, bool two_sheets) noexcept {
    return two_sheets ? std::copysign(std::cosh(u), u) : std::sinh(u);
}

// The heights at the ends of all pieces.
std::vector<double> piece_ends(double size, double bottom, double top, bool two_sheets) {
    const double from = parameter_at(bottom / size, two_sheets), to = parameter_at(top / size, two_sheets);
    if (!std::isfinite(from) || !std::isfinite(to)) {
        fail(Status::not_representable, "heights %s and %s overflow in units of radius_z = %s",
             Number(bottom).text, Number(top).text, Number(size).text);
    }
    const auto pieces = std::max<int64_t>(1, static_cast<int64_t>(std::ceil((to - from) / 2)));
    std::vector<double> ends = {bottom};
    for (int64_t i = 1; i < pieces; ++i) {
        const double u = from + (to - from) * static_cast<double>(i) / static_cast<double>(pieces);
        ends.push_back(std::clamp(size * height_at(u, two_sheets), bottom, top));
    }
    ends.push_back(top);
    return ends;
}

} // namespace

Profile bezier_profile(std::vector<ProfilePoint> points) {
    const int degree = static_cast<int>(points.size()) - 1;
    return {refine::bezier_knots(degree, std::array<double, 2>{0, 1}), std::move(points)};
}

Profile arc_profile(const Turn &turn, int32_t form, double offset, double radius) {
    const Arc arc = unit_arc(turn, form);
    Profile profile{arc.axis, {}};
    for (const ArcPoint &at : arc.points) {
        profile.points.push_back({DoubleDouble(offset) + DoubleDouble::product(radius, at.x),
                                  DoubleDouble::product(radius, at.y), at.weight});
    }
    return profile;
}

Profile hyperbola_profile(double size, double bottom, double top, bool two_sheets) {
    const std::vector<double> ends = piece_ends(size, bottom, top, two_sheets);
    Profile profile{piecewise_knots(std::ssize(ends) - 1), {{radius_at(bottom, size, two_sheets), bottom}}};
    for (size_t i = 1; i < ends.size(); ++i) {
        const double low = ends[i - 1], high = ends[i];
        const double r = radius_at(low, size, two_sheets), s = radius_at(high, size, two_sheets);
        const double t = (high / 2 - low / 2) / size / (r / 2 + s / 2);
        const double factor = (1 - t) * (1 + t); // 2 / (1 + cosh d)
        profile.points.push_back(
            {factor * (r / 2 + s / 2), factor * (low / 2 + high / 2), 1 / std::sqrt(factor)});
        profile.points.push_back({s, high});
    }
    return profile;
}

SplinePtr turned(const Placement &place, const Arc &arc, const Profile &profile, double scale_x,
                 double scale_y) {
    const size_t width = profile.points.size() * 3;
    PointsInRotation rotating(static_cast<int64_t>(width));
    for (size_t i = 0; i < profile.points.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        const DoubleDouble along = scale_x * point.radius, across = scale_y * point.radius;
        for (int c = 0; c < 3; ++c) {
            const auto frame = place.component(c);
            rotating.set(static_cast<int64_t>(3 * i) + c, frame.origin + point.height * frame.z,
                         along * frame.x, across * frame.y);
        }
    }
    std::vector<double> points, weights;
    points.reserve(arc.points.size() * width + Spline::padding);
    points.resize(arc.points.size() * width);
    weights.reserve(arc.points.size() * profile.points.size());
    double *out = points.data();
    for (const ArcPoint &at : arc.points) {
        rotating.values(at.x, at.y, out);
        out += width;
        for (const ProfilePoint &point : profile.points) {
            weights.push_back(at.weight * point.weight);
        }
    }
    require_representable(points, "control points");
    return make_result({arc.axis, profile.axis}, 3, Form::rational, std::move(points), std::move(weights));
}

} // namespace nrb::build
