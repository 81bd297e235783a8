// SPDX-License-Identifier: MIT
#include "fit/offset/offset_curve.h"

#include "base/error.h"
#include "base/numbers.h"
#include "eval/evaluate.h"
#include "fit/offset/offset_jet.h"
#include "fit/offset/offset_proof.h"
#include "fit/offset/patch_axis.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr int curve_order = taylor_order + 1;
constexpr int64_t curve_slots = curve_order + 1;

// The offset at a parameter, as a Taylor polynomial along the first of its two axes.
struct CurveJet {
    TaylorVector offset;
    bool turns_back; // against the curve
};

// The Taylor polynomial of the derivative of an order.
TaylorVector taylor_of(const double *records, int order) noexcept {
    constexpr double factorials[Taylor::count] = {1, 1, 2};
    TaylorVector made;
    for (size_t i = 0; i < Taylor::count; ++i) {
        const double *x = records + (static_cast<ptrdiff_t>(i) + order) * space_dim;
        made.set(i, 0, 1 / factorials[i] * Vector3{x[0], x[1], x[2]});
    }
    return made;
}

// The offset along n = V x C'.
CurveJet jet_of(const double *records, const CurveOffset &offset, double param) {
    TaylorVector reference;
    reference.set(0, 0, offset.reference);
    const TaylorVector tangent = taylor_of(records, 1), n = cross(reference, tangent);
    const Vector3 way = tangent.at(0, 0);
    if (!(length(n.at(0, 0)) > least_sine * length(way))) {
        fail(Status::unsupported,
             "the curve has no tangent across the reference direction at %s, where its offset is not known",
             Number(param).text);
    }
    const TaylorVector made = moved(taylor_of(records, 0), offset.distance, unit(n));
    return {made, !(dot(made.at(1, 0), way) > 0)};
}

// `left`: limits from below.
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

// The offsets at the ends of all pieces, from both sides.
struct PieceEnds {
    std::vector<CurveJet> from_below, from_above;

    // The largest gap between the ends of neighbouring pieces.
    [[nodiscard]] double jump() const noexcept {
        double largest = 0;
        for (size_t i = 1; i + 1 < from_below.size(); ++i) {
            largest =
                std::max(largest, length(from_below[i].offset.at(0, 0) - from_above[i].offset.at(0, 0)));
        }
        return largest;
    }
    [[nodiscard]] SplinePtr spline(const PatchAxis &axis) const {
        const std::vector<Site> sites = sites_of(axis);
        std::vector<double> points;
        for (const Layer &layer : layers_of(axis)) {
            const auto [at, left] = sites[layer.site];
            const TaylorVector &jet = (left ? from_below : from_above)[at].offset;
            Vector3 sum;
            for (size_t i = 0; i < Taylor::count; ++i) {
                sum = sum + layer.factors[i] * jet.at(i, 0);
            }
            points.insert(points.end(), {sum.x, sum.y, sum.z});
        }
        return make_result({knots_of(axis)}, space_dim, Form::polynomial, std::move(points));
    }
};

class CurveFit {
public:
    CurveFit(const Spline &curve, const CurveOffset &offset, const OffsetRule &rule)
        : curve_(curve), offset_(offset), rule_(rule), cost_(cost_of(curve)),
          axis_(patch_axis(curve.axis(0))) {}

    OffsetCurve run() {
        if (!affordable(axis_)) {
            fail(Status::not_converged, "no pieces are left for the offset curve, which takes %lld",
                 static_cast<long long>(axis_.count()));
        }
        do {
            look();
        } while (best_.bound > rule_.tolerance && refine());
        if (best_.spline == nullptr) {
            fail(Status::not_converged,
                 "how near the offset curve is could not be told with the %lld pieces that there may be",
                 static_cast<long long>(axis_.count()));
        }
        return std::move(best_);
    }

private:
    // The cost of a piece, as a multiple of that of a cubic polynomial one.
    static int64_t cost_of(const Spline &curve) noexcept {
        const double cost = (curve.axis(0).degree() + 1) / 4.0;
        return std::max<int64_t>(1, std::llround((curve.rational() ? 2 : 1) * cost * cost));
    }
    [[nodiscard]] bool affordable(const PatchAxis &axis) const noexcept {
        return axis.count() <= rule_.most_patches &&
               (rule_.left == nullptr || axis.count() <= *rule_.left / cost_);
    }
    void look() {
        if (rule_.left != nullptr) {
            *rule_.left -= axis_.count() * cost_;
        }
        const PieceEnds ends{jets_at(curve_, offset_, axis_.breaks, true),
                             jets_at(curve_, offset_, axis_.breaks, false)};
        SplinePtr candidate = ends.spline(axis_);
        bounds_ = offset_bounds(curve_, offset_, *candidate, axis_.breaks);
        const double worst = *std::max_element(bounds_.begin(), bounds_.end());
        if (worst > rule_.tolerance &&
            ends.jump() > std::max(rule_.tolerance, least_sine * std::abs(offset_.distance))) {
            fail(Status::unsupported, "the curve has a kink at a knot, where its offset has a gap of %s",
                 Number(ends.jump()).text);
        }
        if (worst < best_.bound) {
            best_ = {std::move(candidate), worst,
                     any_turns_back(ends.from_below) || any_turns_back(ends.from_above) ||
                         any_turns_back(jets_at(curve_, offset_, middles(axis_.breaks), false))};
        }
    }
    // Cuts pieces as much as needed. If that makes too many pieces, it cuts as much as is affordable, towards
    // a larger tolerance. Returns whether any were cut.
    bool refine() {
        for (int doublings = 0;; ++doublings) {
            const double wanted = std::ldexp(rule_.tolerance, doublings);
            std::vector<int> parts;
            for (const double bound : bounds_) {
                parts.push_back(parts_for(bound, wanted));
            }
            PatchAxis next = cut(axis_, parts);
            if (next.count() == axis_.count() || !rising(next)) {
                return false;
            }
            if (affordable(next)) {
                axis_ = std::move(next);
                return true;
            }
        }
    }

    const Spline &curve_;
    const CurveOffset &offset_;
    OffsetRule rule_;
    int64_t cost_;
    PatchAxis axis_;
    std::vector<double> bounds_; // of the pieces of axis_
    OffsetCurve best_{nullptr, infinity, false};
};

} // namespace

OffsetCurve offset_curve(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule) {
    if (std::abs(offset.distance) <= rule.tolerance) {
        return {curve, std::abs(offset.distance), false};
    }
    if (curve->dim() == space_dim) {
        return CurveFit(*curve, offset, rule).run();
    }
    constexpr double raise[6] = {1, 0, 0, 1, 0, 0}, flatten[6] = {1, 0, 0, 0, 1, 0};
    const SplinePtr raised = refine::transform(*curve, {3, 2, raise}, nullptr);
    OffsetCurve made = CurveFit(*raised, {offset.distance, {0, 0, 1}}, rule).run();
    made.spline = refine::transform(*made.spline, {2, 3, flatten}, nullptr);
    return made;
}

} // namespace nrb::fit
