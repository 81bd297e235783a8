// SPDX-License-Identifier: MIT
#include "face/meets/common_edges.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "face/deviation.h"
#include "face/meets/ground.h"
#include "reduce/compatible.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"
#include "spline/part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace nrb::face {

namespace {

// Tangent planes count as equal if the sine of the angle between them is at most this, and rooms are not
// divided by a smaller sine.
constexpr double least_sine = 1.0 / 256;
// A room that was enlarged by such a division is no larger than this share of its edge.
constexpr double most_of_edge = 1.0 / 16;

using Keys = std::map<int64_t, const Coedge *>; // the first coedge of each key

Keys keys_of(const Face &face) {
    Keys keys;
    for (const Loop &loop : face.loops()) {
        for (const Coedge &coedge : loop) {
            if (coedge.key != 0) {
                keys.try_emplace(coedge.key, &coedge);
            }
        }
    }
    return keys;
}

// The largest magnitude of a coordinate of the control points, and the largest side of their box.
double size_of(const Spline &curve) noexcept {
    double size = 0;
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        for (int c = 0; c < 3; ++c) {
            size = std::max(size, std::abs(curve.coordinate(i, c)));
        }
    }
    return size;
}
double extent_of(const Spline &curve) noexcept {
    double extent = 0;
    for (int c = 0; c < 3; ++c) {
        double lower = infinity, upper = -infinity;
        for (int64_t i = 0; i < curve.point_count(); ++i) {
            lower = std::min(lower, curve.coordinate(i, c));
            upper = std::max(upper, curve.coordinate(i, c));
        }
        extent = std::max(extent, upper - lower);
    }
    return extent;
}

// Faces of different origin may have equal keys by chance.
bool are_one(const Face &a, const Coedge &on_a, const Face &b, const Coedge &on_b) {
    const SplinePtr one = edge_of(a, on_a), other = edge_of(b, on_b);
    const double room = a.tolerance() + b.tolerance() + 0x1p-40 * size_of(*one);
    return one == other || distance_beyond(one, other, room) == 0;
}

// A curve in the domain of a face over the parameters of an edge.
struct UnderEdge {
    SplinePtr curve;
    double distance; // a bound, or infinite
};

bool has_parameters_of(const Spline &curve, const Spline &edge) noexcept {
    return same(curve.axis(0).domain(), edge.axis(0).domain());
}

// The curve of the loop, if it has the parameters of the edge. turned: whether the two run in opposite
// directions.
UnderEdge given_under(const Face &face, const Coedge &coedge, const SplinePtr &edge, bool turned) {
    const SplinePtr curve = turned ? refine::reverse(*coedge.curve, 0, false) : coedge.curve;
    if (!has_parameters_of(*curve, *edge)) {
        return {nullptr, infinity};
    }
    return {curve, proven_distance(face.surface(), face.covering(), curve, *edge)};
}

// own: whether the edge is the one that the coedge has, or that one reversed.
UnderEdge under(const Face &face, const Coedge &coedge, const SplinePtr &edge, bool turned, bool own) {
    const double tolerance = face.tolerance();
    UnderEdge given = given_under(face, coedge, edge, turned);
    if (given.distance <= tolerance) {
        return given;
    }
    // The curve was made from the edge that was given with it, and proven to be near that.
    if (own && given.curve && coedge.deviation && coedge.deviation->proven) {
        return {given.curve, coedge.deviation->distance};
    }
    try {
        Effort effort;
        effort.allow(*edge);
        const MadeCurve made = curve_under(face.surface(), face.covering(), edge,
                                           {tolerance, share_of_fit * tolerance, true}, effort);
        return {made.curve, made.proven ? made.distance : infinity};
    } catch (const Error &error) { // farther away than the face says, or not to be followed
        if (error.status() != Status::gap && error.status() != Status::not_converged) {
            throw;
        }
    }
    const SplinePtr along = turned ? refine::reverse(*coedge.curve, 0, false) : coedge.curve;
    return {refine::reparametrize(along, 0, edge->axis(0).domain()), infinity};
}

Vector3 normal_at(const Face &face, const Spline &curve, double t) {
    const std::vector<double> on = eval::curve_point(curve, t, false);
    return surface_normal(*face.surface(), face.covering().in_domain({on[0], on[1]}));
}

Vector3 difference(const Spline &curve, double from, double to) {
    const std::vector<double> a = eval::curve_point(curve, from, false),
                              b = eval::curve_point(curve, to, false);
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

// The angles between the tangent planes of both faces at places along an edge.
struct Angles {
    double least = 1; // sine of the smallest angle
    double turn = 0;  // > 0: the edge runs along N_b x N_a
};
Angles angles_along(const Face &a, const Face &b, const intersect::MeetBranch &edge) {
    constexpr int places = 33;
    Angles angles;
    const Interval domain = edge.space->axis(0).domain();
    for (int i = 0; i < places; ++i) {
        const double t = parameter_in(domain, (i + 0.5) / places);
        const Vector3 n_a = normal_at(a, *edge.on, t), n_b = normal_at(b, *edge.on_second, t);
        const double far = length(n_a) * length(n_b);
        if (!(far > 0)) {
            continue;
        }
        const Vector3 along = cross(n_b, n_a);
        angles.least = std::min(angles.least, length(along) / far);
        const Vector3 way = difference(*edge.space, parameter_in(domain, (i + 0.25) / places),
                                       parameter_in(domain, (i + 0.75) / places));
        const double size = length(way);
        angles.turn += size > 0 ? dot(along, way) / (far * size) : 0;
    }
    count_work(places * 400);
    return angles;
}

void turn(intersect::MeetBranch &branch) {
    for (SplinePtr *curve : {&branch.space, &branch.on, &branch.on_second}) {
        *curve = refine::reverse(**curve, 0, false);
    }
}

SplinePtr clamped(const SplinePtr &curve) {
    const Interval domain = curve->axis(0).domain();
    return refine::restrict_axis(curve, 0, domain.lower, domain.upper);
}

bool is_closed(const Spline &edge, double tolerance) {
    const Interval domain = edge.axis(0).domain();
    return length(difference(edge, domain.lower, domain.upper)) <= tolerance;
}

CommonEdge common_edge(const Face &a, const Coedge &on_a, const Face &b, const Coedge &on_b,
                       double tolerance) {
    const SplinePtr own = edge_of(a, on_a),
                    edge = clamped(on_a.against ? refine::reverse(*own, 0, false) : own);
    const bool is_given = on_a.edge != nullptr;
    const UnderEdge in_a = under(a, on_a, edge, false, is_given),
                    in_b = under(b, on_b, edge, on_a.against != on_b.against,
                                 is_given && on_a.edge == on_b.edge);
    const std::array<SplinePtr, 3> curves{edge, clamped(in_a.curve), clamped(in_b.curve)};
    const std::vector<SplinePtr> all = reduce::make_compatible(curves, 0, false).splines;
    const double size = size_of(*edge);
    CommonEdge common{};
    common.branch.space = all[0];
    common.branch.on = all[1];
    common.branch.on_second = all[2];
    common.branch.deviation = std::max(in_a.distance, in_b.distance) + 16 * eps * size;
    common.branch.nodes = {-1, -1};
    common.branch.loop = -1;
    common.closes = is_closed(*edge, std::max(a.tolerance(), b.tolerance()));
    const Angles angles = angles_along(a, b, common.branch);
    const bool smooth = angles.least <= least_sine;
    common.branch.kind = smooth ? intersect::BranchKind::contact : intersect::BranchKind::edge;
    const double off = (std::isfinite(in_a.distance) ? in_a.distance : a.tolerance()) +
                       (std::isfinite(in_b.distance) ? in_b.distance : b.tolerance());
    const double least = 2 * (off + tolerance) + 0x1p-40 * size;
    common.room = std::max(
        least, std::min(least / std::max(angles.least, least_sine), most_of_edge * extent_of(*edge)));
    if (!smooth && angles.turn < 0) {
        turn(common.branch);
    }
    return common;
}

} // namespace

std::vector<CommonEdge> common_edges(const Face &a, const Face &b, double tolerance) {
    std::vector<CommonEdge> common;
    const Keys own = keys_of(a), others = keys_of(b);
    for (const auto &[key, on_a] : own) {
        const auto on_b = others.find(key);
        if (on_b != others.end() && are_one(a, *on_a, b, *on_b->second)) {
            common.push_back(common_edge(a, *on_a, b, *on_b->second, tolerance));
        }
    }
    return common;
}

} // namespace nrb::face
