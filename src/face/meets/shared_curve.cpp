// SPDX-License-Identifier: MIT
#include "face/meets/shared_curve.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "face/arrange/ways.h"
#include "face/made/curve_under.h"
#include "face/made/seam_parts.h"
#include "face/made/speeds.h"
#include "face/meets/ground.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// The precision of curves that are made on the other surface, as a share of the tolerance.
constexpr double share_of_precision = 1.0 / 8;

Point2 end_place(const Spline &curve, bool upper) {
    Point2 end;
    eval::end_point(curve, upper, end.data());
    return end;
}

} // namespace

SharedCurve part_of(const SharedCurve &curve, Interval range, bool back) {
    const auto part = [&](const SplinePtr &own) {
        const SplinePtr cut = same(own->axis(0).domain(), range)
                                  ? own
                                  : refine::cut_axis(own, 0, range.lower, range.upper, {true, true});
        return back ? refine::reverse(*cut, 0, false) : cut;
    };
    return {part(curve.space), {part(curve.on[0]), part(curve.on[1])}, curve.deviation};
}

SharedLoop turned(const SharedLoop &loop) {
    SharedLoop result;
    for (auto curve = loop.rbegin(); curve != loop.rend(); ++curve) {
        result.push_back(part_of(*curve, curve->space->axis(0).domain(), true));
    }
    return result;
}

SharedGrounds::SharedGrounds(const std::array<SplinePtr, 2> &surfaces,
                             const std::array<double, 2> &tolerances, double tolerance)
    : surfaces_(surfaces), coverings_{Covering(*surfaces[0], tolerances[0]),
                                      Covering(*surfaces[1], tolerances[1])},
      speeds_{fastest(*surfaces[0]), fastest(*surfaces[1])}, tolerance_(tolerance),
      near_(std::max({tolerance, tolerances[0], tolerances[1]})) {}

SharedLoop SharedGrounds::over(size_t k, const SplinePtr &curve) const {
    std::vector<SplinePtr> parts = seam_parts(coverings_[k], refine::clamp_ends(curve, 0)).parts;
    if (parts.empty()) { // the curve leaves the domain by more than rounding
        parts.push_back(refine::clamp_ends(curve, 0));
    }
    SharedLoop result;
    for (const SplinePtr &part : parts) {
        add_over(k, part, result);
    }
    return result;
}

// Adds the parts of a curve in the domain of surface k, cut where the other surface closes.
void SharedGrounds::add_over(size_t k, const SplinePtr &own, SharedLoop &result) const {
    const size_t other = 1 - k;
    const double precision = share_of_precision * tolerance_;
    const MadeCurve space = edge_over(surfaces_[k], coverings_[k], own, precision);
    Effort effort;
    effort.allow(*space.curve);
    const MadeCurve under =
        curve_under(surfaces_[other], coverings_[other], space.curve, {2 * near_, precision, false}, effort);
    SharedCurve whole{space.curve, {}, space.proven ? space.distance : infinity};
    whole.on[k] = own;
    whole.on[other] = refine::clamp_ends(under.curve, 0);
    std::vector<SplinePtr> parts = seam_parts(coverings_[other], whole.on[other]).parts;
    if (parts.empty()) {
        parts.push_back(whole.on[other]);
    }
    for (const SplinePtr &part : parts) {
        SharedCurve shared = part_of(whole, part->axis(0).domain(), false);
        shared.on[other] = part;
        shared.deviation = std::max(shared.deviation, proven_distance(surfaces_[other], coverings_[other],
                                                                      part, *shared.space)) +
                           16 * eps * coverings_[k].extent();
        result.push_back(std::move(shared));
    }
}

// As a single control point moves, no point of the curve moves farther than that (convex hull property).
void SharedGrounds::set_start(SharedCurve &curve, const SharedCurve &before) const {
    const std::vector<double> at = eval::end_point(*curve.space, false),
                              to_point = eval::end_point(*before.space, true);
    double off = 0;
    for (size_t k = 0; k < 2; ++k) {
        const Point2 start = end_place(*curve.on[k], false),
                     to = coverings_[k].nearest_copy(end_place(*before.on[k], true), start);
        if (coverings_[k].pole_near(at.data(), near_).axis >= 0) { // curves meet there at any parameters
            continue;
        }
        curve.on[k] = with_end(curve.on[k], false, to, infinity);
        off = std::max(off, speeds_[k][0] * std::abs(to[0] - start[0]) +
                                speeds_[k][1] * std::abs(to[1] - start[1]));
    }
    curve.space = with_end(curve.space, false, to_point, infinity);
    curve.deviation += off + std::hypot(to_point[0] - at[0], to_point[1] - at[1], to_point[2] - at[2]);
}

void SharedGrounds::join(SharedLoop &loop) const {
    for (size_t i = 0; i < loop.size(); ++i) {
        set_start(loop[(i + 1) % loop.size()], loop[i]);
    }
}

bool passes_seam(const SharedCurve &before, const SharedCurve &after) {
    return end_place(*before.on[0], true) != end_place(*after.on[0], false) ||
           end_place(*before.on[1], true) != end_place(*after.on[1], false);
}

bool SharedGrounds::is_alike(const Point2 &first, const Point2 &second) const {
    return dot(surface_normal(*surfaces_[0], coverings_[0].in_domain(first)),
               surface_normal(*surfaces_[1], coverings_[1].in_domain(second))) > 0;
}

} // namespace nrb::face
