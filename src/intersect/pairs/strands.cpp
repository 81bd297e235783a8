// SPDX-License-Identifier: MIT
#include "intersect/pairs/strands.h"

#include "intersect/pairs/joints.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// A cell, moved to the position of its strand.
struct Placed {
    size_t cell;
    Interval a;
    double from_b, to_b;
    Strand::End first{}, last{}; // of a chain, at its first and last cell
};

// Chains of cells along which the curves run side by side: one cell follows another if its matched parts
// begin where those of the other end.
class Chains {
public:
    Chains(const Spline &a, const Spline &b, std::span<const NearCell> cells, std::span<const Link> links)
        : period_a_(period_of(a)), period_b_(period_of(b)), cells_(cells), next_(cells.size()),
          has_last_(cells.size(), false), beside_(cells.size()) {
        for (const Link &link : links) {
            const Turns back{-link.turns.a, -link.turns.b};
            if (!join(link.from, link.to, link.turns)) {
                join(link.to, link.from, back);
            }
        }
        bridge(links);
    }

    // Each chain from its first cell; a closed one from any cell.
    std::vector<std::vector<Placed>> run() {
        std::vector<std::vector<Placed>> chains;
        std::vector<bool> seen(cells_.size(), false);
        for (const bool closed : {false, true}) {
            for (size_t i = 0; i < cells_.size(); ++i) {
                if (is_along(i) && !seen[i] && (closed || !has_last_[i])) {
                    chains.push_back(chain_from(i, seen));
                }
            }
        }
        return chains;
    }

private:
    [[nodiscard]] bool is_along(size_t i) const noexcept { return cells_[i].kind == NearCell::Kind::along; }
    [[nodiscard]] bool is_tiny(size_t i) const noexcept {
        const NearCell::Kind kind = cells_[i].kind;
        return kind == NearCell::Kind::tiny || kind == NearCell::Kind::fold || kind == NearCell::Kind::simple;
    }
    [[nodiscard]] Placed placed(size_t cell, Turns turns) const {
        const Interval on_b = turned(cells_[cell].core_b, turns.b, period_b_);
        return {cell, turned(cells_[cell].core_a, turns.a, period_a_), on_b.lower, on_b.upper};
    }

    bool join(size_t first, size_t second, Turns turns) {
        const NearCell &x = cells_[first], &y = cells_[second];
        if (!is_along(first) || !is_along(second) || x.turn != y.turn || next_[first] || has_last_[second]) {
            return false;
        }
        const Placed from = placed(first, {}), to = placed(second, turns);
        constexpr double room = 4;
        const bool goes_on = std::abs(from.a.upper - to.a.lower) <= room * (x.reach_a + y.reach_a) &&
                             std::abs(from.to_b - to.from_b) <= room * (x.reach_b + y.reach_b);
        if (goes_on) {
            set_next(first, second, turns);
        }
        return goes_on;
    }
    void set_next(size_t first, size_t second, Turns turns) {
        next_[first] = NearGroup::Member{second, turns};
        has_last_[second] = true;
    }

    // Where a curve almost stands still there are tiny cells between a stretch and its continuation: joins
    // them.
    void bridge(std::span<const Link> links) {
        const auto joins_tiny = [this](const Link &link) { return is_tiny(link.from) && is_tiny(link.to); };
        const std::vector<NearGroup> clusters = groups_of(cells_.size(), links, joins_tiny);
        std::vector<std::pair<size_t, Turns>> place(cells_.size()); // of tiny cells: their cluster
        for (size_t i = 0; i < clusters.size(); ++i) {
            for (const NearGroup::Member &member : clusters[i].members) {
                place[member.cell] = {i, member.turns};
            }
        }
        std::vector<std::vector<NearGroup::Member>> ends(clusters.size());
        const auto add_end = [&](size_t tiny, size_t along, Turns turns) {
            const auto &[cluster, own] = place[tiny];
            if (!next_[along] || !has_last_[along]) {
                ends[cluster].push_back({along, {own.a + turns.a, own.b + turns.b}});
            }
        };
        for (const Link &link : links) {
            if (is_tiny(link.from) && is_along(link.to)) {
                add_end(link.from, link.to, link.turns);
            } else if (is_along(link.from) && is_tiny(link.to)) {
                add_end(link.to, link.from, {-link.turns.a, -link.turns.b});
            }
        }
        for (size_t i = 0; i < clusters.size(); ++i) {
            bridge(clusters[i], std::move(ends[i]));
        }
    }
    void bridge(const NearGroup &cluster, std::vector<NearGroup::Member> ends) {
        std::ranges::sort(ends, {}, [this](const NearGroup::Member &member) {
            return std::pair(placed(member.cell, member.turns).a.lower, member.cell);
        });
        const auto again =
            std::unique(ends.begin(), ends.end(), [](const NearGroup::Member &x, const NearGroup::Member &y) {
                return x.cell == y.cell;
            });
        ends.erase(again, ends.end());
        for (size_t i = 0; i + 1 < ends.size(); ++i) {
            join_over(ends[i], ends[i + 1]);
        }
        end_at_joints(cluster, ends);
    }
    void join_over(const NearGroup::Member &first, const NearGroup::Member &second) {
        if (cells_[first.cell].turn == cells_[second.cell].turn && !next_[first.cell] &&
            !has_last_[second.cell]) {
            set_next(first.cell, second.cell,
                     {second.turns.a - first.turns.a, second.turns.b - first.turns.b});
        }
    }
    // Stretches that end at tiny cells are extended to the end of these. If another one runs the other way
    // from there, or the curve follows itself, they turn back.
    void end_at_joints(const NearGroup &cluster, const std::vector<NearGroup::Member> &ends) {
        const auto runs = [&](int turn) {
            return std::ranges::any_of(
                ends, [&](const NearGroup::Member &end) { return cells_[end.cell].turn == turn; });
        };
        if (ends.empty()) {
            return;
        }
        for (const NearGroup::Member &end : ends) {
            beside_[end.cell].push_back({joints_.size(), end.turns});
        }
        joints_.emplace_back(cells_, cluster, period_a_, period_b_, runs(1) && runs(-1));
    }
    // The end of a chain at its last cell, or at its first one, which is moved by the turns.
    [[nodiscard]] Strand::End end_of(const Placed &at, Turns turns, bool last) const {
        Strand::End end = last ? Strand::End{at.a.upper, at.to_b} : Strand::End{at.a.lower, at.from_b};
        const double start = end.a, reach = cells_[at.cell].reach_a;
        const bool rises = (at.from_b <= at.to_b) == last; // outwards on b
        for (const auto &[joint, own] : beside_[at.cell]) {
            const double on_a = (turns.a - own.a) * period_a_, on_b = (turns.b - own.b) * period_b_;
            const JointRange beyond =
                last ? joints_[joint].from(start - reach - on_a) : joints_[joint].until(start + reach - on_a);
            if (!beyond.empty) {
                end.a =
                    last ? std::max(end.a, beyond.a.upper + on_a) : std::min(end.a, beyond.a.lower + on_a);
                end.b =
                    rises ? std::max(end.b, beyond.b.upper + on_b) : std::min(end.b, beyond.b.lower + on_b);
                end.turns_back = end.turns_back || beyond.turns_back;
            }
        }
        return end;
    }

    std::vector<Placed> chain_from(size_t first, std::vector<bool> &seen) const {
        std::vector<Placed> chain{placed(first, {})};
        seen[first] = true;
        Turns turns{};
        for (std::optional<NearGroup::Member> next = next_[first]; next && !seen[next->cell];
             next = next_[next->cell]) {
            seen[next->cell] = true;
            turns = {turns.a + next->turns.a, turns.b + next->turns.b};
            chain.push_back(placed(next->cell, turns));
        }
        chain.front().first = end_of(chain.front(), {}, false);
        chain.back().last = end_of(chain.back(), turns, true);
        return chain;
    }

    double period_a_, period_b_;
    std::span<const NearCell> cells_;
    std::vector<std::optional<NearGroup::Member>> next_;
    std::vector<bool> has_last_;
    std::vector<Joint> joints_;
    // For each cell the joints beside it, and the turns that bring it to them.
    std::vector<std::vector<std::pair<size_t, Turns>>> beside_;
};

// Cuts chains into strands of no more than a period.
class Cutting {
public:
    Cutting(const Spline &a, const Spline &b)
        : a_(a), b_(b), period_a_(period_of(a)), period_b_(period_of(b)) {}

    void add(std::vector<Placed> chain) {
        const bool turned = begin_at_seam(chain);
        size_t first = 0;
        for (size_t i = 1; i <= chain.size(); ++i) {
            const bool end = i == chain.size() ||
                             is_longer(chain[i].a.upper - chain[first].a.lower, period_a_) ||
                             is_longer(std::abs(chain[i].to_b - chain[first].from_b), period_b_);
            if (end) {
                add(std::span(chain).subspan(first, i - first), first == 0 && i == chain.size() && !turned);
                first = i;
            }
        }
    }
    std::vector<Strand> take() { return std::move(strands_); }

private:
    static bool is_longer(double length, double period) noexcept {
        return period > 0 && length > period * (1 + 1e-9);
    }
    // A closed chain over a whole period of a, in which b makes one turn, is made to begin at the seam of a.
    // False for other chains.
    bool begin_at_seam(std::vector<Placed> &chain) const {
        const double length = chain.back().a.upper - chain.front().a.lower;
        if (!(period_a_ > 0) || std::abs(length - period_a_) > 1e-9 * period_a_) {
            return false;
        }
        const double on_b =
            std::abs(std::abs(chain.back().to_b - chain.front().from_b) - period_b_) < 1e-9 * period_b_
                ? (chain.front().from_b <= chain.front().to_b ? period_b_ : -period_b_)
                : 0;
        if (on_b == 0) {
            return false; // b does not close, and has two ends if it is not periodic
        }
        for (Placed &x : chain) {
            const double turns = std::floor((x.a.lower - a_.axis(0).domain().lower) / period_a_);
            x.a = {x.a.lower - turns * period_a_, x.a.upper - turns * period_a_};
            x.from_b -= turns * on_b;
            x.to_b -= turns * on_b;
        }
        std::ranges::sort(chain, {}, [](const Placed &x) { return x.a.lower; });
        return true;
    }
    void add(std::span<const Placed> part, bool is_whole) {
        Strand strand{
            {}, {part.front().a.lower, part.back().a.upper}, part.front().from_b, part.back().to_b, {}, {}};
        strand.first = is_whole ? part.front().first : Strand::End{strand.a.lower, strand.from_b};
        strand.last = is_whole ? part.back().last : Strand::End{strand.a.upper, strand.to_b};
        for (const Placed &x : part) {
            strand.cells.push_back(x.cell);
        }
        const double on_a = shift_of(a_, strand.a.lower),
                     on_b = shift_of(b_, std::min(strand.from_b, strand.to_b));
        strand.a = {strand.a.lower + on_a, strand.a.upper + on_a};
        strand.from_b += on_b;
        strand.to_b += on_b;
        for (Strand::End *end : {&strand.first, &strand.last}) {
            end->a += on_a;
            end->b += on_b;
        }
        strands_.push_back(std::move(strand));
    }
    const Spline &a_, &b_;
    double period_a_, period_b_;
    std::vector<Strand> strands_;
};

} // namespace

std::vector<Strand> strands_of(const Spline &a, const Spline &b, std::span<const NearCell> cells,
                               std::span<const Link> links) {
    Cutting cutting(a, b);
    for (std::vector<Placed> &chain : Chains(a, b, cells, links).run()) {
        cutting.add(std::move(chain));
    }
    return cutting.take();
}

Breaks::Breaks(const KnotVector &axis) {
    const Interval domain = axis.domain();
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (group.knot >= domain.lower && group.knot <= domain.upper) {
            knots_.push_back(group.knot);
        }
    }
    const size_t own = knots_.size();
    for (size_t i = 1; axis.periodic() && i < own; ++i) {
        knots_.push_back(knots_[i] + (domain.upper - domain.lower));
    }
}

bool Breaks::hold(double t) const noexcept {
    return std::ranges::binary_search(knots_, t);
}

bool Breaks::hold_any_in(Interval range) const noexcept {
    const auto first = std::ranges::lower_bound(knots_, range.lower);
    return first != knots_.end() && *first <= range.upper;
}

bool Breaks::have_span_in(Interval range) const noexcept {
    const auto first = std::ranges::lower_bound(knots_, range.lower);
    return first != knots_.end() && first + 1 != knots_.end() && *(first + 1) <= range.upper;
}

std::optional<Strand> overlap_of(const Breaks &on_a, const Breaks &on_b, const Strand &given) {
    Strand strand = given;
    // Whether the strand ends where a curve does; if not, it is extended over tiny cells first.
    const auto ends = [&](double &a, double &b, const Strand::End &beyond) {
        if (on_a.hold(a) || on_b.hold(b)) {
            return true;
        }
        a = beyond.a;
        b = beyond.b;
        return beyond.turns_back || on_a.hold(a) || on_b.hold(b);
    };
    const bool first = ends(strand.a.lower, strand.from_b, strand.first),
               last = ends(strand.a.upper, strand.to_b, strand.last);
    const Interval range_b{std::min(strand.from_b, strand.to_b), std::max(strand.from_b, strand.to_b)};
    if ((first && last) || on_a.have_span_in(strand.a) || on_b.have_span_in(range_b)) {
        return strand;
    }
    return {};
}

} // namespace nrb::intersect
