// SPDX-License-Identifier: MIT
#include "build/conics/conic_curves.h"

#include "base/error.h"
#include "build/make_shape.h"

#include <cmath>
#include <utility>
#include <vector>

namespace nrb::build {

namespace {

void check_range(double start, double end) {
    if (!std::isfinite(start) || !std::isfinite(end)) {
        fail(Status::parameter_not_finite, "%s = %s is not finite", std::isfinite(start) ? "end" : "start",
             Number(std::isfinite(start) ? end : start).text);
    }
    if (!(start < end)) {
        fail(Status::empty_domain, "start = %s, end = %s, expected start < end", Number(start).text,
             Number(end).text);
    }
}

} // namespace

SplinePtr placed_arc(const Placement &place, double radius_x, double radius_y, const Arc &arc) {
    const auto dim = static_cast<size_t>(place.dim);
    std::vector<double> points(arc.points.size() * dim), weights;
    for (size_t i = 0; i < arc.points.size(); ++i) {
        const ArcPoint &p = arc.points[i];
        place.point(radius_x * p.x, radius_y * p.y, 0, points.data() + i * dim);
        weights.push_back(p.weight);
    }
    return make_shape({arc.axis}, place.dim, std::move(points), std::move(weights));
}

SplinePtr ellipse(const Placement &place, double radius_x, double radius_y, const Turn &turn, int32_t form) {
    return placed_arc(place, radius_x, radius_y, unit_arc(turn, form));
}

SplinePtr parabola(const Placement &place, double focal_length, double start, double end) {
    check_positive_length(focal_length, "focal_length");
    check_range(start, end);
    const auto dim = static_cast<size_t>(place.dim);
    const double slope = start / focal_length / 4; // x = t^2 / (4 f) has the polar form s t / (4 f)
    const double end_slope = end / focal_length / 4;
    std::vector<double> points(3 * dim);
    place.point(slope * start, start, 0, points.data());
    place.point(slope * end, start + (end - start) / 2, 0, points.data() + dim);
    place.point(end_slope * end, end, 0, points.data() + 2 * dim);
    return make_shape({make_knot_vector(2, {start, start, start, end, end, end})}, place.dim,
                      std::move(points), {});
}

SplinePtr hyperbola(const Placement &place, double radius_x, double radius_y, double start, double end) {
    check_positive_length(radius_x, "radius_x");
    check_positive_length(radius_y, "radius_y");
    check_range(start, end);
    return placed_arc(place, radius_x, radius_y, unit_hyperbola(start, end));
}

} // namespace nrb::build
