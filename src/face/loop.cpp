// SPDX-License-Identifier: MIT
#include "face/loop.h"

#include "build/polylines.h"
#include "eval/curve_point.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

Point2 point_of(const Spline &curve, double t) {
    Point2 x;
    eval::curve_point(curve, t, false, x.data());
    return x;
}

Point2 end_of(const Spline &curve, bool upper) {
    Point2 x;
    eval::end_point(curve, upper, x.data());
    return x;
}

// Where a loop that arrives at a pole at `from` leaves it. Along the upper end of axis 1 the inside is to the
// left of a curve that runs towards lower values of axis 0, and so on around the domain.
Point2 around_pole(const Covering &covering, Covering::Pole pole, const Point2 &from, Point2 next) {
    const int along = 1 - pole.axis;
    if (!covering.closed(along)) {
        return next;
    }
    const auto at = static_cast<size_t>(along);
    const bool down = (pole.axis == 1) == (pole.end == 1);
    const double period = covering.period(along);
    const double ahead = down ? from[at] - next[at] : next[at] - from[at];
    const double turns = std::ceil(ahead / period) - 1; // the remaining way is in (0, period]
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

// Where a curve of a loop begins and ends, and the poles at which it does. A curve that lies in a pole has
// none at its ends, because it leads along the pole itself.
struct CurveEnds {
    Point2 start, end;
    Covering::Pole first, last;
};

CurveEnds ends_of(const Spline &surface, const Covering &covering, const Spline &curve, double tolerance) {
    CurveEnds ends{end_of(curve, false), end_of(curve, true), {}, {}};
    if (covering.has_poles()) {
        const Interval domain = curve.axis(0).domain();
        const Covering::Pole middle =
            pole_at(surface, covering, point_of(curve, domain.lower / 2 + domain.upper / 2), tolerance);
        if (middle.axis < 0) {
            ends.first = pole_at(surface, covering, ends.start, tolerance);
            ends.last = pole_at(surface, covering, ends.end, tolerance);
        }
    }
    return ends;
}

// Where the curve after one that ended at `last` begins: in the nearest copy, or if both ends are at the same
// pole, after going around it.
Point2 next_begin(const Covering &covering, const Point2 &last, Covering::Pole before, const Point2 &start,
                  Covering::Pole behind) {
    const Point2 begin = covering.nearest_copy(start, last);
    const bool pole = before.axis >= 0 && before.axis == behind.axis && before.end == behind.end;
    return pole ? around_pole(covering, before, last, begin) : begin;
}

} // namespace

PlacedLoop placed(const Spline &surface, const Covering &covering, const Loop &loop, double tolerance) {
    PlacedLoop result;
    Point2 last{}, start{};
    Covering::Pole before, first;
    for (const Coedge &coedge : loop) {
        const CurveEnds ends = ends_of(surface, covering, *coedge.curve, tolerance);
        Point2 begin = ends.start;
        if (result.curves.empty()) {
            start = begin;
            first = ends.first;
        } else {
            begin = next_begin(covering, last, before, ends.start, ends.first);
        }
        const Point2 shift{begin[0] - ends.start[0], begin[1] - ends.start[1]};
        result.curves.push_back({coedge.curve, shift});
        last = {ends.end[0] + shift[0], ends.end[1] + shift[1]};
        before = ends.last;
    }
    const Point2 back = next_begin(covering, last, before, start, first);
    for (size_t k = 0; k < 2; ++k) {
        const double period = covering.period(static_cast<int>(k));
        result.turn[k] =
            covering.closed(static_cast<int>(k)) ? std::round((back[k] - start[k]) / period) * period : 0;
    }
    return result;
}

double largest_gap(const Spline &surface, const Covering &covering, const Loop &loop) {
    double largest = 0;
    for (size_t i = 0; i < loop.size(); ++i) {
        const Point2 end = end_of(*loop[i].curve, true),
                     start = end_of(*loop[(i + 1) % loop.size()].curve, false);
        largest = std::max(largest, end == start ? 0 : gap_between(surface, covering, end, start));
    }
    return largest * (1 + 0x1p-20);
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
        Coedge &made = result.back();
        made.curve = refine::reverse(*coedge->curve, 0, false);
        if (made.key != 0) {
            made.against = !made.against;
        } else if (made.edge != nullptr) { // nothing else would say that it runs against the loop
            made.edge = refine::reverse(*made.edge, 0, false);
        }
    }
    return result;
}

} // namespace nrb::face
