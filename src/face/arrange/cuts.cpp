// SPDX-License-Identifier: MIT
#include "face/arrange/cuts.h"

#include "base/error.h"
#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace nrb::face {

namespace {

using intersect::HitKind;

// How far from its node a mark may be, in multiples of the distance that counts as none.
constexpr double widest_node = 16;

bool holds(Interval range, double t) noexcept {
    return range.lower <= t && t <= range.upper;
}

} // namespace

Cuts::Cuts(const Covering &covering, const LoopHits &hits, double near)
    : covering_(covering), hits_(hits), near_(near) {
    add_marks();
    add_marks_under_overlaps();
    marks_.assign(found_.begin(), found_.end());
    join_marks();
    add_edges();
    for (const LoopHit &hit : hits_.all()) {
        if (hit.kind == HitKind::overlap) {
            add_pairs(hit);
        }
    }
}

void Cuts::add_marks() {
    for (size_t i = 0; i < hits_.curves().size(); ++i) {
        const Interval domain = hits_.curves()[i].spline->axis(0).domain();
        add(i, domain.lower);
        add(i, domain.upper);
    }
    for (const LoopHit &hit : hits_.all()) {
        add_marks(hit);
    }
    for (const LoopHit &hit : hits_.all()) {
        if (hit.kind == HitKind::tangent || hit.kind == HitKind::undecided || is_short(hit)) {
            add_touch(hit);
        } else if (hit.kind == HitKind::contact) {
            add_reached(hit);
        }
    }
}

// A contact makes no node: the curves are proven to be apart, if only by less than what counts as none.
void Cuts::add_marks(const LoopHit &hit) {
    if (hit.kind == HitKind::overlap && !is_short(hit)) {
        const Interval b = hit.against ? Interval{hit.range_b.upper, hit.range_b.lower} : hit.range_b;
        add(hit.a, hit.range_a.lower);
        add(hit.a, hit.range_a.upper);
        add(hit.b, b.lower);
        add(hit.b, b.upper);
    } else if (hit.kind == HitKind::crossing) {
        links_.emplace_back(add(hit.a, hit.at_a), add(hit.b, hit.at_b));
    }
}

// An overlap that is no longer than one node may stand for counts as a touch.
bool Cuts::is_short(const LoopHit &hit) const {
    return hit.kind == HitKind::overlap && is_small(hit.a, hit.range_a) && is_small(hit.b, hit.range_b);
}

// Over the whole range of a touch the curves are nearer to each other than rounding can tell, so one node has
// to stand for the range. If a mark is there already, it is used together with its foot on the other curve.
// An undecided hit that is small enough for one node counts as a touch.
void Cuts::add_touch(const LoopHit &hit) {
    if (hit.kind == HitKind::undecided && !(is_small(hit.a, hit.range_a) && is_small(hit.b, hit.range_b))) {
        fail_at(hit);
    }
    const Mark *on_a = mark_in(hit.a, hit.range_a, hit.at_a), *on_b = mark_in(hit.b, hit.range_b, hit.at_b);
    const double at_a = on_a != nullptr ? on_a->at
                        : on_b != nullptr
                            ? hits_.foot(hit.a, moved(hits_.place(hit.b, on_b->at), hit.move), hit.range_a)
                            : hit.at_a;
    const double at_b = on_b != nullptr   ? on_b->at
                        : on_a != nullptr ? hits_.foot(hit.b, beside(hit, at_a), hit.range_b)
                                          : hit.at_b;
    links_.emplace_back(add(hit.a, at_a), add(hit.b, at_b));
}

// A loose end of a curve that comes within the distance that counts as none of another curve ends on that
// curve; otherwise its curve would divide nothing.
void Cuts::add_reached(const LoopHit &hit) {
    for (const bool upper : {false, true}) {
        if (const double t = end_of(hit.a, upper); holds(hit.range_a, t) && is_loose(hit.a, upper)) {
            link_near({hit.a, t}, {hit.b, hits_.foot(hit.b, beside(hit, t), hit.range_b)}, hit.move);
        }
        if (const double t = end_of(hit.b, upper); holds(hit.range_b, t) && is_loose(hit.b, upper)) {
            const Point2 place = moved(hits_.place(hit.b, t), hit.move);
            link_near({hit.a, hits_.foot(hit.a, place, hit.range_a)}, {hit.b, t}, hit.move);
        }
    }
}

void Cuts::link_near(const Mark &a, const Mark &b, const Point2 &move) {
    if (hits_.distance(hits_.place(a.curve, a.at), moved(hits_.place(b.curve, b.at), move)) <= near_) {
        links_.emplace_back(add(a.curve, a.at), add(b.curve, b.at));
    }
}

double Cuts::end_of(size_t curve, bool upper) const noexcept {
    const Interval domain = hits_.curves()[curve].spline->axis(0).domain();
    return upper ? domain.upper : domain.lower;
}

// Whether no curve of the same loop begins or ends there. The neighbours in the loop are tried first, since
// one of them mostly does; but there may be other curves of the loop between two that continue each other.
bool Cuts::is_loose(size_t curve, bool upper) const {
    constexpr double rounding = 0x1p-48;
    const std::vector<LoopCurve> &curves = hits_.curves();
    const Point2 at = hits_.place(curve, end_of(curve, upper)), scaled = hits_.scaled(at);
    const double least = rounding * (1 + std::abs(scaled[0]) + std::abs(scaled[1]));
    const auto goes_on = [&](size_t other) {
        return std::ranges::any_of(std::array{false, true}, [&](bool end) {
            const bool itself = other == curve && end == upper;
            const Point2 place = hits_.place(other, end_of(other, end));
            return !itself && hits_.distance(covering_.nearest_copy(place, at), at) <= least;
        });
    };
    const auto is_own = [&](size_t other) {
        return other < curves.size() && curves[other].loop == curves[curve].loop;
    };
    if ((is_own(curve + 1) && goes_on(curve + 1)) || (is_own(curve - 1) && goes_on(curve - 1))) {
        return false;
    }
    auto first = static_cast<size_t>(
        std::ranges::lower_bound(curves, curves[curve].loop, {}, &LoopCurve::loop) - curves.begin());
    for (; is_own(first); ++first) {
        if (goes_on(first)) {
            return false;
        }
    }
    return true;
}

// A mark in a range, or next to it if the curve from there to `at` is small: an end of the curve if there is
// one, else the mark nearest to `at`; null if there is none.
const Cuts::Mark *Cuts::mark_in(size_t curve, Interval range, double at) const {
    const Mark *best = nullptr;
    const auto rank = [&](const Mark &mark) { return std::pair(!is_end(mark), std::abs(mark.at - at)); };
    const auto look = [&](const Mark &mark) {
        best = best == nullptr || rank(mark) < rank(*best) ? &mark : best;
    };
    const auto above = found_.lower_bound({curve, range.lower});
    auto mark = above;
    for (; mark != found_.end() && mark->curve == curve && mark->at <= range.upper; ++mark) {
        look(*mark);
    }
    if (mark != found_.end() && mark->curve == curve && is_small(curve, {at, mark->at})) {
        look(*mark);
    }
    if (above != found_.begin() && std::prev(above)->curve == curve &&
        is_small(curve, {std::prev(above)->at, at})) {
        look(*std::prev(above));
    }
    return best;
}

// Where two curves overlap, a mark on one of them is also a mark on the other.
void Cuts::add_marks_under_overlaps() {
    const std::set<Mark> all = found_;
    const auto mark_inside = [&](size_t curve, Interval range, auto &&add_other) {
        const auto first = all.lower_bound({curve, range.lower});
        for (auto mark = first; mark != all.end() && mark->curve == curve && mark->at <= range.upper;
             ++mark) {
            add_other(mark->at);
        }
    };
    for (const LoopHit &hit : hits_.all()) {
        if (hit.kind != HitKind::overlap) {
            continue;
        }
        mark_inside(hit.a, hit.range_a,
                    [&](double t) { add(hit.b, hits_.foot(hit.b, beside(hit, t), hit.range_b)); });
        mark_inside(hit.b, hit.range_b, [&](double t) {
            add(hit.a, hits_.foot(hit.a, moved(hits_.place(hit.b, t), hit.move), hit.range_a));
        });
    }
}

Cuts::Mark Cuts::add(size_t curve, double t) {
    return *found_.insert({curve, at_knot(curve, t)}).first;
}

// The nearest knot in the domain, ends included, if it differs from t by at most 2^-20 of the domain and its
// place from that at t by no more than what counts as none; else t, clamped to the domain.
double Cuts::at_knot(size_t curve, double t) const {
    const KnotVector &axis = hits_.curves()[curve].spline->axis(0);
    const Interval domain = axis.domain();
    const double at = std::clamp(t, domain.lower, domain.upper);
    const auto knots = axis.knots();
    const auto above = std::ranges::lower_bound(knots, at);
    double best = at, least = 0x1p-20 * (domain.upper - domain.lower);
    const auto look = [&](double knot) {
        const bool inside = domain.lower <= knot && knot <= domain.upper;
        const bool nearer = std::abs(knot - at) <= least;
        if (inside && nearer && hits_.distance(hits_.place(curve, knot), hits_.place(curve, at)) <= near_) {
            best = knot;
            least = std::abs(knot - at);
        }
    };
    if (above != knots.end()) {
        look(*above);
    }
    if (above != knots.begin()) {
        look(*std::prev(above));
    }
    return best;
}

// Whether samples of a part of a curve stay as near to its start as a mark has to be to its node.
bool Cuts::is_small(size_t curve, Interval range) const {
    constexpr int samples = 8;
    const Point2 from = hits_.place(curve, range.lower);
    for (int i = 1; i <= samples; ++i) {
        const double t = range.lower + (range.upper - range.lower) * i / samples;
        if (hits_.distance(from, hits_.place(curve, t)) > widest_node * near_) {
            return false;
        }
    }
    return true;
}

// Makes nodes of marks that are linked, or near each other.
void Cuts::join_marks() {
    DisjointSets sets(marks_.size());
    const auto number = [&](const Mark &mark) {
        return static_cast<size_t>(std::ranges::lower_bound(marks_, mark) - marks_.begin());
    };
    for (const auto &[a, b] : links_) {
        sets.join(number(a), number(b));
    }
    std::vector<Point2> places;
    for (const Mark &mark : marks_) {
        places.push_back(covering_.canonical(hits_.place(mark.curve, mark.at)));
    }
    join_near(places, sets);
    std::vector<size_t> names;
    for (size_t i = 0; i < marks_.size(); ++i) {
        names.push_back(sets.find(i));
    }
    set_nodes(names);
}

// Joins places near each other, across the ends of closed axes as well.
void Cuts::join_near(const std::vector<Point2> &places, DisjointSets &sets) const {
    std::vector<intersect::Box3> boxes;
    for (const Point2 &place : places) {
        const Point2 scaled = hits_.scaled(place);
        intersect::Box3 box;
        box.lower = box.upper = {scaled[0], scaled[1], 0};
        boxes.push_back(box);
    }
    const intersect::BoxTree tree(boxes);
    const Point2 unit = hits_.scaled({1, 1}), reach{near_ / unit[0], near_ / unit[1]};
    for (size_t i = 0; i < places.size(); ++i) {
        const auto join = [&](const Point2 &move) {
            const Point2 at = hits_.scaled(moved(places[i], move));
            tree.walk_near({at[0], at[1], 0}, near_,
                           [&](int32_t other) { sets.join(i, static_cast<size_t>(other)); });
            return false;
        };
        join({0, 0});
        covering_.any_move({places[i][0] - reach[0], places[i][1] - reach[1]},
                           {places[i][0] + reach[0], places[i][1] + reach[1]}, [&](const Point2 &move) {
                               return move != Point2{0, 0} && join(move);
                           });
    }
}

bool Cuts::is_end(const Mark &mark) const noexcept {
    return mark.at == end_of(mark.curve, false) || mark.at == end_of(mark.curve, true);
}

// names: of each mark, the number of its set, which is the first mark of the set.
void Cuts::set_nodes(std::vector<size_t> &names) {
    constexpr size_t none = std::numeric_limits<size_t>::max();
    std::vector<size_t> best(marks_.size(), none);
    for (size_t i = 0; i < marks_.size(); ++i) {
        size_t &own = best[names[i]];
        own = own == none || (is_end(marks_[i]) && !is_end(marks_[own])) ? i : own;
    }
    std::vector<size_t> numbers(marks_.size(), none);
    for (size_t i = 0; i < marks_.size(); ++i) {
        const size_t name = names[i];
        if (numbers[name] == none) {
            numbers[name] = nodes_.size();
            const Mark &own = marks_[best[name]];
            nodes_.push_back(covering_.canonical(hits_.place(own.curve, own.at)));
        }
        node_of_.push_back(numbers[name]);
        const Point2 &node = nodes_[node_of_[i]], place = hits_.place(marks_[i].curve, marks_[i].at);
        if (hits_.distance(covering_.nearest_copy(node, place), place) > widest_node * near_) {
            fail(Status::not_converged, "curves come undecidably near each other at (%s, %s)",
                 Number(node[0]).text, Number(node[1]).text);
        }
    }
}

void Cuts::add_edges() {
    for (size_t i = 0; i + 1 < marks_.size(); ++i) {
        if (marks_[i].curve == marks_[i + 1].curve) {
            const size_t from = node_of_[i], to = node_of_[i + 1];
            const Interval range{marks_[i].at, marks_[i + 1].at};
            if (from != to || !is_small(marks_[i].curve, range)) {
                edges_.push_back({marks_[i].curve, range, from, to});
            }
        }
    }
}

// The indices [first, last) of the edges of a curve whose middle is in a range.
std::pair<size_t, size_t> Cuts::edges_in(size_t curve, Interval range) const {
    const auto middle = [](const CutEdge &edge) { return edge.range.lower / 2 + edge.range.upper / 2; };
    const auto before = [&](const CutEdge &edge, double t) {
        return edge.curve < curve || (edge.curve == curve && middle(edge) < t);
    };
    const auto first = std::lower_bound(edges_.begin(), edges_.end(), range.lower, before);
    auto last = first;
    while (last != edges_.end() && last->curve == curve && middle(*last) <= range.upper) {
        ++last;
    }
    return {static_cast<size_t>(first - edges_.begin()), static_cast<size_t>(last - edges_.begin())};
}

void Cuts::add_pairs(const LoopHit &hit) {
    const auto [first, last] = edges_in(hit.a, hit.range_a);
    for (size_t i = first; i < last; ++i) {
        add_pair(hit, i);
    }
}

// Pairs an edge of a with the edge of b that lies beside it.
void Cuts::add_pair(const LoopHit &hit, size_t edge) {
    const CutEdge &own = edges_[edge];
    const double middle = own.range.lower / 2 + own.range.upper / 2;
    const double foot = hits_.foot(hit.b, beside(hit, middle), hit.range_b);
    const auto [first, last] = edges_in(hit.b, hit.range_b);
    for (size_t i = first; i < last; ++i) {
        const CutEdge &other = edges_[i];
        if (other.range.lower <= foot && foot <= other.range.upper) {
            const bool same = own.from == (hit.against ? other.to : other.from) &&
                              own.to == (hit.against ? other.from : other.to);
            if (same) {
                pairs_.push_back({edge, i, hit.against});
                return;
            }
        }
    }
    if (!is_short(hit)) {
        fail_at(hit);
    }
}

// A place of a, moved by periods to where b is stored.
Point2 Cuts::beside(const LoopHit &hit, double t) const {
    const Point2 x = hits_.place(hit.a, t);
    return {x[0] - hit.move[0], x[1] - hit.move[1]};
}

void Cuts::fail_at(const LoopHit &hit) const {
    const auto text = [&](double t) {
        const Point2 x = hits_.place(hit.a, t);
        return std::string("(") + Number(x[0]).text + ", " + Number(x[1]).text + ")";
    };
    fail(Status::not_converged, "curves come undecidably near each other between %s and %s",
         text(hit.range_a.lower).c_str(), text(hit.range_a.upper).c_str());
}

} // namespace nrb::face
