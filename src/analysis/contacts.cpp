// SPDX-License-Identifier: MIT
#include "analysis/contacts.h"

#include "analysis/flatness.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "bounds/deviation.h"
#include "eval/active.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/iso.h"

#include <algorithm>
#include <cmath>

namespace nrb::analysis {

namespace {

eval::AxisRule side(bool upper) noexcept {
    eval::AxisRule rule;
    rule.left = upper;
    return rule;
}

double end_of(const KnotVector &axis, bool upper) noexcept {
    return upper ? axis.domain().upper : axis.domain().lower;
}

bool same_values(const Spline &a, const Spline &b) noexcept {
    return std::equal(a.points().begin(), a.points().end(), b.points().begin(), b.points().end()) &&
           std::equal(a.weights().begin(), a.weights().end(), b.weights().begin(), b.weights().end());
}

double gap_of(const Spline &a, const Spline &b, double tolerance) {
    if (same_values(a, b)) {
        return 0;
    }
    const bounds::DeviationPieces pieces(a, b);
    const std::vector<double> uppers = pieces.uppers();
    const pieces::Enclosure found = pieces.enclosure(uppers);
    const bool open = found.lower <= tolerance && tolerance < found.upper;
    return open ? pieces.enclosure(uppers, {.ratio = 1e-9, .steps = 4000}).upper : found.upper;
}

bool clamped(const KnotVector &axis, bool upper) noexcept {
    return upper ? axis.clamped_end() : axis.clamped_start();
}

// A bound on the error of the rounded boundary of a spline: 0 at a clamped end, where it is stored; elsewhere
// that of the Cox-de Boor recurrence, (7 p + 2) eps in the homogeneous coordinates, counted for the weight,
// too. `hull` is called for the size that it is relative to in each coordinate.
template <class Hull>
double rounding_of(const Spline &spline, int axis, bool upper, Hull &&hull) {
    const KnotVector &own = spline.axis(axis);
    return clamped(own, upper) ? 0 : 2 * (7 * own.degree() + 2) * eps * std::sqrt(spline.dim()) * hull();
}

double rounding_of_end(const Spline &curve, bool upper) {
    return rounding_of(curve, 0, upper, [&] {
        const double t = end_of(curve.axis(0), upper);
        double size = 0;
        eval::hull_sizes(curve, {side(upper)}, {&t, 1, 1, 1, 1}, {&size, 1, 1, 1, 1});
        return size;
    });
}

// An upper bound on (max|w_i P_i| + |x| max|w_i|) / |w(x)| over the points x of a boundary, from its own
// control points if their weights are positive.
double signed_hull(const Spline &spline, const Spline &boundary) {
    double largest = 0, heaviest = 0, lightest = infinity;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const double *record = spline.points().data() + i * spline.stored_width();
        largest = std::max(largest, largest_magnitude({record, static_cast<size_t>(spline.dim())}));
        heaviest = std::max(heaviest, std::abs(spline.weight(i)));
    }
    for (int64_t i = 0; i < boundary.point_count(); ++i) {
        lightest = std::min(lightest, boundary.weight(i));
    }
    const double reach = largest_magnitude(refine::cartesian_points(boundary));
    return lightest > 0 ? (largest + reach * heaviest) / lightest : infinity;
}

// Where no weight is negative, points are means of control points.
double rounding_of_boundary(const Spline &spline, int axis, bool upper, const Spline &boundary) {
    return rounding_of(spline, axis, upper, [&] {
        return spline.form() == Form::homogeneous
                   ? signed_hull(spline.effective(), boundary.effective())
                   : largest_magnitude(refine::cartesian_points(spline.effective()));
    });
}

// Whether both ends are control points with the same stored values.
bool same_ends(const Spline &curve) noexcept {
    const KnotVector &axis = curve.axis(0);
    const double *first = curve.points().data();
    const int64_t width = curve.stored_width(), last = curve.point_count() - 1;
    return axis.clamped_start() && axis.clamped_end() &&
           std::equal(first, first + width, first + last * width);
}

// A bound on the distance between both ends of a curve. Those of homogeneous points are rounded once more.
double gap_of_ends(const Spline &curve) {
    if (same_ends(curve)) {
        return 0;
    }
    double rounding = 0, size = 0;
    std::vector<double> ends[2];
    for (const bool upper : {false, true}) {
        ends[upper ? 1 : 0] = eval::end_point(curve, upper);
        rounding += rounding_of_end(curve, upper);
        size += norm(ends[upper ? 1 : 0].data(), curve.dim());
    }
    return distance(ends[0].data(), ends[1].data(), curve.dim()) * (1 + (curve.dim() + 4) * eps) + rounding +
           (curve.form() == Form::homogeneous ? eps * size : 0);
}

double size_of(const Spline &boundary) {
    const std::vector<double> points = refine::cartesian_points(boundary.effective());
    const auto n = static_cast<size_t>(boundary.dim());
    bool point = true;
    for (size_t i = n; i < points.size() && point; ++i) {
        point = points[i] == points[i % n];
    }
    return point ? 0 : farthest_from(boundary, ball_centre(sample_points(boundary), boundary.dim()));
}

SplinePtr boundary_of(const Spline &spline, int axis, bool upper) {
    return refine::iso(spline, axis, end_of(spline.axis(axis), upper), side(upper));
}

double gap_of_boundaries(const Spline &spline, int axis, double tolerance) {
    const SplinePtr lower = boundary_of(spline, axis, false), upper = boundary_of(spline, axis, true);
    const double rounding =
        rounding_of_boundary(spline, axis, false, *lower) + rounding_of_boundary(spline, axis, true, *upper);
    return gap_of(*lower, *upper, tolerance - rounding) + rounding;
}

} // namespace

AxisContact axis_contact(const Spline &spline, int axis, double tolerance) {
    const KnotVector &own = spline.axis(axis);
    if (own.periodic()) {
        return {true, 0};
    }
    const double gap = spline.axes() == 1 ? gap_of_ends(spline) : gap_of_boundaries(spline, axis, tolerance);
    return {gap <= tolerance, gap};
}

BoundarySize boundary_size(const Spline &spline, int axis, bool upper, double tolerance) {
    if (spline.axes() == 1) {
        return {true, 0};
    }
    const SplinePtr boundary = boundary_of(spline, axis, upper);
    const double size = size_of(*boundary) + rounding_of_boundary(spline, axis, upper, *boundary);
    return {size <= tolerance, size};
}

Contacts boundary_contacts(const Spline &spline, double tolerance) {
    Contacts result;
    for (int k = 0; k < spline.axes(); ++k) {
        result.axes.push_back(axis_contact(spline, k, tolerance));
        for (const bool upper : {false, true}) {
            result.boundaries.push_back(boundary_size(spline, k, upper, tolerance));
        }
    }
    return result;
}

} // namespace nrb::analysis
