// SPDX-License-Identifier: MIT
#include "measure/moments.h"

#include "base/error.h"
#include "base/numbers.h"
#include "eval/curve_point.h"
#include "measure/moment_integrand.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

Moments moments_of(const std::vector<Elements> &splines, const Integrand &integrand, const Factors &factors,
                   const pieces::Frame &frame, MomentOrder order, double relative_tolerance) {
    return moments_from(integrate(splines, integrand, relative_tolerance), integrand.independent(), factors,
                        frame, order, relative_tolerance);
}

struct CurveEnd {
    int64_t curve;
    std::vector<double> place;
};

// Appends the starts and ends of the parts between jumps. A periodic curve has no end at its seam.
void add_ends(const Spline &curve, int64_t number, std::vector<CurveEnd> &starts,
              std::vector<CurveEnd> &ends) {
    const KnotVector &axis = curve.axis(0);
    const auto [lower, upper] = axis.domain();
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        const bool jump = group.multiplicity > axis.degree(),
                   outer = group.knot == lower || group.knot == upper;
        if (group.knot < lower || group.knot > upper || !(jump || (outer && !axis.periodic()))) {
            continue;
        }
        if (group.knot > lower) {
            ends.push_back({number, eval::curve_point(curve, group.knot, true)});
        }
        if (group.knot < upper) {
            starts.push_back({number, eval::curve_point(curve, group.knot, false)});
        }
    }
}

} // namespace

Moments moments(const Spline &spline, const Part &part, MomentOrder order, double relative_tolerance) {
    const pieces::Frame frame = integral_frame(spline);
    std::vector<Elements> elements;
    elements.emplace_back(spline, frame, part);
    return moments_of(elements, MomentIntegrand(spline.axes(), spline.dim(), order), {1, 1, 1, spline.axes()},
                      frame, order, relative_tolerance);
}

Moments enclosed_moments(const std::vector<SplinePtr> &boundary, MomentOrder order,
                         double relative_tolerance) {
    std::vector<const Spline *> parts;
    parts.reserve(boundary.size());
    for (const SplinePtr &part : boundary) {
        parts.push_back(part.get());
    }
    const pieces::Frame frame = integral_frame(parts);
    std::vector<Elements> elements;
    elements.reserve(parts.size());
    for (const Spline *one : parts) {
        elements.emplace_back(*one, frame, whole_domain(*one));
    }
    const int n = parts.front()->dim();
    return moments_of(elements, BoundaryIntegrand(n, order), enclosed_factors(n), frame, order,
                      relative_tolerance);
}

void check_closed(const std::vector<SplinePtr> &curves, double tolerance) {
    std::vector<CurveEnd> starts, ends;
    for (int64_t i = 0; i < std::ssize(curves); ++i) {
        add_ends(*curves[static_cast<size_t>(i)], i, starts, ends);
    }
    for (const CurveEnd &end : ends) {
        double gap = infinity;
        for (const CurveEnd &start : starts) {
            gap = std::min(gap, distance(start.place.data(), end.place.data(), 2));
        }
        if (!(gap <= tolerance)) {
            fail(Status::gap, "curves[%lld] ends %s from the nearest start, expected at most tolerance = %s",
                 static_cast<long long>(end.curve), Number(gap).text, Number(tolerance).text);
        }
    }
}

} // namespace nrb::measure
