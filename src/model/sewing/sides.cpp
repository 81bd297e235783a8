// SPDX-License-Identifier: MIT
#include "model/sewing/sides.h"

#include "base/error.h"
#include "base/watch.h"
#include "bounds/box.h"
#include "build/polylines.h"
#include "eval/curve_point.h"
#include "face/made/curve_under.h"
#include "model/rays/face_place.h"
#include "numeric/norm.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"
#include "refine/parts/iso.h"
#include "spline/part.h"
#include "spline/same_numbers.h"

#include <algorithm>

namespace nrb::model {

namespace {

bool same_curves(const face::Loop &a, const face::Loop &b) {
    return std::ranges::equal(
        a, b, [](const face::Coedge &x, const face::Coedge &y) { return same_numbers(*x.curve, *y.curve); });
}

bool is_whole(const face::Face &face) {
    return std::ranges::equal(face.loops(), face::natural_loops(face.covering()), same_curves);
}

// Whether the line midway between the two ends of axis k is within twice the tolerance of the lower end, at
// five samples. The ends are then near each other because the surface is thin, not because it closes.
bool is_thin(const Spline &surface, const face::Covering &covering, int k, double tolerance) {
    const int along = 1 - k;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        face::Point2 side{}, middle{};
        side[static_cast<size_t>(k)] = covering.domain(k).lower;
        middle[static_cast<size_t>(k)] = parameter_in(covering.domain(k), 0.5);
        side[static_cast<size_t>(along)] = middle[static_cast<size_t>(along)] =
            parameter_in(covering.domain(along), share);
        if (face::gap_between(surface, covering, side, middle) > 2 * tolerance) {
            return false;
        }
    }
    return true;
}

bool closes_thin(const face::Face &face, const face::Covering &wider, double tolerance) {
    return std::ranges::any_of(std::array{0, 1}, [&](int k) {
        return wider.closed(k) && !face.covering().closed(k) && is_thin(*face.surface(), wider, k, tolerance);
    });
}

std::optional<StraightCurve> along_axis(const Spline &curve, const face::Covering &covering) {
    if (curve.axis(0).degree() != 1 || curve.count(0) != 2 || curve.form() != Form::polynomial) {
        return std::nullopt;
    }
    for (const int across : {0, 1}) {
        const StraightCurve found{across, curve.coordinate(0, across), curve.coordinate(0, 1 - across),
                                  curve.coordinate(1, 1 - across)};
        const auto inside = [&](int k, double x) {
            return covering.domain(k).lower <= x && x <= covering.domain(k).upper;
        };
        if (curve.coordinate(1, across) == found.at && found.from != found.to && inside(across, found.at) &&
            inside(1 - across, found.from) && inside(1 - across, found.to)) {
            return found;
        }
    }
    return std::nullopt;
}

// The isoparametric curve. It has the degree of the surface along the axis, which a composed curve would
// exceed.
SplinePtr iso_image(const Spline &surface, const Spline &curve, const StraightCurve &straight) {
    const SplinePtr iso = refine::iso(surface, straight.across, straight.at, {});
    const bool falls = straight.from > straight.to;
    const SplinePtr part = refine::cut_axis(iso, 0, std::min(straight.from, straight.to),
                                            std::max(straight.from, straight.to), {true, true});
    return refine::reparametrize(falls ? refine::reverse(*part, 0, false) : part, 0, curve.axis(0).domain());
}

void set_image(const face::Face &face, double tolerance, Side &side) {
    side.along = along_axis(*side.curve, face.covering());
    if (side.along) {
        try {
            side.image = iso_image(*face.surface(), *side.curve, *side.along);
            return;
        } catch (const Error &) { // knots would coincide
        }
    }
    const face::MadeCurve made = face::edge_over(face.surface(), face.covering(), side.curve, tolerance / 16);
    side.image = made.curve;
    side.off = made.distance;
}

} // namespace

SplinePtr curve_part(const Side &side, Interval range) {
    if (!side.along) {
        return refine::cut_axis(side.curve, 0, range.lower, range.upper, {true, true});
    }
    const StraightCurve &straight = *side.along;
    const Interval domain = side.curve->axis(0).domain();
    std::vector<double> points(4, straight.at);
    for (const size_t k : {size_t{0}, size_t{1}}) {
        const double share =
            ((k == 0 ? range.lower : range.upper) - domain.lower) / (domain.upper - domain.lower);
        points[2 * k + static_cast<size_t>(1 - straight.across)] =
            straight.from <= straight.to ? parameter_in({straight.from, straight.to}, share)
                                         : parameter_in({straight.to, straight.from}, 1 - share);
    }
    return build::polyline(2, std::move(points), {range.lower, range.upper});
}

Patch patch_of(const face::FacePtr &face, double tolerance) {
    Patch patch{face, face->loops(), is_whole(*face), face->tolerance()};
    if (patch.natural && tolerance > face->tolerance()) {
        const face::Covering wider(*face->surface(), tolerance);
        if (closes_thin(*face, wider, tolerance)) {
            patch.natural = false;
        } else {
            patch.loops = face::natural_loops(wider);
            patch.tolerance = tolerance;
        }
    }
    return patch;
}

void append_sides(const Patch &patch, int64_t number, double tolerance, std::vector<Side> &sides) {
    for (size_t loop = 0; loop < patch.loops.size(); ++loop) {
        for (size_t i = 0; i < patch.loops[loop].size(); ++i) {
            Side side{number, static_cast<int64_t>(loop), static_cast<int64_t>(i),
                      patch.loops[loop][i].curve};
            set_image(*patch.given, tolerance, side);
            side.box = box3_of(bounds::bounding_box(*side.image, whole_domain(*side.image), 0x1p-6));
            sides.push_back(std::move(side));
            count_work(1 << 12);
        }
    }
}

bool is_collapsed(const Spline &curve, double tolerance) {
    if (curve.rational() && !(curve.all_weights().smallest > 0)) {
        return false;
    }
    const std::vector<double> start = eval::end_point(curve, false);
    std::vector<double> point(start.size());
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        for (size_t k = 0; k < point.size(); ++k) {
            point[k] = curve.coordinate(i, static_cast<int>(k));
        }
        if (!(distance(point.data(), start.data(), curve.dim()) <= tolerance)) {
            return false;
        }
    }
    return true;
}

} // namespace nrb::model
