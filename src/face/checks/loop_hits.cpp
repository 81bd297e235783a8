// SPDX-License-Identifier: MIT
#include "face/checks/loop_hits.h"

#include "base/error.h"
#include "base/watch.h"
#include "bounds/box.h"
#include "build/polylines.h"
#include "closest/closest.h"
#include "closest/locator.h"
#include "eval/curve_point.h"
#include "intersect/pairs/curve_curve.h"
#include "intersect/pairs/periods.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nrb::face {

namespace {

using intersect::Box3;

constexpr double most_loop_copies = 0x1p16; // most copies of the domain through which curves may run
// Larger by what rounding does to copies, and by the distance that counts as none.
Box3 flat_box(const bounds::Box &box, const Point2 &move, const Point2 &scale, double near) noexcept {
    Box3 flat;
    flat.lower[2] = flat.upper[2] = 0;
    for (size_t k = 0; k < 2; ++k) {
        const double room = 0x1p-40 + near;
        flat.lower[k] = (box.lower[k] + move[k]) * scale[k] - room;
        flat.upper[k] = (box.upper[k] + move[k]) * scale[k] + room;
    }
    return flat;
}

Box3 moved_box(Box3 box, const Point2 &by) noexcept {
    for (size_t k = 0; k < 2; ++k) {
        box.lower[k] += by[k];
        box.upper[k] += by[k];
    }
    return box;
}

// Whether one coordinate of the control points strictly ascends or descends. Then the curve has no value of
// it twice, since by variation diminution a line meets the curve no more often than its control polygon.
bool runs_one_way(const Spline &curve) noexcept {
    for (const int k : {0, 1}) {
        bool rises = true, falls = true;
        for (int64_t i = 1; i < curve.point_count() && (rises || falls); ++i) {
            const double step = curve.coordinate(i, k) - curve.coordinate(i - 1, k);
            rises = rises && step > 0;
            falls = falls && step < 0;
        }
        if (rises || falls) {
            return true;
        }
    }
    return false;
}

} // namespace

LoopHits::LoopHits(const Covering &covering, std::span<const ClosedLoop> loops, double near)
    : covering_(covering), near_(near), scale_(covering.units()) {
    add(loops);
    // The loops of a face should not cross. Other curves, for which `near` is not 0, may cross everywhere.
    const int64_t for_a_point = near_ > 0 ? 1000000 : 100000;
    const UsualLimit usual(usual_work(points(), for_a_point));
    const intersect::BoxTree tree(boxes_);
    const Phase phase(0.75);
    Steps steps(std::ssize(curves_));
    for (size_t a = 0; a < curves_.size(); ++a) {
        compare(a, tree);
        steps.next();
    }
}

void LoopHits::add(std::span<const ClosedLoop> loops) {
    const Phase phase(0.125);
    for (const ClosedLoop &loop : loops) {
        const auto number = static_cast<int>(sizes_.size());
        const bool around = loop.placed.turn != Point2{0, 0};
        int index = 0;
        for (const PlacedCurve &placed : loop.placed.curves) {
            add(*placed.curve, placed.shift, {nullptr, number, index++, around});
        }
        for (const Joint &gap : loop.segments) {
            add(*build::polyline(2, {gap.from[0], gap.from[1], gap.to[0], gap.to[1]}, {0, 1}), {0, 0},
                {nullptr, number, -1, around});
        }
        sizes_.push_back(index);
    }
}

int64_t LoopHits::points() const noexcept {
    int64_t count = 0;
    for (const LoopCurve &curve : curves_) {
        count += curve.spline->point_count();
    }
    return count;
}

void LoopHits::add(const Spline &curve, Point2 shift, LoopCurve of) {
    const bounds::Box box = bounds::bounding_box(curve, whole_domain(curve), 0x1p-10);
    for (const int k : {0, 1}) {
        const auto at = static_cast<size_t>(k);
        const double from = box.lower[at] + shift[at], period = covering_.period(k);
        if (covering_.closed(k)) {
            shift[at] -= std::floor((from - covering_.domain(k).lower) / period) * period;
        }
    }
    of.spline = scaled_copy(curve, scale_, {shift[0] * scale_[0], shift[1] * scale_[1]});
    boxes_.push_back(flat_box(box, shift, scale_, near_));
    curves_.push_back(std::move(of));
}

// Compares a with other curves by all moves that bring their boxes together. For a curve with itself, one of
// two opposite moves is enough.
void LoopHits::compare(size_t a, const intersect::BoxTree &tree) {
    const Box3 all = tree.box(), &own = boxes_[a];
    const Point2 period{covering_.period(0) * scale_[0], covering_.period(1) * scale_[1]};
    std::array<int64_t, 2> first{}, last{}; // loops run into few copies of the domain
    for (const int k : {0, 1}) {
        const auto at = static_cast<size_t>(k);
        if (covering_.closed(k)) {
            const double from = std::ceil((own.lower[at] - all.upper[at]) / period[at]),
                         to = std::floor((own.upper[at] - all.lower[at]) / period[at]);
            if (!(std::max(std::abs(from), std::abs(to)) <= most_loop_copies)) {
                fail(Status::not_converged,
                     "curves run through %s copies of the domain along axis %d, expected at most %s",
                     Number(std::max(std::abs(from), std::abs(to))).text, k, Number(most_loop_copies).text);
            }
            first[at] = static_cast<int64_t>(from);
            last[at] = static_cast<int64_t>(to);
        }
    }
    for (int64_t i = first[0]; i <= last[0]; ++i) {
        for (int64_t j = first[1]; j <= last[1]; ++j) {
            const Point2 move{static_cast<double>(i) * period[0], static_cast<double>(j) * period[1]};
            const bool itself = i > 0 || (i == 0 && j >= 0);
            int64_t looked = 1;
            tree.walk_box(moved_box(own, {-move[0], -move[1]}), [&](int32_t found) {
                const auto b = static_cast<size_t>(found);
                ++looked;
                if (b > a || (b == a && itself)) {
                    compare(a, b, move);
                }
            });
            count_work(32 * looked);
        }
    }
}

void LoopHits::compare(size_t a, size_t b, const Point2 &move) {
    const Spline &first = *curves_[a].spline;
    const bool here = move == Point2{0, 0};
    if (a == b && here && runs_one_way(first)) {
        return;
    }
    const SplinePtr second = here ? curves_[b].spline : scaled_copy(*curves_[b].spline, {1, 1}, move);
    const intersect::PairHits found = a == b && here ? intersect::curve_itself(first, near_)
                                                     : intersect::curve_curve(first, *second, near_);
    require_work();
    if (!found.complete && found.list.empty()) {
        fail(Status::not_converged, "it is undecided whether %s and %s cross", name(a).c_str(),
             name(b).c_str());
    }
    for (const intersect::PairHit &hit : found.list) {
        hits_.push_back({a,
                         b,
                         hit.a,
                         hit.b,
                         hit.range_a,
                         {std::min(hit.from_b, hit.to_b), std::max(hit.from_b, hit.to_b)},
                         hit.kind,
                         {move[0] / scale_[0], move[1] / scale_[1]},
                         hit.to_b < hit.from_b});
    }
}

Point2 LoopHits::place(size_t curve, double t) const {
    const Spline &spline = *curves_[curve].spline;
    Point2 x;
    eval::curve_point(spline, intersect::in_domain(spline, t), false, x.data());
    return {x[0] / scale_[0], x[1] / scale_[1]};
}

double LoopHits::distance(const Point2 &x, const Point2 &y) const noexcept {
    return std::hypot((x[0] - y[0]) * scale_[0], (x[1] - y[1]) * scale_[1]);
}

double LoopHits::foot(size_t curve, const Point2 &x, Interval range) const {
    const Spline &spline = *curves_[curve].spline;
    const Point2 scaled{x[0] * scale_[0], x[1] * scale_[1]};
    const Interval domain = spline.axis(0).domain();
    const bool inside = domain.lower <= range.lower && range.upper <= domain.upper;
    const closest::Query query{
        scaled.data(), inside ? &range : nullptr, 0, closest::usual_budget(spline), false, true};
    return closest::locator_of(spline).nearest(query).params[0];
}

double LoopHits::side(size_t curve, double t, const Point2 &x) const {
    std::array<double, 4> jet{}; // point and tangent
    eval::evaluate_points(*curves_[curve].spline, {}, 1, {&t, 1, 1, 1, 1}, {jet.data(), 1, 4, 4, 1});
    return jet[2] * (x[1] * scale_[1] - jet[1]) - jet[3] * (x[0] * scale_[0] - jet[0]);
}

std::string LoopHits::name(size_t curve) const {
    const LoopCurve &own = curves_[curve];
    const std::string loop = "loop " + std::to_string(own.loop);
    return own.index < 0 ? "a segment that closes a gap of " + loop
                         : "curve " + std::to_string(own.index) + " of " + loop;
}

bool LoopHits::follows(size_t a, size_t b) const noexcept {
    const LoopCurve &first = curves_[a], &second = curves_[b];
    const bool segment = first.index < 0 || second.index < 0;
    return first.loop == second.loop &&
           (segment || second.index == (first.index + 1) % sizes_[static_cast<size_t>(first.loop)]);
}

} // namespace nrb::face
