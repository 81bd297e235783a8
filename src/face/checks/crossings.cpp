// SPDX-License-Identifier: MIT
#include "face/checks/crossings.h"

#include "base/error.h"
#include "base/numbers.h"
#include "face/checks/beside_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace nrb::face {

namespace {

using intersect::HitKind;

constexpr int range_samples = 8;

// How far rounding may move a place, in space.
double rounding(const Covering &covering) noexcept {
    double share = 1;
    for (const int k : {0, 1}) {
        const Interval domain = covering.domain(k);
        share =
            std::max(share, std::max(std::abs(domain.lower), std::abs(domain.upper)) / covering.period(k));
    }
    return 256 * eps * share * covering.extent();
}

} // namespace

Crossings::Crossings(const Spline &surface, const Covering &covering, std::span<const ClosedLoop> loops,
                     double tolerance)
    : surface_(surface), covering_(covering), near_(tolerance + rounding(covering)), hits_(covering, loops) {
    doubled_.assign(hits_.curves().size(), false);
    for (const LoopHit &hit : hits_.all()) {
        if (runs_along(hit)) {
            if (!is_allowed(hit)) {
                fail_at(hit, Status::crossing, "runs along", true);
            }
            doubled_[hit.a] = doubled_[hit.b] = true;
        }
    }
}

// Because of rounding, overlaps cannot be told from curves that touch. What is undecided along a large share
// of a curve counts as an overlap.
bool Crossings::runs_along(const LoopHit &hit) const {
    constexpr double most_of_touch = 0x1p-6;
    if (hit.kind != HitKind::overlap && hit.kind != HitKind::undecided) {
        return false;
    }
    const double length = extent(hit.a, hit.range_a);
    if (hit.kind == HitKind::overlap) {
        return length > near_;
    }
    const auto whole = [&](size_t curve) {
        return extent(curve, hits_.curves()[curve].spline->axis(0).domain());
    };
    return length > std::max(near_, most_of_touch * std::min(whole(hit.a), whole(hit.b))) && runs_beside(hit);
}

// Overlaps in opposite directions are allowed: those of a loop that runs along both sides of a cut or a seam,
// and those of two loops that bound a surface which is cut open around an axis.
bool Crossings::is_allowed(const LoopHit &hit) const {
    const LoopCurve &a = hits_.curves()[hit.a], &b = hits_.curves()[hit.b];
    return (a.loop == b.loop || (a.around && b.around)) && runs_against(hit);
}

bool Crossings::runs_against(const LoopHit &hit) const {
    const Interval range = hit.range_a;
    const auto ahead = [&](double share) {
        return foot(hit, range.lower + share * (range.upper - range.lower));
    };
    return ahead(0.375) > ahead(0.625);
}

// The extent in space of a range of a curve: the largest distance of samples from its start.
double Crossings::extent(size_t curve, Interval range) const {
    double most = 0;
    for (int i = 1; i <= range_samples; ++i) {
        const double t = range.lower + (range.upper - range.lower) * i / range_samples;
        most = std::max(most, gap(curve, range.lower, curve, t));
    }
    return most;
}

// The parameter on b, in its range, of the foot of a at t. Without the range, the foot of a curve on itself
// would be the place itself.
double Crossings::foot(const LoopHit &hit, double t) const {
    return hits_.foot(hit.b, place_beside(hit, t), hit.range_b);
}

// The place of a at t, in the copy of the plane in which b is stored.
Point2 Crossings::place_beside(const LoopHit &hit, double t) const {
    const Point2 x = hits_.place(hit.a, t);
    return {x[0] - hit.move[0], x[1] - hit.move[1]};
}

// Whether a is near b in all of the range. Rounding hides more along a touch than at a single place, so that
// this allows for more.
bool Crossings::runs_beside(const LoopHit &hit) const {
    const double most = std::max(near_, 0x1p-30 * covering_.extent());
    for (int i = 0; i <= range_samples; ++i) {
        const double share = static_cast<double>(i) / range_samples;
        const double t = hit.range_a.lower + share * (hit.range_a.upper - hit.range_a.lower);
        if (gap(hit.a, t, hit.b, foot(hit, t)) > most) {
            return false;
        }
    }
    return true;
}

bool Crossings::is_inner_crossing(const LoopHit &hit) const {
    const auto is_inner = [&](size_t curve, double at) {
        return !is_end(curve, at, false) && !is_end(curve, at, true);
    };
    return hit.kind == HitKind::crossing && is_inner(hit.a, hit.at_a) && is_inner(hit.b, hit.at_b);
}

// The distance in space of places on two curves.
double Crossings::gap(size_t a, double at_a, size_t b, double at_b) const {
    return gap_between(surface_, covering_, hits_.place(a, at_a), hits_.place(b, at_b));
}

// A curve that closes has both ends in one place; then the end with the nearer parameter counts.
bool Crossings::is_end(size_t curve, double at, bool upper) const {
    const Interval domain = hits_.curves()[curve].spline->axis(0).domain();
    const bool nearer = upper == (at - domain.lower > domain.upper - at);
    return nearer && gap(curve, upper ? domain.upper : domain.lower, curve, at) <= near_;
}

// Whether one of the curves continues the other one, in the same loop, at this hit.
bool Crossings::is_succession(const LoopHit &hit) const {
    const auto goes_on = [&](size_t a, double at_a, size_t b, double at_b) {
        return hits_.follows(a, b) && is_end(a, at_a, true) && is_end(b, at_b, false);
    };
    return gap(hit.a, hit.at_a, hit.b, hit.at_b) <= near_ &&
           (goes_on(hit.a, hit.at_a, hit.b, hit.at_b) || goes_on(hit.b, hit.at_b, hit.a, hit.at_a));
}

void Crossings::fail_at(const LoopHit &hit, Status status, const char *verb, bool range) const {
    const auto there = [&](size_t curve, double at, Interval part) {
        const std::string where =
            range ? std::string(" from ") + Number(part.lower).text + " to " + Number(part.upper).text
                  : std::string(" at ") + Number(at).text;
        return hits_.name(curve) + where;
    };
    fail(status, "%s %s %s", there(hit.a, hit.at_a, hit.range_a).c_str(), verb,
         there(hit.b, hit.at_b, hit.range_b).c_str());
}

// The hit to be reported for a place beside a loop: the nearest hit of that loop, with crossings away from
// the ends of curves before all others. If it has none, a crossing of other loops, which may have caused this
// one to be turned.
const LoopHit *Crossings::nearest(int loop, const Point2 &x) const {
    constexpr int worst = 3;
    const LoopHit *best = nullptr;
    auto least = std::pair(worst, 0.0);
    for (const LoopHit &hit : hits_.all()) {
        const bool of_loop = hits_.curves()[hit.a].loop == loop || hits_.curves()[hit.b].loop == loop;
        const bool inner = is_inner_crossing(hit);
        const int rank = is_succession(hit) || (!of_loop && !inner) ? worst : !of_loop ? 2 : inner ? 0 : 1;
        const auto [u, v] = covering_.in_domain(hits_.place(hit.a, hit.at_a));
        const double away = std::hypot((u - x[0]) / covering_.period(0), (v - x[1]) / covering_.period(1));
        if (std::pair(rank, away) < least) {
            least = {rank, away};
            best = &hit;
        }
    }
    return best;
}

void Crossings::check_hits() const {
    for (const LoopHit &hit : hits_.all()) {
        if (is_inner_crossing(hit)) {
            fail_at(hit, Status::crossing, "crosses");
        }
    }
}

// Across curves that run along each other, as along both sides of a seam or a cut, the value does not change.
// So a curve that crosses both does not show in the values beside it.
void Crossings::check_doubled() const {
    for (const LoopHit &hit : hits_.all()) {
        const LoopHit turned{hit.b,       hit.a,       hit.at_b, hit.at_a,
                             hit.range_b, hit.range_a, hit.kind, {-hit.move[0], -hit.move[1]},
                             hit.against};
        if (is_inner_crossing(hit) &&
            ((doubled_[hit.b] && goes_through(hit)) || (doubled_[hit.a] && goes_through(turned)))) {
            fail_at(hit, Status::crossing, "crosses");
        }
    }
}

// Whether a is on both sides of b, at distances above twice the tolerance.
bool Crossings::goes_through(const LoopHit &hit) const {
    constexpr int both_ways = 4 * range_samples;
    const Interval domain = hits_.curves()[hit.a].spline->axis(0).domain();
    bool left = false, right = false;
    for (int i = 0; i <= both_ways; ++i) {
        const double t = domain.lower + (domain.upper - domain.lower) * i / both_ways;
        const Point2 x = place_beside(hit, t);
        const double under = hits_.foot(hit.b, x, hits_.curves()[hit.b].spline->axis(0).domain());
        if (gap(hit.a, t, hit.b, under) > 2 * near_) {
            const double side = hits_.side(hit.b, under, x);
            left = left || side > 0;
            right = right || side < 0;
        }
    }
    return left && right;
}

void Crossings::check(const TrimMap &trims) const {
    BesideLoops beside(surface_, covering_, trims, near_);
    for (const LoopHit &hit : hits_.all()) {
        if (is_succession(hit)) {
            continue;
        }
        for (const double t : {hit.range_a.lower, hit.at_a, hit.range_a.upper}) {
            beside.cut(hits_.place(hit.a, t));
        }
        for (const double t : {hit.range_b.lower, hit.at_b, hit.range_b.upper}) {
            beside.cut(hits_.place(hit.b, t));
        }
    }
    if (const std::optional<BesideLoops::Astray> astray = beside.astray()) {
        if (const LoopHit *hit = nearest(astray->loop, astray->at)) {
            fail_at(*hit, Status::crossing, "crosses");
        }
        fail(Status::orientation, "loop %d has its left side where other loops have their right side",
             astray->loop);
    }
    check_doubled();
    for (const LoopHit &hit : hits_.all()) {
        if (hit.kind == HitKind::undecided && !is_succession(hit) && !runs_beside(hit)) {
            fail_at(hit, Status::not_converged, "comes undecidably near");
        }
    }
}

} // namespace nrb::face
