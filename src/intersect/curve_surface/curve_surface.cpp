// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/curve_surface.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "intersect/curve_surface/meet_search.h"
#include "intersect/curve_surface/overlaps.h"
#include "intersect/curve_surface/surface_sides.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace nrb::intersect {

namespace {

using Kind = MeetCell::Kind;
using Cells = std::vector<MeetCell>;

// Finds the hits of a curve and a surface.
class SurfaceMeeting {
public:
    SurfaceMeeting(const Spline &curve, const Spline &surface, double tolerance)
        : curve_(curve), surface_(surface), tolerance_(tolerance), seams_(curve, surface),
          search_(curve, surface, seams_) {}

    SurfaceHits run() {
        MeetCells found = search_.find(tolerance_);
        noise_ = search_.noise();
        result_.complete = found.complete;
        const Cells cells = without_unknown(std::move(found.list));
        if (tolerance_ <= noise_) {
            add_exact(cells);
        } else {
            for (const MeetGroup &group : groups_of(cells, seams_)) {
                add_near(group, cells);
            }
        }
        std::ranges::sort(result_.list, {},
                          [](const SurfaceHit &hit) { return std::tuple(hit.at, hit.range[0].lower); });
        return std::move(result_);
    }

private:
    // Reports the unknown cells as hits of their own and returns the others. Unknown cells overlap each
    // other, so those that adjoin along the curve are merged into one hit.
    Cells without_unknown(Cells cells) {
        std::vector<MeetBox> unknown;
        for (const MeetCell &cell : cells) {
            if (cell.kind == Kind::unknown) {
                unknown.push_back(cell.box);
            }
        }
        std::erase_if(cells, [](const MeetCell &cell) { return cell.kind == Kind::unknown; });
        std::ranges::sort(unknown, {}, [](const MeetBox &box) { return box[0].lower; });
        for (auto first = unknown.begin(); first != unknown.end();) {
            MeetBox all = *first;
            for (; first != unknown.end() && (*first)[0].lower <= all[0].upper; ++first) {
                for (size_t k = 0; k < 3; ++k) {
                    all[k] = {std::min(all[k].lower, (*first)[k].lower),
                              std::max(all[k].upper, (*first)[k].upper)};
                }
            }
            add_undecided(all);
        }
        return cells;
    }
    void add_undecided(const MeetBox &box) {
        SurfaceHit hit{{}, {}, HitKind::undecided};
        for (size_t k = 0; k < 3; ++k) {
            hit.at[k] = box[k].lower / 2 + box[k].upper / 2;
        }
        place(hit, box);
        result_.complete = false;
    }

    // For connected parts within the tolerance. What is no overlap is searched once more, without the
    // tolerance.
    void add_near(const MeetGroup &group, const Cells &cells) {
        if (group.is_still()) {
            add(group, group.nearest().gap <= tolerance_ ? HitKind::overlap : HitKind::undecided);
            return;
        }
        const std::vector<bool> taken = add_overlaps(group);
        Cells exact, open;
        std::vector<size_t> rest;
        for (size_t i = 0; i < group.cells.size(); ++i) {
            const MeetCell &cell = group.cells[i];
            if (taken[i]) {
                continue;
            }
            rest.push_back(i);
            const bool is_chart = cell.kind == Kind::meets || cell.kind == Kind::touches;
            if (cell.meetable) {
                (is_chart ? exact : open).push_back(cells[cell.index]);
            }
        }
        const MeetCells finer = search_.refine(std::exchange(open, {}));
        result_.complete = result_.complete && finer.complete;
        exact.insert(exact.end(), finer.list.begin(), finer.list.end());
        const bool any = add_exact(without_unknown(std::move(exact)));
        if (!any && !rest.empty() && std::ranges::find(taken, true) == taken.end() && finer.complete) {
            add_contact(group, rest);
        }
    }

    void add_contact(const MeetGroup &group, std::span<const size_t> cells) {
        MeetGroup part;
        std::ranges::transform(cells, std::back_inserter(part.cells),
                               [&](size_t i) { return group.cells[i]; });
        part.fit();
        add(part, part.nearest().gap <= tolerance_ + noise_ ? HitKind::contact : HitKind::undecided);
    }

    // Reports the overlaps. Returns which cells they, and what adjoins them, consist of; proven intersections
    // are reported by themselves.
    std::vector<bool> add_overlaps(const MeetGroup &group) {
        std::vector<bool> taken(group.cells.size(), false);
        std::vector<size_t> front;
        for (const SurfaceOverlap &overlap : overlaps_of(group, seams_)) {
            for (const size_t i : overlap.cells) {
                taken[i] = true;
                front.push_back(i);
            }
            add(group, overlap);
        }
        take_hanging(group, std::move(front), taken);
        return taken;
    }
    // Takes short cells that are connected to the front. Cells are in the order in which they begin on the
    // curve.
    void take_hanging(const MeetGroup &group, std::vector<size_t> front, std::vector<bool> &taken) const {
        const std::vector<MeetCell> &cells = group.cells;
        std::vector<size_t> others;
        double longest = 0;
        for (size_t i = 0; i < cells.size() && !front.empty(); ++i) {
            if (!taken[i] && hangs(cells[i])) {
                others.push_back(i);
                longest = std::max(longest, cells[i].box[0].upper - cells[i].box[0].lower);
            }
        }
        const auto start = [&cells](size_t i) { return cells[i].box[0].lower; };
        while (!front.empty() && !others.empty()) {
            const MeetCell &from = cells[front.back()];
            front.pop_back();
            const double before = std::nextafter(from.box[0].lower - longest, -infinity);
            const auto first = std::ranges::lower_bound(others, before, {}, start),
                       last = std::ranges::upper_bound(others, from.box[0].upper, {}, start);
            count_work(20 * (last - first));
            const auto rest = std::remove_if(first, last, [&](size_t i) {
                const bool touches = touch(from, cells[i]);
                if (touches) {
                    taken[i] = true;
                    front.push_back(i);
                }
                return touches;
            });
            others.erase(rest, last);
        }
    }
    // Short parts, which may adjoin an overlap's ends.
    [[nodiscard]] bool hangs(const MeetCell &cell) const {
        return cell.kind == Kind::tiny || cell.kind == Kind::touches ||
               (cell.kind == Kind::along && extent(cell.core[0]) <= 64 * tolerance_);
    }

    // Reports what is as near as rounding can tell. Returns whether there is anything.
    bool add_exact(const Cells &given) {
        Cells cells;
        bool any = false;
        for (const MeetCell &cell : given) {
            if (!cell.meetable) {
                continue;
            }
            any = true;
            if (cell.kind == Kind::meets) {
                result_.list.push_back({cell.at, cell.core, HitKind::crossing});
                continue;
            }
            cells.push_back(cell);
            if (cell.kind == Kind::touches) {
                cells.back().box = cell.core;
            }
        }
        for (const MeetGroup &group : groups_of(cells, seams_)) {
            add(group, kind_of(group));
        }
        return any;
    }

    [[nodiscard]] HitKind kind_of(const MeetGroup &group) const {
        const bool runs_beside = group.has(Kind::along) || group.has(Kind::tiny),
                   inside = !seams_.reach_end(group.box),
                   one_turn = std::ranges::all_of(group.cells, [&group](const MeetCell &cell) {
                       return cell.turn != 0 && cell.turn == group.cells.front().turn;
                   });
        const bool crosses = !runs_beside && one_turn && group.cells.size() > 1;
        const double reach = extent(group.box[0]);
        const bool is_long = runs_beside && reach > 0x1p-6 * search_.size(); // more than a touch
        if (inside && !is_long && (crosses || changes_side(curve_, surface_, seams_, group, reach, noise_))) {
            return HitKind::crossing;
        }
        if (tolerance_ == 0 && !hold_common_point(group, reach)) {
            return HitKind::undecided;
        }
        if (group.is_still()) {
            return HitKind::overlap;
        }
        if (is_long) {
            return HitKind::undecided; // and not an overlap
        }
        return runs_beside || (inside && !one_turn) ? HitKind::tangent : HitKind::crossing;
    }

    // Whether a control point of both is in a group, at the same point, and the group extends no farther than
    // rounding.
    [[nodiscard]] bool hold_common_point(const MeetGroup &group, double reach) const {
        return reach <= 512 * noise_ && std::ranges::any_of(group.cells, [this](const MeetCell &cell) {
                   return is_control_point(curve_.axis(0), 0, cell.at[0]) &&
                          is_control_point(surface_.axis(0), 1, cell.at[1]) &&
                          is_control_point(surface_.axis(1), 2, cell.at[2]) && share_point(cell.at);
               });
    }
    [[nodiscard]] bool is_control_point(const KnotVector &axis, size_t k, double t) const {
        return multiplicity(axis.knots(), seams_.in_domain(k, t)) >= axis.degree();
    }
    // Whether some limits of both, from one side or the other, are exactly the same point.
    [[nodiscard]] bool share_point(const MeetPlace &at) const {
        const double params[] = {seams_.in_domain(1, at[1]), seams_.in_domain(2, at[2])};
        for (int sides = 0; sides < 8; ++sides) {
            const std::vector<double> x =
                eval::curve_point(curve_, seams_.in_domain(0, at[0]), (sides & 1) != 0);
            std::vector<double> y(3);
            eval::AxisRules rules{};
            rules[0].left = (sides & 2) != 0;
            rules[1].left = (sides & 4) != 0;
            eval::evaluate_points(surface_, rules, 0, {params, 1, 2, 2, 1}, {y.data(), 1, 3, 3, 1});
            if (x == y) {
                return true;
            }
        }
        return false;
    }

    // How far the curve goes within a part.
    [[nodiscard]] double extent(Interval part) const {
        const std::vector<double> from = eval::curve_point(curve_, seams_.in_domain(0, part.lower), false);
        double most = 0;
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            const double at = seams_.in_domain(0, part.lower + share * (part.upper - part.lower));
            most = std::max(most, distance(from.data(), eval::curve_point(curve_, at, true).data(), 3));
        }
        return most;
    }

    void add(const MeetGroup &group, HitKind kind) {
        SurfaceHit hit{group.nearest().at, {}, kind};
        place(hit, group.box);
        result_.complete = result_.complete && kind != HitKind::undecided;
    }
    // At the place of the cell nearest to the middle of the overlap on the curve.
    void add(const MeetGroup &group, const SurfaceOverlap &overlap) {
        const double middle = overlap.box[0].lower / 2 + overlap.box[0].upper / 2;
        const auto apart = [&](size_t i) { return std::abs(group.cells[i].at[0] - middle); };
        SurfaceHit hit{
            group.cells[*std::ranges::min_element(overlap.cells, {}, apart)].at, {}, HitKind::overlap};
        place(hit, overlap.box);
    }
    void place(SurfaceHit &hit, const MeetBox &box) {
        for (size_t k = 0; k < 3; ++k) {
            hit.at[k] = seams_.in_domain(k, hit.at[k]);
            hit.range[k] = seams_.range(k, box[k]);
        }
        result_.list.push_back(hit);
    }

    const Spline &curve_, &surface_;
    double tolerance_, noise_ = 0;
    Seams seams_;
    MeetSearch search_;
    SurfaceHits result_;
};

} // namespace

SurfaceHits curve_surface(const Spline &curve, const Spline &surface, double tolerance) {
    check_dimension(curve, space_dim, space_dim, "curve");
    check_same_dimension(curve, surface);
    const UsualLimit usual(usual_work(curve.point_count() + surface.point_count()));
    const LimitedSearch limited;
    return SurfaceMeeting(curve, surface, tolerance).run();
}

} // namespace nrb::intersect
