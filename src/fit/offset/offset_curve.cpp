// SPDX-License-Identifier: MIT
#include "fit/offset/offset_curve.h"

#include "base/error.h"
#include "eval/evaluate.h"
#include "fit/offset/offset_jet.h"
#include "fit/offset/offset_proof.h"
#include "fit/offset/patch_axis.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr int curve_order = 2;
constexpr int64_t curve_slots = curve_order + 1;

// A point of the offset, with its derivative.
struct CurveJet {
    Vector3 point, tangent;
    bool turns_back; // against the curve
};

// With n = V x C' and l = |n|, N' = (n' - (N n') N) / l.
CurveJet jet_of(const double *records, const CurveOffset &offset, double param) {
    const auto slot = [&](int k) {
        const double *x = records + static_cast<ptrdiff_t>(k) * space_dim;
        return Vector3{x[0], x[1], x[2]};
    };
    const Vector3 tangent = slot(1), n = cross(offset.reference, tangent),
                  change = cross(offset.reference, slot(2));
    const double l = length(n);
    if (!(l > least_sine * length(tangent))) {
        fail(Status::unsupported,
             "the curve has no tangent across the reference direction at %s, where its offset is not known",
             Number(param).text);
    }
    const Vector3 unit = (1 / l) * n, turning = (1 / l) * (change - dot(unit, change) * unit);
    const Vector3 along = tangent + offset.distance * turning;
    return {slot(0) + offset.distance * unit, along, !(dot(along, tangent) > 0)};
}

// left: the limits from below.
std::vector<CurveJet> jets_at(const Spline &curve, const CurveOffset &offset,
                              const std::vector<double> &params, bool left) {
    const int64_t count = std::ssize(params);
    std::vector<double> records(static_cast<size_t>(count * curve_slots * space_dim));
    eval::AxisRules rules{};
    rules[0].left = left;
    eval::evaluate_points(curve, rules, curve_order, {params.data(), count, 1, 1, 1},
                          {records.data(), count, curve_slots * space_dim, curve_slots * space_dim, 1});
    std::vector<CurveJet> jets;
    jets.reserve(params.size());
    for (int64_t i = 0; i < count; ++i) {
        jets.push_back(
            jet_of(records.data() + i * curve_slots * space_dim, offset, params[static_cast<size_t>(i)]));
    }
    return jets;
}

std::vector<double> middles(const std::vector<double> &breaks) {
    std::vector<double> params;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        params.push_back(breaks[i] / 2 + breaks[i + 1] / 2);
    }
    return params;
}

bool any_turns_back(const std::vector<CurveJet> &jets) noexcept {
    return std::any_of(jets.begin(), jets.end(), [](const CurveJet &jet) { return jet.turns_back; });
}

// The offsets at the ends of all pieces.
struct PieceEnds {
    std::vector<CurveJet> from_below, from_above;

    // The largest distance of the ends of neighbours.
    [[nodiscard]] double jump() const noexcept {
        double largest = 0;
        for (size_t i = 1; i + 1 < from_below.size(); ++i) {
            largest = std::max(largest, length(from_below[i].point - from_above[i].point));
        }
        return largest;
    }
    [[nodiscard]] SplinePtr spline(const PatchAxis &axis) const {
        std::vector<double> points;
        const auto add = [&](const Vector3 &x) { points.insert(points.end(), {x.x, x.y, x.z}); };
        add(from_above.front().point);
        for (size_t i = 0; i + 1 < axis.breaks.size(); ++i) {
            const double third = (axis.breaks[i + 1] - axis.breaks[i]) / 3;
            const CurveJet &start = from_above[i], &end = from_below[i + 1];
            add(start.point + third * start.tangent);
            add(end.point - third * end.tangent);
            if (!axis.smooth[i + 1]) {
                add(end.point);
            }
        }
        return make_result({knots_of(axis)}, space_dim, Form::polynomial, std::move(points));
    }
};

void spend(const OffsetRule &rule, int64_t pieces) {
    if (rule.left != nullptr && (*rule.left -= pieces) < 0) {
        *rule.left = 0;
        fail(Status::not_converged, "no pieces are left for the offset curve, which takes %lld",
             static_cast<long long>(pieces));
    }
}

PatchAxis finer(const PatchAxis &axis, const std::vector<double> &bounds, const OffsetRule &rule) {
    std::vector<int> parts;
    for (const double bound : bounds) {
        parts.push_back(bound <= rule.tolerance ? 1 : parts_for(bound, rule.tolerance));
    }
    PatchAxis next = cut(axis, parts);
    if (next.count() > rule.most_patches || !rising(next)) {
        fail(Status::not_converged, "the offset curve is known within %s only, expected %s",
             Number(*std::max_element(bounds.begin(), bounds.end())).text, Number(rule.tolerance).text);
    }
    return next;
}

OffsetCurve offset_in_space(const Spline &curve, const CurveOffset &offset, const OffsetRule &rule) {
    for (PatchAxis axis = patch_axis(curve.axis(0));;) {
        spend(rule, axis.count());
        const PieceEnds ends{jets_at(curve, offset, axis.breaks, true),
                             jets_at(curve, offset, axis.breaks, false)};
        SplinePtr candidate = ends.spline(axis);
        const std::vector<double> bounds = offset_bounds(curve, offset, *candidate, axis.breaks);
        const double worst = *std::max_element(bounds.begin(), bounds.end());
        if (worst <= rule.tolerance) {
            return {std::move(candidate), worst,
                    any_turns_back(ends.from_below) || any_turns_back(ends.from_above) ||
                        any_turns_back(jets_at(curve, offset, middles(axis.breaks), false))};
        }
        if (ends.jump() > rule.tolerance) {
            fail(Status::unsupported, "the curve has a kink at a knot, where its offset has a gap of %s",
                 Number(ends.jump()).text);
        }
        axis = finer(axis, bounds, rule);
    }
}

} // namespace

OffsetCurve offset_curve(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule) {
    if (curve->dim() == space_dim) {
        return offset_in_space(*curve, offset, rule);
    }
    constexpr double raise[6] = {1, 0, 0, 1, 0, 0}, flatten[6] = {1, 0, 0, 0, 1, 0};
    const SplinePtr raised = refine::transform(*curve, {3, 2, raise}, nullptr);
    OffsetCurve made = offset_in_space(*raised, {offset.distance, {0, 0, 1}}, rule);
    made.spline = refine::transform(*made.spline, {2, 3, flatten}, nullptr);
    return made;
}

} // namespace nrb::fit
