// SPDX-License-Identifier: MIT
#include "face/deviation.h"

#include "base/error.h"
#include "bounds/deviation.h"
#include "closest/closest.h"
#include "closest/pair/hausdorff.h"
#include "eval/evaluate.h"
#include "refine/forms/parametrization.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// Pieces of both curves that the search for the largest distance may look at.
constexpr int64_t most_pieces = 2000000;

MadeCurve over(const Face &face, const Coedge &coedge) {
    return edge_over(face.surface(), face.covering(), coedge.curve, face.tolerance());
}

// The two as curves of equal parameters, if their domains can be made the same.
std::optional<double> at_equal_parameters(const SplinePtr &image, const SplinePtr &edge, bool against) {
    try {
        const SplinePtr along = against ? refine::reverse(*edge, 0, false) : edge;
        const SplinePtr same = refine::reparametrize(along, 0, image->axis(0).domain());
        return bounds::deviation(*image, *same).upper;
    } catch (const Error &) { // knots would merge
        return std::nullopt;
    }
}

// The largest distance of some places of a curve, its ends among them, from another one.
double farthest_place(const Spline &from, const Spline &to, double tolerance) {
    const Interval domain = from.axis(0).domain();
    double largest = 0;
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
        const double t = parameter_in(domain, share);
        std::vector<double> point(static_cast<size_t>(from.dim()));
        eval::evaluate_points(from, {}, 0, {&t, 1, 1, 1, 1}, {point.data(), 1, from.dim(), from.dim(), 1});
        const closest::Foot foot = closest::locator_of(to).nearest(
            {point.data(), nullptr, tolerance / 16, closest::usual_budget(to), false, true});
        largest = std::max(largest, foot.distance);
    }
    return largest;
}

Deviation to_nearest(const MadeCurve &image, const Spline &edge, double tolerance) {
    const auto there = closest::one_sided_distance(*image.curve, edge, tolerance / 16, most_pieces),
               back = closest::one_sided_distance(edge, *image.curve, tolerance / 16, most_pieces);
    const bool proven = image.proven && there.certified && back.certified;
    return {std::max(there.at_most, back.at_most) + image.distance, proven};
}

} // namespace

SplinePtr edge_of(const Face &face, const Coedge &coedge) {
    if (coedge.edge != nullptr) {
        return coedge.edge;
    }
    const SplinePtr made = over(face, coedge).curve;
    return coedge.against ? refine::reverse(*made, 0, false) : made;
}

Deviation deviation_of(const Face &face, const Coedge &coedge) {
    if (coedge.deviation) {
        return *coedge.deviation;
    }
    const MadeCurve image = over(face, coedge);
    if (coedge.edge == nullptr) {
        return {image.distance, image.proven};
    }
    const std::optional<double> equal = at_equal_parameters(image.curve, coedge.edge, coedge.against);
    if (equal && *equal + image.distance <= face.tolerance()) {
        return {*equal + image.distance, image.proven};
    }
    return to_nearest(image, *coedge.edge, face.tolerance());
}

double distance_beyond(const SplinePtr &a, const SplinePtr &b, double tolerance) {
    for (const bool against : {false, true}) {
        if (at_equal_parameters(a, b, against).value_or(HUGE_VAL) <= tolerance) {
            return 0;
        }
    }
    const double distance = std::max(farthest_place(*a, *b, tolerance), farthest_place(*b, *a, tolerance));
    return distance > tolerance ? distance : 0;
}

} // namespace nrb::face
