// SPDX-License-Identifier: MIT
#include "intersect/pairs/curve_curve.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "intersect/pairs/near_arcs.h"
#include "intersect/pairs/near_item.h"
#include "intersect/pairs/near_search.h"
#include "intersect/pairs/sides.h"
#include "intersect/pairs/strands.h"
#include "numeric/norm.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>

namespace nrb::intersect {

namespace {

using Kind = NearCell::Kind;
using Cells = std::vector<NearCell>;

// Finds the hits of two curves, or of a curve with itself.
class Meeting {
public:
    Meeting(const Spline &a, const Spline &b, double tolerance)
        : a_(a), b_(b), breaks_a_(a.axis(0)), breaks_b_(b.axis(0)), dim_(a.dim()), tolerance_(tolerance),
          search_(a, b) {}
    Meeting(const Spline &curve, double tolerance)
        : a_(curve), b_(curve), breaks_a_(curve.axis(0)), breaks_b_(curve.axis(0)), dim_(curve.dim()),
          tolerance_(tolerance), arcs_(curve), closes_(closes(curve)), search_(curve) {}

    PairHits run() {
        const NearCells found = search_.find(tolerance_);
        noise_ = search_.noise();
        result_.complete = found.complete;
        const Cells cells = without_unknown(found.list);
        if (tolerance_ <= noise_) {
            add_exact(cells);
        } else {
            for (const NearItem &near : items_of(cells)) {
                add_near(near, cells);
            }
        }
        std::ranges::sort(result_.list, {}, [](const PairHit &hit) {
            return std::tuple(hit.a, hit.b, hit.range_a.lower, hit.from_b);
        });
        return std::move(result_);
    }

private:
    [[nodiscard]] std::vector<NearItem> items_of(const Cells &cells) const {
        std::vector<NearItem> items;
        const std::vector<Link> links = links_of(a_, b_, cells);
        for (const NearGroup &group : groups_of(cells.size(), links, [](const Link &) { return true; })) {
            items.emplace_back(a_, b_, cells, group);
        }
        return items;
    }

    // Reports the unknown cells as hits of their own and returns the others. Unknown cells overlap each
    // other, so those that adjoin along the first curve are merged into one hit.
    Cells without_unknown(const Cells &cells) {
        Cells known, unknown;
        for (const NearCell &cell : cells) {
            (cell.kind == Kind::unknown ? unknown : known).push_back(cell);
        }
        std::ranges::sort(unknown, {}, [](const NearCell &cell) { return cell.a.lower; });
        for (auto first = unknown.begin(); first != unknown.end();) {
            Interval a = first->a, b = first->b;
            auto last = first;
            for (; last != unknown.end() && last->a.lower <= a.upper; ++last) {
                a.upper = std::max(a.upper, last->a.upper);
                b = {std::min(b.lower, last->b.lower), std::max(b.upper, last->b.upper)};
            }
            result_.list.push_back({a.lower / 2 + a.upper / 2, b.lower / 2 + b.upper / 2, a, b.lower, b.upper,
                                    HitKind::undecided});
            result_.complete = false;
            first = last;
        }
        return known;
    }

    // For connected parts within the tolerance. What is no overlap is searched once more, without the
    // tolerance.
    void add_near(const NearItem &near, const Cells &cells) {
        if (near.is_still()) {
            add(near, near.nearest().gap <= tolerance_ ? HitKind::overlap : HitKind::undecided);
            return;
        }
        const std::vector<bool> taken = add_overlaps(near);
        Cells exact, open;
        NearItem rest = near;
        rest.cells.clear();
        for (size_t i = 0; i < near.cells.size(); ++i) {
            const NearCell &cell = near.cells[i];
            if (taken[i] || is_one_place(cell)) {
                continue;
            }
            rest.cells.push_back(cell);
            const bool is_chart = cell.kind == Kind::meets || cell.kind == Kind::touches;
            if (cell.meetable) {
                (is_chart ? exact : open).push_back(cells[cell.index]);
            }
        }
        const NearCells finer = search_.refine(open);
        result_.complete = result_.complete && finer.complete;
        exact.insert(exact.end(), finer.list.begin(), finer.list.end());
        const bool any = add_exact(without_unknown(exact));
        if (!any && !rest.cells.empty() && std::ranges::find(taken, true) == taken.end() && finer.complete) {
            rest.fit();
            add(rest, rest.nearest().gap <= tolerance_ + noise_ ? HitKind::contact : HitKind::undecided);
        }
    }

    // For a curve with itself: parts that follow each other, and places that all of the curve between them is
    // near, for certain.
    [[nodiscard]] bool is_one_place(const NearCell &cell) const {
        return cell.kind == Kind::simple || cell.kind == Kind::fold ||
               (arcs_ && is_one_place(cell.at_a, cell.at_b));
    }
    [[nodiscard]] bool is_one_place(double s, double t) const {
        const Interval domain = a_.axis(0).domain();
        const std::vector<double> from = eval::curve_point(a_, in_domain(a_, s), false);
        const auto stays_near = [&](double start, double end) {
            return arcs_->hold({std::min(start, end), std::max(start, end)}, from,
                               2 * std::max(tolerance_, noise_));
        };
        const bool closed = closes_ && stays_near(domain.lower, s) && stays_near(t, domain.upper);
        return closed || stays_near(s, t);
    }

    // Reports the overlaps. Returns which cells they, and what adjoins them, consist of; proven intersections
    // are reported by themselves.
    std::vector<bool> add_overlaps(const NearItem &near) {
        std::vector<bool> taken(near.cells.size(), false);
        const std::vector<Link> links = links_of(a_, b_, near.cells);
        for (const Strand &strand : strands_of(a_, b_, near.cells, links)) {
            const NearCell &middle = near.cells[strand.cells[strand.cells.size() / 2]];
            const std::optional<Strand> overlap = overlap_of(breaks_a_, breaks_b_, strand);
            if (overlap && !is_one_place(middle)) {
                std::ranges::for_each(strand.cells, [&taken](size_t cell) { taken[cell] = true; });
                add(*overlap);
            }
        }
        const auto hangs = [&](size_t i) {
            const NearCell &cell = near.cells[i];
            constexpr double few = 256;
            const bool is_short = cell.kind == Kind::along &&
                                  cell.core_a.upper - cell.core_a.lower <= few * cell.reach_a &&
                                  std::abs(cell.core_b.upper - cell.core_b.lower) <= few * cell.reach_b;
            return taken[i] || is_short || cell.kind == Kind::tiny || cell.kind == Kind::touches ||
                   cell.kind == Kind::fold;
        };
        const auto joins = [&](const Link &link) { return hangs(link.from) && hangs(link.to); };
        for (const NearGroup &group : groups_of(near.cells.size(), links, joins)) {
            const bool all = std::ranges::any_of(
                group.members, [&](const NearGroup::Member &member) { return taken[member.cell]; });
            for (const NearGroup::Member &member : group.members) {
                taken[member.cell] = taken[member.cell] || all;
            }
        }
        return taken;
    }

    // Reports what is as near as rounding can tell. Returns whether there is anything.
    bool add_exact(const Cells &given) {
        Cells cells;
        bool any = false;
        for (const NearCell &cell : given) {
            if (!cell.meetable || (tolerance_ > 0 && is_one_place(cell))) {
                continue;
            }
            any = true;
            if (cell.kind == Kind::meets) {
                add_meet(cell);
                continue;
            }
            cells.push_back(cell);
            if (cell.kind == Kind::touches) {
                cells.back().a = cell.core_a;
                cells.back().b = cell.core_b;
            }
        }
        for (const NearItem &item : items_of(cells)) {
            const bool follows = std::ranges::all_of(
                item.cells, [](const NearCell &cell) { return cell.kind == Kind::simple; });
            if (!follows) {
                add(item, kind_of(item));
            }
        }
        return any;
    }

    [[nodiscard]] HitKind kind_of(const NearItem &item) const {
        if (item.has(Kind::fold) || item.has(Kind::simple)) {
            return HitKind::undecided; // there may be a loop that is hidden by rounding
        }
        const bool runs_beside = item.has(Kind::along) || item.has(Kind::tiny);
        const bool is_long = runs_beside && extent(item) > 0x1p-6 * search_.size(); // more than a touch
        const bool inside = !at_end(a_, item.a) && !at_end(b_, item.b);
        const bool one_turn = std::ranges::all_of(item.cells, [&item](const NearCell &cell) {
            return cell.turn != 0 && cell.turn == item.cells.front().turn;
        });
        const bool crosses = !runs_beside && one_turn && item.cells.size() > 1;
        // Along a long part the curves may cross more than once.
        if (dim_ == 2 && inside && !is_long && (crosses || changes_side(item))) {
            return HitKind::crossing;
        }
        if (tolerance_ == 0 && !holds_common_point(a_, b_, item, 64 * noise_)) {
            return HitKind::undecided;
        }
        if (item.is_still()) {
            return HitKind::overlap;
        }
        if (is_long) {
            return HitKind::undecided; // and not an overlap
        }
        return runs_beside || (dim_ == 2 && inside && !one_turn) ? HitKind::tangent : HitKind::crossing;
    }

    // How far a goes within the item.
    [[nodiscard]] double extent(const NearItem &item) const {
        const std::vector<double> from = eval::curve_point(a_, in_domain(a_, item.a.lower), false);
        double most = 0;
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            const double at = item.a.lower + share * (item.a.upper - item.a.lower);
            most = std::max(
                most, distance(from.data(), eval::curve_point(a_, in_domain(a_, at), true).data(), dim_));
        }
        return most;
    }

    // Whether a is on different sides of b before and after the item, beyond what rounding can tell.
    [[nodiscard]] bool changes_side(const NearItem &item) const {
        const Interval domain = a_.axis(0).domain();
        const double length = domain.upper - domain.lower, size = std::max(std::abs(item.a.lower), length);
        const double width = item.a.upper - item.a.lower;
        const double first = std::max(width / 16, 16 * eps * size),
                     most = std::min(std::max(16 * width, 0x1p-20 * length), length / 4);
        const auto last =
            std::ranges::max_element(item.cells, {}, [](const NearCell &x) { return x.a.upper; });
        const double reach = extent(item);
        const Way down{item.a.lower, item.cells.front().at_b, false, first, most, reach},
            up{item.a.upper, last->at_b, true, first, most, reach};
        return side_along(a_, b_, down, noise_) * side_along(a_, b_, up, noise_) < 0;
    }

    void add_meet(const NearCell &cell) {
        result_.list.push_back(
            {cell.at_a, cell.at_b, cell.core_a, cell.core_b.lower, cell.core_b.upper, HitKind::crossing});
    }
    void add(const Strand &strand) {
        result_.list.push_back({in_domain(a_, strand.a.lower / 2 + strand.a.upper / 2),
                                in_domain(b_, strand.from_b / 2 + strand.to_b / 2), strand.a, strand.from_b,
                                strand.to_b, HitKind::overlap});
    }
    void add(const NearItem &item, HitKind kind) {
        const NearCell &nearest = item.nearest();
        const Interval a = range(a_, item.a), b = range(b_, item.b);
        result_.list.push_back(
            {in_domain(a_, nearest.at_a), in_domain(b_, nearest.at_b), a, b.lower, b.upper, kind});
        result_.complete = result_.complete && kind != HitKind::undecided;
    }
    // Moved to begin in the domain, and no longer than a period.
    static Interval range(const Spline &curve, Interval part) noexcept {
        const double period = period_of(curve), by = shift_of(curve, part.lower);
        const bool whole = period > 0 && part.upper - part.lower >= period;
        return whole ? curve.axis(0).domain() : Interval{part.lower + by, part.upper + by};
    }

    const Spline &a_, &b_;
    Breaks breaks_a_, breaks_b_;
    int dim_;
    double tolerance_, noise_ = 0;
    // Of a curve that is searched for self-intersections: its arcs, and whether it closes.
    std::optional<NearArcs> arcs_;
    bool closes_ = false;
    NearSearch search_;
    PairHits result_;
};

// A place at the seam occurs at both ends of a period: of (s, end) and (start, s) the second one stays.
void drop_repeated(const Spline &curve, std::vector<PairHit> &list) {
    const Interval domain = curve.axis(0).domain();
    std::vector<PairHit> at_start;
    std::ranges::copy_if(list, std::back_inserter(at_start), [&](const PairHit &hit) {
        return hit.kind != HitKind::overlap && hit.range_a.lower <= domain.lower;
    });
    std::erase_if(list, [&](const PairHit &hit) {
        const bool at_end = hit.kind != HitKind::overlap && std::max(hit.from_b, hit.to_b) >= domain.upper &&
                            hit.range_a.lower > domain.lower;
        return at_end && std::ranges::any_of(at_start, [&](const PairHit &other) {
                   return other.kind == hit.kind && std::min(other.from_b, other.to_b) <= hit.range_a.upper &&
                          std::max(other.from_b, other.to_b) >= hit.range_a.lower;
               });
    });
}

} // namespace

PairHits curve_itself(const Spline &curve, double tolerance) {
    check_dimension(curve, 2, std::numeric_limits<int>::max());
    const UsualLimit usual(usual_work(2 * curve.point_count()));
    const LimitedSearch limited;
    PairHits hits = Meeting(curve, tolerance).run();
    if (curve.axis(0).periodic()) {
        drop_repeated(curve, hits.list);
    }
    return hits;
}

PairHits curve_curve(const Spline &a, const Spline &b, double tolerance) {
    check_dimension(a, 2, std::numeric_limits<int>::max(), "a");
    check_same_dimension(a, b);
    const UsualLimit usual(usual_work(a.point_count() + b.point_count()));
    const LimitedSearch limited;
    return Meeting(a, b, tolerance).run();
}

} // namespace nrb::intersect
