// SPDX-License-Identifier: MIT
#include "analysis/contacts.h"

#include "analysis/flatness.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "bounds/deviation.h"
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

// A bound on the distance between both ends of a curve. Clamped ends are control points; other ends have the
// error of evaluation, where 2 c(p) <= 64 covers both ends.
double gap_of_ends(const Spline &curve) {
    std::vector<double> ends[2];
    for (const bool upper : {false, true}) {
        ends[upper ? 1 : 0] = eval::end_point(curve, upper);
    }
    if (ends[0] == ends[1]) {
        return 0;
    }
    const KnotVector &axis = curve.axis(0);
    const bool exact = axis.clamped_start() && axis.clamped_end() && curve.form() != Form::homogeneous;
    const double hull =
        exact ? 0 : largest_magnitude(refine::cartesian_points(curve.effective())) * std::sqrt(curve.dim());
    return distance(ends[0].data(), ends[1].data(), curve.dim()) * (1 + (curve.dim() + 4) * eps) +
           64 * eps * hull;
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

} // namespace

AxisContact axis_contact(const Spline &spline, int axis, double tolerance) {
    const KnotVector &own = spline.axis(axis);
    double gap = 0;
    if (!own.periodic()) {
        gap = spline.axes() == 1
                  ? gap_of_ends(spline)
                  : gap_of(*refine::iso(spline, axis, end_of(own, false), side(false)),
                           *refine::iso(spline, axis, end_of(own, true), side(true)), tolerance);
    }
    return {gap <= tolerance, gap};
}

BoundarySize boundary_size(const Spline &spline, int axis, bool upper, double tolerance) {
    if (spline.axes() == 1) {
        return {true, 0};
    }
    const double size = size_of(*refine::iso(spline, axis, end_of(spline.axis(axis), upper), side(upper)));
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
