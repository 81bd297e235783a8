// SPDX-License-Identifier: MIT
#include "intersect/projection/feet_search.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr size_t most_pairs = 1 << 16;
constexpr size_t most_deep = 1024; // pairs of one size, halved at least `deep` times, without a chart
constexpr int deep = 12, hidden_deep = 6;
constexpr int parts = 8, probes = 16; // of GraphArc
constexpr double hidden = 32;         // times the rounding: values that are no larger may be 0
constexpr double small = 1.0 / 16;    // of the tolerance: all pairs around one place then make one cluster

int halvings_of(const FeetCell &patch, const FeetCell &span) noexcept {
    return patch.halvings() + span.halvings();
}

} // namespace

double size_in_space(const std::array<double, 3> &speeds, const std::array<Interval, 4> &ranges) noexcept {
    const auto along = [&](size_t i) { return speeds[i] * (ranges[i].upper - ranges[i].lower); };
    return std::max(along(0) + along(1), along(2));
}

FeetSearch::FeetSearch(CrossGround &surface, CrossGround &lines, const Spline &curve,
                       const pieces::Frame &frame)
    : grid_(surface.grid), lines_(lines.grid), patches_(surface),
      spans_(lines, curve, frame), speeds_{patches_.root().speeds[0], patches_.root().speeds[1],
                                           spans_.root().speeds[0]} {}

FeetParts FeetSearch::run(double tolerance) {
    tolerance_ = tolerance;
    find_pieces();
    SearchSteps steps;
    while (!pairs_.empty()) {
        for (const Pair &pair : pairs_) {
            if (work_ended() || next_.size() > most_pairs) {
                add(pair);
            } else {
                look(pair);
            }
            steps.next(next_.size());
        }
        if (settle_crowd()) {
            next_.clear();
        }
        pairs_ = std::exchange(next_, {});
    }
    return std::move(found_);
}

// Where feet fill a region, adds all pairs that are left as clusters. Returns whether that is so.
bool FeetSearch::settle_crowd() {
    const auto are_deep = [](const Pair &pair) {
        return !pair.graph && halvings_of(*pair.patch, *pair.span) >= deep;
    };
    if (std::ranges::count_if(next_, are_deep) <= static_cast<std::ptrdiff_t>(most_deep)) {
        return false;
    }
    std::ranges::for_each(next_, [&](const Pair &pair) { add(pair); });
    return true;
}

void FeetSearch::find_pieces() {
    stack_.emplace_back(&patches_.root(), &spans_.root());
    while (!stack_.empty()) {
        const auto [surface, curve] = stack_.back();
        stack_.pop_back();
        work_ended() ? add_unknown(*surface, *curve) : look_at(*surface, *curve);
    }
}

void FeetSearch::look_at(FeetGroup &surface, FeetGroup &curve) {
    if (have_no_feet(surface, curve)) {
        return;
    }
    if (surface.is_piece() && curve.is_piece()) {
        FeetCell *const patch = patches_.cell(surface), *const span = spans_.cell(curve);
        if (patch == nullptr || span == nullptr) {
            add_unknown(surface, curve);
            unbounded_ = true;
        } else {
            count_work(work_of_a_pair);
            pairs_.push_back({patch, span, false});
        }
        return;
    }
    const bool first = !surface.is_piece() && (curve.is_piece() || surface.pieces() >= curve.pieces());
    for (size_t end = 0; end < 2; ++end) {
        first ? stack_.emplace_back(&patches_.half(surface, end), &curve)
              : stack_.emplace_back(&surface, &spans_.half(curve, end));
    }
}

void FeetSearch::look(const Pair &pair) {
    box_.patch = pair.patch;
    box_.span = pair.span;
    nets_.set(*pair.patch, *pair.span);
    switch (box_.chart.set(nets_)) {
    case FeetChart::Verdict::apart:
        return;
    case FeetChart::Verdict::chart:
        look_in_chart(pair);
        return;
    case FeetChart::Verdict::bent:
    case FeetChart::Verdict::flat:
        if (!is_hidden(pair) && !is_small(pair)) {
            halve(pair, box_.chart.bent_axis(nets_, lengths_of(pair)));
        } else if (!pair.graph) {
            add(pair);
        }
    }
}

void FeetSearch::look_in_chart(const Pair &pair) {
    Sides sides;
    for (size_t i = 0; i < 3; ++i) {
        sides[i] = {box_.side(i, 0), box_.side(i, 1)};
    }
    finder_.forget();
    GraphVerdict verdict = finder_.look(box_, sides, 1, 4 * shift_of_sides, probes);
    if (verdict == GraphVerdict::open) {
        verdict = finder_.look_between_ends(parts);
    }
    if (verdict == GraphVerdict::open) {
        verdict = look_along_borders(sides);
    }
    if (verdict == GraphVerdict::arc) {
        count_work(work_of_a_kept_part);
        found_.arcs.push_back({box_, finder_.ends()});
    } else if (verdict == GraphVerdict::open) {
        halve({pair.patch, pair.span, true}, box_.chart.bent_axis(nets_, lengths_of(pair)));
    }
}

// An arc that runs close along a side of a piece is looked for between sides that are moved outwards. Which
// side of the original one it is on is then decided by its known zeros alone, so that nothing has to be
// proven about the gap between them and that side: the arc is kept, or belongs to the neighbour, or is left
// open if the zeros disagree.
GraphVerdict FeetSearch::look_along_borders(const Sides &sides) {
    Sides moved = sides;
    for (size_t i = 0; i < 3 && finder_.near(); ++i) {
        const bool turns = i != box_.chart.axis() && GraphArc<FeetBox, 3>::changes(box_, i);
        for (size_t end = 0; end < 2 && turns; ++end) {
            const double room = box_.cell(i).room(i % 2, end);
            moved[i][end] += std::abs((*finder_.near())[i] - sides[i][end]) >= room ? 0
                             : end == 1                                             ? room
                                                                                    : -room;
        }
    }
    if (moved == sides) {
        return GraphVerdict::open;
    }
    const GraphVerdict verdict = finder_.look(box_, moved, parts, 4 * shift_of_sides, probes);
    return verdict == GraphVerdict::arc ? on_own_side(sides, moved) : verdict;
}

GraphVerdict FeetSearch::on_own_side(const Sides &sides, const Sides &moved) const {
    GraphVerdict verdict = GraphVerdict::arc;
    for (size_t i = 0; i < 3; ++i) {
        for (size_t end = 0; end < 2; ++end) {
            if (moved[i][end] == sides[i][end]) {
                continue;
            }
            const auto is_beyond = [&](const FeetPlace &z) {
                return end == 1 ? z[i] > sides[i][1] : z[i] < sides[i][0];
            };
            const auto beyond = std::ranges::count_if(finder_.zeros(), is_beyond);
            if (beyond == std::ssize(finder_.zeros())) {
                return GraphVerdict::nothing;
            }
            verdict = beyond > 0 ? GraphVerdict::open : verdict;
        }
    }
    return verdict;
}

// Whether rounding hides both equations on all of the pair, or one of them on a pair that has been halved
// often.
bool FeetSearch::is_hidden(const Pair &pair) const noexcept {
    int count = 0;
    for (size_t e = 0; e < 2; ++e) {
        const Interval range = FeetNets::range_of(nets_.of(e));
        count += std::max(-range.lower, range.upper) <= hidden * nets_.near(e) ? 1 : 0;
    }
    return count == 2 || (count == 1 && halvings_of(*pair.patch, *pair.span) >= hidden_deep);
}

bool FeetSearch::is_small(const Pair &pair) const noexcept {
    return size_in_space(speeds_, ranges_of(pair)) <= small * tolerance_;
}

FeetPlace FeetSearch::lengths_of(const Pair &pair) noexcept {
    return {pair.patch->net().speeds[0] * pair.patch->length(0),
            pair.patch->net().speeds[1] * pair.patch->length(1),
            pair.span->net().speeds[0] * pair.span->length(0)};
}

// Halves the part with this axis, or the other part if that one is too small.
void FeetSearch::halve(const Pair &pair, size_t axis) {
    for (const bool of_patch : {axis < 2, axis == 2}) {
        FeetCell &cell = of_patch ? *pair.patch : *pair.span;
        if (cell.split(axis % 2, (of_patch ? patches_ : spans_).cells())) {
            for (size_t end = 0; end < 2; ++end) {
                next_.push_back({of_patch ? cell.half(end) : pair.patch,
                                 of_patch ? pair.span : cell.half(end), pair.graph});
            }
            return;
        }
    }
    if (!pair.graph) {
        add(pair);
    }
}

std::array<Interval, 4> FeetSearch::ranges_of(const Pair &pair) const noexcept {
    return {pair.patch->range(0), pair.patch->range(1), pair.span->range(0),
            Interval{lines_.break_at(1, 0), lines_.break_at(1, lines_.count(1))}};
}

void FeetSearch::add(const Pair &pair) {
    count_work(work_of_a_kept_part);
    found_.clusters.push_back({ranges_of(pair)});
}

void FeetSearch::add_unknown(const FeetGroup &surface, const FeetGroup &curve) {
    count_work(work_of_a_kept_part);
    CrossCluster &cluster = found_.clusters.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        const FeetGroup &group = i < 2 ? surface : curve;
        const pieces::PieceGrid &grid = i < 2 ? grid_ : lines_;
        const int axis = static_cast<int>(i % 2);
        cluster.ranges[i] = {grid.break_at(axis, group.first[i % 2]), grid.break_at(axis, group.last[i % 2])};
    }
}

} // namespace nrb::intersect
