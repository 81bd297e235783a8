// SPDX-License-Identifier: MIT
#include "face/loop.h"

#include "build/polylines.h"
#include "eval/evaluate.h"
#include "refine/forms/parametrization.h"

#include <algorithm>

namespace nrb::face {

namespace {

Point2 end_of(const Spline &curve, bool upper) {
    const Interval domain = curve.axis(0).domain();
    const double t = upper ? domain.upper : domain.lower;
    eval::AxisRules rules{};
    rules[0].left = upper;
    Point2 x;
    eval::evaluate_points(curve, rules, 0, {&t, 1, 1, 1, 1}, {x.data(), 1, 2, 2, 1});
    return x;
}

// Where a loop that came to a pole at `from` leaves it. Along the upper end of axis 1 the inside is to the left of those who run
// down axis 0, and so on around the domain.
Point2 around_pole(const Covering &covering, Covering::Pole pole, const Point2 &from, Point2 next) {
    const int along = 1 - pole.axis;
    if (!covering.closed(along)) {
        return next;
    }
    const auto at = static_cast<size_t>(along);
    const bool down = (pole.axis == 1) == (pole.end == 1);
    const double period = covering.period(along);
    const double ahead = down ? from[at] - next[at] : next[at] - from[at];
    const double turns = std::ceil(ahead / period) - 1; // what is left is in (0, period]
    next[at] += (down ? turns : -turns) * period;
    return next;
}

Covering::Pole pole_at(const Spline &surface, const Covering &covering, const Point2 &x, double tolerance) {
    if (!covering.has_poles()) {
        return {};
    }
    return covering.pole_near(point_at(surface, covering.in_domain(x)).data(), tolerance);
}

SplinePtr segment(const Point2 &a, const Point2 &b) {
    return build::polyline(2, {a[0], a[1], b[0], b[1]}, {0, 1});
}

} // namespace

std::vector<PlacedCurve> placed(const Spline &surface, const Covering &covering, const Loop &loop,
                                double tolerance) {
    std::vector<PlacedCurve> result;
    Point2 last{};
    for (const Coedge &coedge : loop) {
        const Point2 start = end_of(*coedge.curve, false), end = end_of(*coedge.curve, true);
        Point2 begin = start;
        if (!result.empty()) {
            begin = covering.nearest_copy(start, last);
            const Covering::Pole pole = pole_at(surface, covering, last, tolerance);
            const Covering::Pole same = pole_at(surface, covering, begin, tolerance);
            if (pole.axis >= 0 && pole.axis == same.axis && pole.end == same.end) {
                begin = around_pole(covering, pole, last, begin);
            }
        }
        const Point2 shift{begin[0] - start[0], begin[1] - start[1]};
        result.push_back({coedge.curve, shift});
        last = {end[0] + shift[0], end[1] + shift[1]};
    }
    return result;
}

std::vector<Loop> natural_loops(const Covering &covering) {
    const Interval u = covering.domain(0), v = covering.domain(1);
    struct Side {
        Point2 from, to;
        int axis, end;
    };
    const std::array<Side, 4> sides{{{{u.lower, v.lower}, {u.upper, v.lower}, 1, 0},
                                     {{u.upper, v.lower}, {u.upper, v.upper}, 0, 1},
                                     {{u.upper, v.upper}, {u.lower, v.upper}, 1, 1},
                                     {{u.lower, v.upper}, {u.lower, v.lower}, 0, 0}}};
    const bool around = covering.closed(0) || covering.closed(1);
    std::vector<Loop> result;
    for (const Side &side : sides) {
        if (covering.closed(side.axis) || covering.collapsed(side.axis, side.end)) {
            continue;
        }
        if (result.empty() || around) {
            result.emplace_back();
        }
        result.back().push_back({segment(side.from, side.to), nullptr});
    }
    return result;
}

Loop turned(const Loop &loop) {
    Loop result;
    for (auto coedge = loop.rbegin(); coedge != loop.rend(); ++coedge) {
        result.push_back(*coedge);
        result.back().curve = refine::reverse(*coedge->curve, 0, false);
        result.back().against = !coedge->against;
    }
    return result;
}

} // namespace nrb::face
