// SPDX-License-Identifier: MIT
#include "face/deviation.h"

#include "base/error.h"
#include "bounds/deviation.h"
#include "closest/closest.h"
#include "closest/pair/hausdorff.h"
#include "eval/curve_point.h"
#include "face/made/along_feet.h"
#include "numeric/vector3.h"
#include "refine/forms/parametrization.h"
#include "spline/part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace nrb::face {

namespace {

// The most pieces of both curves that the search for the largest distance examines.
constexpr int64_t most_pieces = 2000000;
// The same where only a distance above the tolerance, or none, has to be proven.
constexpr int64_t most_compared = 20000;

MadeCurve over(const Face &face, const Coedge &coedge) {
    return edge_over(face.surface(), face.covering(), coedge.curve, face.tolerance());
}

// A bound on the distance at equal parameters; none if the domains cannot be made the same.
std::optional<double> at_equal_parameters(const SplinePtr &image, const SplinePtr &edge, bool against,
                                          double tolerance) {
    try {
        const SplinePtr along = against ? refine::reverse(*edge, 0, false) : edge;
        const SplinePtr same = refine::reparametrize(along, 0, image->axis(0).domain());
        return bounds::deviation_below(*image, *same, tolerance);
    } catch (const Error &) { // knots would merge
        return std::nullopt;
    }
}

// A bound on the distance of points that belong together by nearest points: those on b of points of a, or the
// other way round.
double along_feet(const SplinePtr &a, const SplinePtr &b, bool against, double tolerance) {
    const SplinePtr along = against ? refine::reverse(*b, 0, false) : b;
    const double there = distance_along_feet(a, along, tolerance);
    return there <= tolerance ? there : std::min(there, distance_along_feet(along, a, tolerance));
}

using Ends = std::array<Vector3, 2>;

Ends ends_of(const Spline &curve) {
    Ends ends{};
    for (const size_t k : {size_t{0}, size_t{1}}) {
        double x[space_dim];
        eval::end_point(curve, k == 1, x);
        ends[k] = {x[0], x[1], x[2]};
    }
    return ends;
}

// The larger of the two distances between ends, for curves that run alike or against each other.
double distance_of_ends(const Ends &x, const Ends &y, bool against) noexcept {
    const size_t first = against ? 1 : 0;
    return std::max(length(x[0] - y[first]), length(x[1] - y[1 - first]));
}

// The same in the direction in which it is smaller; 0 if both curves are closed, as their ends may be
// anywhere.
double distance_of_ends(const Spline &a, const Spline &b, double tolerance) {
    const Ends x = ends_of(a), y = ends_of(b);
    if (length(x[0] - x[1]) <= tolerance && length(y[0] - y[1]) <= tolerance) {
        return 0;
    }
    return std::min(distance_of_ends(x, y, false), distance_of_ends(x, y, true));
}

// A distance that one of a few sample points of a curve is proven to have from another curve, if it is above
// the tolerance; else 0.
double far_place(const Spline &from, const Spline &to, double tolerance) {
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        double x[space_dim];
        eval::curve_point(from, parameter_in(from.axis(0).domain(), share), false, x);
        const closest::Foot foot = closest::locator_of(to).nearest(
            {x, nullptr, tolerance / 16, closest::usual_budget(to), false, true});
        const double at_least = foot.distance - tolerance / 16 - foot.noise;
        if ((foot.status & closest::closest_certified) != 0 && at_least > tolerance) {
            return at_least;
        }
    }
    return 0;
}

Deviation to_nearest(const MadeCurve &image, const Spline &edge, double tolerance) {
    const auto there = closest::one_sided_distance(*image.curve, edge, tolerance / 16, most_pieces),
               back = closest::one_sided_distance(edge, *image.curve, tolerance / 16, most_pieces);
    const bool proven = image.proven && there.certified && back.certified;
    return {std::max(there.at_most, back.at_most) + image.distance, proven};
}

} // namespace

namespace {

SplinePtr make_edge(const Face &face, const Coedge &coedge) {
    const SplinePtr made = over(face, coedge).curve;
    return coedge.against ? refine::reverse(*made, 0, false) : made;
}

std::vector<SplinePtr> make_edges(const Face &face) {
    std::vector<SplinePtr> edges;
    for (const Loop &loop : face.loops()) {
        for (const Coedge &coedge : loop) {
            edges.push_back(coedge.edge == nullptr ? make_edge(face, coedge) : nullptr);
        }
    }
    return edges;
}

// The number of the coedge among all of the face; none if it is a copy.
std::optional<size_t> number_of(const Face &face, const Coedge &coedge) {
    size_t number = 0;
    for (const Loop &loop : face.loops()) {
        const auto *first = loop.data(), *last = first + loop.size();
        if (!std::less<>{}(&coedge, first) && std::less<>{}(&coedge, last)) {
            return number + static_cast<size_t>(&coedge - first);
        }
        number += loop.size();
    }
    return std::nullopt;
}

} // namespace

// Kept, because composing takes longer than most of what edges are used for.
SplinePtr edge_of(const Face &face, const Coedge &coedge) {
    if (coedge.edge != nullptr) {
        return coedge.edge;
    }
    const std::optional<size_t> number = number_of(face, coedge);
    return number ? face.made_edges().get([&] { return make_edges(face); })[*number]
                  : make_edge(face, coedge);
}

Deviation deviation_of(const Face &face, const Coedge &coedge) {
    if (coedge.deviation) {
        return *coedge.deviation;
    }
    const MadeCurve image = over(face, coedge);
    if (coedge.edge == nullptr) {
        return {image.distance, image.proven};
    }
    const std::optional<double> equal =
        at_equal_parameters(image.curve, coedge.edge, coedge.against, face.tolerance());
    if (equal && *equal + image.distance <= face.tolerance()) {
        return {*equal + image.distance, image.proven};
    }
    const double along = along_feet(image.curve, coedge.edge, coedge.against, face.tolerance());
    if (along + image.distance <= face.tolerance()) {
        return {along + image.distance, image.proven};
    }
    return to_nearest(image, *coedge.edge, face.tolerance());
}

// Cheap tests come first, because many curves that are far apart may have the same key.
double distance_beyond(const SplinePtr &a, const SplinePtr &b, double tolerance) {
    if (const double ends = distance_of_ends(*a, *b, tolerance); ends > tolerance) {
        return ends;
    }
    for (const double place : {far_place(*a, *b, tolerance), far_place(*b, *a, tolerance)}) {
        if (place > tolerance) {
            return place;
        }
    }
    for (const bool against : {false, true}) {
        if (at_equal_parameters(a, b, against, tolerance).value_or(HUGE_VAL) <= tolerance) {
            return 0;
        }
    }
    const auto least = [tolerance](const Spline &from, const Spline &to) {
        return closest::one_sided_distance(from, to, tolerance / 16, most_compared).at_least;
    };
    const double distance = std::max(least(*a, *b), least(*b, *a));
    return distance > tolerance ? distance : 0;
}

namespace {

// Whether the feet on b of two points of a descend. Points in the middle of a are taken, because points near
// both ends of closed curves would decide nothing.
bool feet_fall(const Spline &a, const Spline &b, double tolerance) {
    double at[2];
    for (const size_t k : {size_t{0}, size_t{1}}) {
        const std::vector<double> x =
            eval::curve_point(a, parameter_in(a.axis(0).domain(), k == 0 ? 0.375 : 0.625), false);
        at[k] = closest::locator_of(b)
                    .nearest({x.data(), nullptr, tolerance / 16, closest::usual_budget(b), false, true})
                    .params[0];
    }
    return at[0] > at[1];
}

// The Hausdorff distance, if it is proven to be within the tolerance. Where the first search leaves that
// open, a second one is closer.
std::optional<double> two_sided(const Spline &a, const Spline &b, double tolerance) {
    for (const double share : {0x1p-4, 0x1p-10}) {
        const auto there = closest::one_sided_distance(a, b, share * tolerance, most_compared),
                   back = closest::one_sided_distance(b, a, share * tolerance, most_compared);
        if (std::max(there.at_least, back.at_least) > tolerance) {
            break;
        }
        if (const double most = std::max(there.at_most, back.at_most); most <= tolerance) {
            return most;
        }
    }
    return std::nullopt;
}

} // namespace

// Cheap tests come first, as above.
std::optional<CurveMatch> match_within(const SplinePtr &a, const SplinePtr &b, double tolerance) {
    const Ends x = ends_of(*a), y = ends_of(*b);
    std::vector<bool> directions;
    for (const bool against : {false, true}) {
        if (distance_of_ends(x, y, against) <= tolerance) {
            directions.push_back(against);
        }
    }
    if (directions.empty() || far_place(*a, *b, tolerance) > tolerance ||
        far_place(*b, *a, tolerance) > tolerance) {
        return std::nullopt;
    }
    for (const bool against : directions) {
        const double apart = at_equal_parameters(a, b, against, tolerance).value_or(HUGE_VAL);
        if (apart <= tolerance) {
            return CurveMatch{apart, against};
        }
    }
    const bool against = directions.size() == 1 ? directions.front() : feet_fall(*a, *b, tolerance);
    const double along = along_feet(a, b, against, tolerance);
    if (along <= tolerance) {
        return CurveMatch{along, against};
    }
    const std::optional<double> apart = two_sided(*a, *b, tolerance);
    return apart ? std::optional(CurveMatch{*apart, against}) : std::nullopt;
}

} // namespace nrb::face
