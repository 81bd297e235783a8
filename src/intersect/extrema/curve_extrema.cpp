// SPDX-License-Identifier: MIT
#include "intersect/extrema/curve_extrema.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/extrema/slope_function.h"
#include "intersect/level_signs.h"
#include "refine/periodic/seam.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::intersect {

namespace {

using namespace extremum_kind;

// What bounds a part of a curve: an end of the curve, a jump up or down, or a jump hidden by rounding.
enum class Wall { none, up, down, hidden };

// The sign of the slope that a jump amounts to; 0 for an end, and where rounding hides it.
int sign_of(Wall wall) noexcept {
    return wall == Wall::up ? 1 : wall == Wall::down ? -1 : 0;
}

struct PartOfCurve {
    Interval range;
    Wall before, after;
    bool closed; // a whole periodic curve without jumps
};

// Extrema of a part of a curve between jumps.
class PartExtrema {
public:
    PartExtrema(const Spline &curve, const PartOfCurve &part)
        : f_(curve, part.range, part.closed), before_(part.before), after_(part.after),
          signs_(level_signs(f_, 0)), ended_(work_ended()) {}

    void add_to(std::vector<Extremum> &list) {
        for (const ZeroRange &zero : signs_.zeros) {
            add(zero);
        }
        for (const SignJump &jump : signs_.jumps) {
            put(jump.at, {jump.at, jump.at}, turn_of(jump.before, -jump.before));
        }
        for (const Interval &range : signs_.unknown) {
            put(range.lower / 2 + range.upper / 2, range, undecided);
        }
        if (!f_.periodic()) {
            add_end(f_.domain().lower, before_, signs_.first, true);
            add_end(f_.domain().upper, after_, signs_.last, false);
        }
        list.insert(list.end(), found_.begin(), found_.end());
    }

private:
    // An extremum at an end of the part, if the sign inside is known right up to there.
    void add_end(double at, Wall wall, int inside, bool start) {
        if (inside == 0) {
            return;
        }
        const int outside = wall == Wall::none ? -inside : sign_of(wall);
        const uint32_t turn = start ? turn_of(outside, inside) : turn_of(inside, outside);
        if (wall == Wall::hidden) {
            put(at, {at, at}, undecided);
        } else if (turn != saddle) {
            put(at, {at, at}, turn);
        }
    }

    void add(const ZeroRange &zero) {
        const bool starts = !f_.periodic() && zero.range.lower == f_.domain().lower,
                   ends = !f_.periodic() && zero.range.upper == f_.domain().upper;
        const Wall left = starts ? before_ : Wall::hidden, right = ends ? after_ : Wall::hidden;
        int before = zero.before != 0 ? zero.before : sign_of(left),
            after = zero.after != 0 ? zero.after : sign_of(right);
        const std::optional<Interval> level = zero.whole ? constant_range(zero.range) : std::nullopt;
        const bool is_all =
            same(zero.range, f_.domain()) && (f_.periodic() || (left == right && left == Wall::none));
        if (level && is_all) {
            return put_middle(*level, plateau);
        }
        before = before == 0 && left == Wall::none ? -after : before;
        after = after == 0 && right == Wall::none ? -before : after;
        const uint32_t turn = before == 0 || after == 0 ? undecided : turn_of(before, after);
        if (zero.whole) {
            return level ? put_middle(*level, plateau | turn) : put_middle(zero.range, undecided);
        }
        const bool sure = zero.exact || zero.simple || (turn != saddle && !ended_);
        const double at = zero.inside ? zero.range.lower / 2 + zero.range.upper / 2 : zero.at;
        put(at, zero.range, sure ? turn : undecided);
    }

    // The whole range, if the control points show that all of its pieces are constant.
    [[nodiscard]] std::optional<Interval> constant_range(Interval range) const {
        double known = range.lower;
        for (const double shift : {0.0, f_.period()}) {
            for (int64_t e = f_.first_to(known - shift); e < f_.count() && known < range.upper; ++e) {
                const Interval part = f_.part(e);
                if (part.upper + shift <= known) {
                    continue;
                }
                if (!f_.is_constant(e)) {
                    return std::nullopt;
                }
                known = part.upper + shift;
            }
            if (!f_.periodic()) {
                break;
            }
        }
        return known == range.upper ? std::optional(range) : std::nullopt;
    }

    void put_middle(Interval range, uint32_t kinds) { put(range.lower / 2 + range.upper / 2, range, kinds); }
    void put(double at, Interval range, uint32_t kinds) {
        const double end = f_.domain().upper;
        const bool beyond = f_.periodic() && at >= end;
        const double inside = std::min(beyond ? f_.domain().lower + (at - end) : at, end);
        found_.push_back({{inside}, {range}, f_.value(inside), kinds});
    }

    SlopeFunction f_;
    Wall before_, after_;
    LevelSigns signs_;
    bool ended_; // at the limit of work: ranges also hold what was not looked at
    std::vector<Extremum> found_;
};

// The jump between the limits at a knot, given by their control points; none if they are equal.
Wall wall_between(const Spline &curve, int64_t left, int64_t right) noexcept {
    const double a = curve.coordinate(left, 0), b = curve.coordinate(right, 0);
    const double known = curve.form() == Form::homogeneous ? 2 * eps * std::max(std::abs(a), std::abs(b)) : 0;
    if (std::abs(b - a) <= known) {
        return known > 0 ? Wall::hidden : Wall::none;
    }
    return a < b ? Wall::up : Wall::down;
}

struct CurveJump {
    double at;
    Wall wall;
};

std::vector<CurveJump> jumps_inside(const Spline &curve) {
    const KnotVector &axis = curve.axis(0);
    const Interval domain = axis.domain();
    std::vector<CurveJump> jumps;
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (group.multiplicity > axis.degree() && group.knot > domain.lower && group.knot < domain.upper) {
            const int64_t first = axis.find_span(group.knot, false) - axis.degree();
            const Wall wall = wall_between(curve, first - 1, first);
            if (wall != Wall::none) {
                jumps.push_back({group.knot, wall});
            }
        }
    }
    return jumps;
}

// The jump at the seam of a periodic curve.
Wall wall_at_seam(const Spline &curve) noexcept {
    const KnotVector &axis = curve.axis(0);
    const Interval domain = axis.domain();
    if (multiplicity(axis.knots(), domain.lower) <= axis.degree()) {
        return Wall::none;
    }
    return wall_between(curve, axis.find_span(domain.upper, true),
                        axis.find_span(domain.lower, false) - axis.degree());
}

// The extrema of the parts between jumps. ends: the wall at both ends of the domain.
Extrema extrema_between(const Spline &curve, const std::vector<CurveJump> &jumps, Wall ends) {
    const Interval domain = curve.axis(0).domain();
    const bool closed = curve.axis(0).periodic() && jumps.empty() && ends == Wall::none;
    Extrema result;
    CurveJump last{domain.lower, ends};
    Steps steps(std::ssize(jumps) + 1);
    for (size_t i = 0; i <= jumps.size(); ++i, steps.next()) {
        const CurveJump next = i < jumps.size() ? jumps[i] : CurveJump{domain.upper, ends};
        PartExtrema(curve, {{last.at, next.at}, last.wall, next.wall, closed}).add_to(result.list);
        last = next;
    }
    return result;
}

// For a periodic curve: moves what is at the upper end of the domain, or beyond it, down by a period.
void move_to_domain(std::vector<Extremum> &list, Interval domain) {
    const double period = domain.upper - domain.lower;
    const auto moved = [=](double at) { return at == domain.upper ? domain.lower : at - period; };
    for (Extremum &x : list) {
        if (x.at[0] >= domain.upper) {
            x.at[0] = std::clamp(moved(x.at[0]), domain.lower, domain.upper);
            x.range[0] = {moved(x.range[0].lower), moved(x.range[0].upper)};
        }
    }
}

// Null if rounding makes that impossible.
SplinePtr moved_seam(const SplinePtr &curve, double seam) {
    try {
        return refine::move_seam(curve, 0, seam);
    } catch (const Error &error) {
        if (error.status() != Status::periodic_knots) {
            throw;
        }
        return nullptr;
    }
}

} // namespace

Extrema curve_extrema(const SplinePtr &curve) {
    const std::vector<CurveJump> jumps = jumps_inside(*curve);
    const bool periodic = curve->axis(0).periodic();
    const Wall seam = periodic ? wall_at_seam(*curve) : Wall::none;
    const bool inside = periodic && seam == Wall::none && !jumps.empty();
    const SplinePtr moved = inside ? moved_seam(curve, jumps.front().at) : nullptr;
    Extrema result =
        moved ? curve_extrema(moved) : extrema_between(*curve, jumps, inside ? Wall::hidden : seam);
    if (periodic) {
        move_to_domain(result.list, curve->axis(0).domain());
    }
    std::ranges::stable_sort(result.list, {}, [](const Extremum &x) { return x.at[0]; });
    return result;
}

} // namespace nrb::intersect
