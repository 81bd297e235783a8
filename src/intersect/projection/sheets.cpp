// SPDX-License-Identifier: MIT
#include "intersect/projection/sheets.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "intersect/extrema/curve_extrema.h"
#include "intersect/pairs/periods.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

namespace nrb::intersect {

namespace {

using Vector2 = std::array<double, 2>;

Vector2 end_of(const Spline &curve, bool upper) {
    Vector2 at{};
    eval::end_point(curve, upper, at.data());
    return at;
}

Vector2 place_in_domain(const Spline &surface, const Vector2 &at) noexcept {
    return {in_domain(surface.axis(0), at[0]), in_domain(surface.axis(1), at[1])};
}

// The first coordinate of a polynomial curve in the plane.
SplinePtr first_coordinate(const Spline &curve) {
    std::vector<double> values;
    for (int64_t i = 0; i < curve.count(0); ++i) {
        values.push_back(curve.coordinate(i, 0));
    }
    return make_result(curve.knot_vectors(), 1, Form::polynomial, std::move(values));
}

// A parameter of a curve, and the value of a function there.
struct Stop {
    double at, value;
};

// The local extrema of a function by which it changes direction significantly (turns_of()). before, after:
// its direction at both ends, 1 or -1; 0 if no change is significant.
struct Turns {
    std::vector<double> at;
    int before = 0, after = 0;
};

template <class Counts>
Turns turns_of(std::span<const Stop> stops, Counts &&counts) {
    Turns turns;
    Stop high = stops.front(), low = stops.front();
    for (const Stop &stop : stops) {
        high = turns.after >= 0 && stop.value > high.value ? stop : high;
        low = turns.after <= 0 && stop.value < low.value ? stop : low;
        for (const int way : {1, -1}) {
            const Stop extreme = way > 0 ? high : low;
            if (turns.after == -way || extreme.value == stop.value || !counts(extreme.value, stop.value)) {
                continue;
            }
            if (turns.after != 0) {
                turns.at.push_back(extreme.at);
            }
            turns.before = turns.before == 0 ? -way : turns.before;
            turns.after = -way;
            high = low = stop;
            break;
        }
    }
    return turns;
}

class Sheets {
public:
    Sheets(Meet meet, const ProjectedCurve &projected) : meet_(std::move(meet)), projected_(projected) {}

    Meet run() {
        std::vector<MeetBranch> branches = std::exchange(meet_.branches, {});
        Steps steps(std::ssize(branches));
        for (MeetBranch &branch : branches) {
            add(std::move(branch));
            steps.next();
        }
        turn_at_seams();
        for (MeetBranch &branch : meet_.branches) {
            branch.loop = turned_loops_.contains(branch.loop) ? -1 : branch.loop;
        }
        return std::move(meet_);
    }

private:
    void add(MeetBranch branch) {
        const Turns turns = turns_along(branch);
        if (turns.at.empty() && !(branch.nodes[0] < 0 && turns.before * turns.after < 0)) {
            add_sheet(std::move(branch));
            return;
        }
        turned_loops_.insert(branch.loop);
        branch.nodes[0] < 0 ? add_closed(branch, turns) : add_parts(branch, turns.at);
    }

    // A seam at which both branches end, or both begin, is a turn of t: it becomes a fold.
    void turn_at_seams() {
        std::vector<int> ends(meet_.nodes.size(), -1);
        for (const MeetBranch &branch : meet_.branches) {
            for (size_t end = 0; end < 2 && branch.nodes[end] >= 0; ++end) {
                ends[static_cast<size_t>(branch.nodes[end])] = static_cast<int>(end);
            }
        }
        for (const MeetBranch &branch : meet_.branches) {
            for (size_t end = 0; end < 2 && branch.nodes[end] >= 0; ++end) {
                MeetNode &node = meet_.nodes[static_cast<size_t>(branch.nodes[end])];
                if (node.kind == NodeKind::seam && node.next >= 0 &&
                    ends[static_cast<size_t>(node.next)] == static_cast<int>(end)) {
                    node.kind = NodeKind::fold;
                    turned_loops_.insert(branch.loop);
                }
            }
        }
    }

    // The turns of t along a branch.
    Turns turns_along(const MeetBranch &branch) const {
        const SplinePtr t = first_coordinate(*branch.on_second);
        const Interval domain = t->axis(0).domain();
        std::vector<Stop> stops{{domain.lower, end_of(*branch.on_second, false)[0]}};
        for (const Extremum &x : curve_extrema(t).list) {
            stops.push_back({x.at[0], x.value});
        }
        stops.push_back({domain.upper, end_of(*branch.on_second, true)[0]});
        return turns_of(std::span<const Stop>(stops),
                        [&](double a, double b) { return length_across(a, b) > 4 * branch.deviation; });
    }
    // How far the curve goes across the direction between two parameters, estimated from four points.
    double length_across(double a, double b) const {
        const Vector3 start = point_at(a);
        double far = 0;
        for (const double part : {0.25, 0.5, 0.75, 1.0}) {
            const Vector3 way = point_at(a + part * (b - a)) - start;
            far = std::max(far, length(way - dot(way, projected_.direction) * projected_.direction));
        }
        return far;
    }
    Vector3 point_at(double t) const {
        return point_of(projected_.lines, {t, projected_.lines.axis(1).domain().lower});
    }
    static Vector3 point_of(const Spline &surface, const Vector2 &at) {
        const Vector2 inside = place_in_domain(surface, at);
        std::array<double, 3> x{};
        eval::evaluate_points(surface, {}, 0, {inside.data(), 1, 2, 2, 1}, {x.data(), 1, 3, 3, 1});
        count_work(200);
        return {x[0], x[1], x[2]};
    }

    static MeetBranch part_of(const MeetBranch &branch, double lower, double upper) {
        MeetBranch part = branch;
        for (SplinePtr *curve : {&part.space, &part.on, &part.on_second}) {
            *curve = refine::restrict_axis(*curve, 0, lower, upper);
        }
        return part;
    }
    // Adds the parts of a branch between its ends and its turns.
    void add_parts(const MeetBranch &branch, const std::vector<double> &turns) {
        const Interval domain = branch.on->axis(0).domain();
        std::vector<double> breaks{domain.lower};
        breaks.insert(breaks.end(), turns.begin(), turns.end());
        breaks.push_back(domain.upper);
        int64_t begun = branch.nodes[0];
        for (size_t i = 0; i + 1 < breaks.size(); ++i) {
            MeetBranch part = part_of(branch, breaks[i], breaks[i + 1]);
            part.nodes = {begun, branch.nodes[1]};
            if (i + 2 < breaks.size()) {
                part.nodes[1] = add_fold(part);
                begun = part.nodes[1] + 1;
            }
            add_sheet(std::move(part));
        }
    }
    // Moves the beginning of a closed branch to a turn, unless it is at one already.
    void add_closed(const MeetBranch &branch, const Turns &turns) {
        MeetBranch opened = branch;
        std::vector<double> at = turns.at;
        if (turns.before == turns.after && !at.empty()) {
            const Interval domain = branch.on->axis(0).domain();
            const double first = at.front();
            opened = joined(part_of(branch, first, domain.upper), part_of(branch, domain.lower, first));
            at.erase(at.begin()); // parameters of the others do not change
        }
        const int64_t fold = add_fold(opened);
        opened.nodes = {fold + 1, fold};
        add_parts(opened, at);
    }
    // The first part continued by the second one, which begins where it ends, shifted by whole periods where
    // needed.
    MeetBranch joined(MeetBranch first, const MeetBranch &second) const {
        const double gap = std::max(gap_on(projected_.surface, *first.on, *second.on),
                                    gap_on(projected_.lines, *first.on_second, *second.on_second));
        first.deviation += 2 * gap;
        first.space = joined_curve(*first.space, *second.space, nullptr);
        first.on = joined_curve(*first.on, *second.on, &projected_.surface);
        first.on_second = joined_curve(*first.on_second, *second.on_second, &projected_.lines);
        return first;
    }
    static double gap_on(const Spline &surface, const Spline &first, const Spline &second) {
        const Vector3 a = point_of(surface, end_of(first, true)),
                      b = point_of(surface, end_of(second, false));
        return length(a - b);
    }
    // Joins two clamped cubics. on: the surface whose domain they are in; null for curves in space.
    static SplinePtr joined_curve(const Spline &a, const Spline &b, const Spline *on) {
        std::vector<double> knots(a.axis(0).knots().begin(), a.axis(0).knots().end() - 1);
        const double start = knots.back(), lower = b.axis(0).domain().lower;
        const std::span<const double> others = b.axis(0).knots();
        for (size_t i = 4; i < others.size(); ++i) {
            const double least =
                others[i] > others[i - 1] ? std::nextafter(knots.back(), infinity) : knots.back();
            knots.push_back(std::max(start + (others[i] - lower), least));
        }
        std::vector<double> points(a.points().begin(), a.points().end());
        const size_t dim = static_cast<size_t>(a.dim()), last = points.size() - dim;
        for (size_t i = dim; i < b.points().size(); ++i) {
            const double shift = on == nullptr ? 0
                                               : shift_between(on->axis(static_cast<int>(i % dim)),
                                                               points[last + i % dim], b.points()[i % dim]);
            points.push_back(b.points()[i] + shift);
        }
        return make_result({make_knot_vector(3, std::move(knots))}, a.dim(), Form::polynomial,
                           std::move(points));
    }
    // The shift by whole periods that brings `to` next to `from`.
    static double shift_between(const KnotVector &axis, double from, double to) noexcept {
        const double period = period_of(axis);
        return period > 0 ? period * std::round((from - to) / period) : 0;
    }

    // Adds two fold nodes where a part ends: the first for its end, the second, which follows it, for the
    // beginning of the next part. Returns the first.
    int64_t add_fold(const MeetBranch &part) {
        const int64_t first = std::ssize(meet_.nodes);
        MeetNode node{
            part.level, NodeKind::fold, place_in_domain(projected_.surface, end_of(*part.on, true)), {}};
        node.at_second = place_in_domain(projected_.lines, end_of(*part.on_second, true));
        for (size_t k = 0; k < 2; ++k) {
            node.range[k] = {node.at[k], node.at[k]};
            node.range_second[k] = {node.at_second[k], node.at_second[k]};
        }
        for (const int64_t next : {first + 1, first}) {
            node.next = next;
            meet_.nodes.push_back(node);
        }
        return first;
    }

    void add_sheet(MeetBranch sheet) {
        if (end_of(*sheet.on_second, true)[0] < end_of(*sheet.on_second, false)[0]) {
            for (SplinePtr *curve : {&sheet.space, &sheet.on, &sheet.on_second}) {
                *curve = refine::reverse(**curve, 0, false);
            }
            std::swap(sheet.nodes[0], sheet.nodes[1]);
        }
        meet_.branches.push_back(std::move(sheet));
    }

    Meet meet_;
    const ProjectedCurve &projected_;
    std::set<int64_t> turned_loops_{-1};
};

} // namespace

Meet cut_in_sheets(Meet meet, const ProjectedCurve &projected) {
    return Sheets(std::move(meet), projected).run();
}

} // namespace nrb::intersect
