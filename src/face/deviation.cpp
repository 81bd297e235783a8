// SPDX-License-Identifier: MIT
#include "face/deviation.h"

#include "base/error.h"
#include "bounds/deviation.h"
#include "closest/pair/hausdorff.h"
#include "refine/forms/parametrization.h"

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
    constexpr int64_t most_pieces_each = 20000;
    for (const bool against : {false, true}) {
        if (at_equal_parameters(a, b, against).value_or(HUGE_VAL) <= tolerance) {
            return 0;
        }
    }
    const double there = closest::one_sided_distance(*a, *b, tolerance / 16, most_pieces_each).at_least,
                 back = closest::one_sided_distance(*b, *a, tolerance / 16, most_pieces_each).at_least;
    const double distance = std::max(there, back);
    return distance > tolerance ? distance : 0;
}

} // namespace nrb::face
