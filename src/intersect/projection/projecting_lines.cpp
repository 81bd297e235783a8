// SPDX-License-Identifier: MIT
#include "intersect/projection/projecting_lines.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "bounds/box.h"
#include "build/surfaces/ruled_extruded.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

using SpaceBox = std::array<Interval, 3>;

// The bounding box of the points, not of the control points: weights need not be positive.
SpaceBox box_of(const Spline &spline) {
    Part all{};
    for (int k = 0; k < spline.axes(); ++k) {
        all[static_cast<size_t>(k)] = spline.axis(k).domain();
    }
    const bounds::Box box = bounds::bounding_box(spline, all, bounds::extent(spline));
    require_representable(box.lower, "the box of the points");
    require_representable(box.upper, "the box of the points");
    SpaceBox result;
    for (size_t c = 0; c < 3; ++c) {
        result[c] = {box.lower[c], box.upper[c]};
    }
    return result;
}

double largest(const SpaceBox &box) noexcept {
    double most = 0;
    for (const Interval &side : box) {
        most = std::max({most, std::abs(side.lower), std::abs(side.upper)});
    }
    return most;
}

double size_of(const SpaceBox &box) noexcept {
    return std::hypot(box[0].upper - box[0].lower, box[1].upper - box[1].lower, box[2].upper - box[2].lower);
}

// The range of h for which lines from the box `from` reach the box `to`. The margin keeps the end of the
// ruled surface away from places where the other surface touches its box.
Interval heights(const SpaceBox &from, const SpaceBox &to, const Vector3 &direction) noexcept {
    const std::array<double, 3> along{direction.x, direction.y, direction.z};
    Interval range{0, 0};
    for (size_t c = 0; c < 3; ++c) {
        const double a = along[c] * (to[c].lower - from[c].upper),
                     b = along[c] * (to[c].upper - from[c].lower);
        range = {range.lower + std::min(a, b), range.upper + std::max(a, b)};
    }
    const double margin = (size_of(from) + size_of(to)) / 8 + 64 * eps * (largest(from) + largest(to)),
                 room = margin > 0 ? margin : 1;
    return {range.lower - room, range.upper + room};
}

SplinePtr moved(const SplinePtr &curve, const Vector3 &direction, double height) {
    std::vector<double> points(curve->points().begin(), curve->points().end());
    const int width = curve->stored_width();
    for (auto record = points.begin(); record != points.end(); record += width) {
        const double way = width > 3 ? record[3] * height : height;
        record[0] = std::fma(way, direction.x, record[0]);
        record[1] = std::fma(way, direction.y, record[1]);
        record[2] = std::fma(way, direction.z, record[2]);
    }
    require_representable(points, "control points moved along the direction");
    return make_result(curve->knot_vectors(), 3, curve->form(), std::move(points),
                       {curve->weights().begin(), curve->weights().end()});
}

// How far the points of the ruled surface may be off, whose control points are each rounded in a product and
// a sum. box: of the points of the curve.
double rounding_of(const Spline &curve, const SpaceBox &box, const Interval &range) {
    const double far = std::max(std::abs(range.lower), std::abs(range.upper));
    if (curve.form() != Form::homogeneous) {
        return 4 * eps * (largest_magnitude(curve.effective().points()) + far);
    }
    const Spline::WeightRange weights = curve.all_weights();
    return weights.smallest > 0 ? 8 * eps * weights.largest / weights.smallest * (largest(box) + far)
                                : infinity;
}

SplinePtr lines_along(const SplinePtr &curve, const Vector3 &direction, const Interval &range) {
    const SplinePtr ruled =
        build::ruled_homogeneous(moved(curve, direction, range.lower), moved(curve, direction, range.upper));
    return refine::reparametrize(ruled, 1, range);
}

} // namespace

ProjectingLines projecting_lines(const SplinePtr &curve, const Spline &surface, const Vector3 &direction) {
    const Vector3 along = unit(scaled_to_one(direction));
    const SpaceBox box = box_of(*curve);
    const Interval range = heights(box, box_of(surface), along);
    return {along, lines_along(curve, along, range), rounding_of(*curve, box, range)};
}

SplinePtr distance_lines(const SplinePtr &curve, const Spline &surface) {
    SpaceBox all = box_of(*curve);
    const SpaceBox other = box_of(surface);
    for (size_t c = 0; c < 3; ++c) {
        all[c] = {std::min(all[c].lower, other[c].lower), std::max(all[c].upper, other[c].upper)};
    }
    const double size = 1.125 * size_of(all), range = size > 0 ? size : 1;
    return lines_along(curve, {0, 0, 1}, {-range, range});
}

} // namespace nrb::intersect
