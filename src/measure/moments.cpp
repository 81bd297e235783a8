// SPDX-License-Identifier: MIT
#include "measure/moments.h"

#include "measure/moment_integrand.h"

namespace nrb::measure {

namespace {

Moments moments_of(const std::vector<Elements> &splines, const Integrand &integrand, const Factors &factors,
                   const pieces::Frame &frame, MomentOrder order, double relative_tolerance) {
    return moments_from(integrate(splines, integrand, relative_tolerance), integrand.independent(), factors,
                        frame, order, relative_tolerance);
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

} // namespace nrb::measure
