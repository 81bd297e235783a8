// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_chains.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/trace/ranges_tree.h"
#include "intersect/surfaces/cross_spot.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

namespace nrb::intersect {

namespace {

// In lengths of pieces, small multiples of the shift of the sides of boxes: spots no farther apart than
// one_place are one place, and arcs no longer than no_length are points.
constexpr double one_place = 32 * shift_of_sides, no_length = 16 * shift_of_sides;
constexpr size_t unmatched = static_cast<size_t>(-1);

class CrossJoining {
public:
    CrossJoining(const CrossSurface &a, const CrossSurface &b, const std::vector<JoinedArc> &arcs,
                 std::vector<CrossGroup> groups)
        : surfaces_{&a, &b}, distances_(a, b), arcs_(arcs), next_(arcs.size(), unmatched),
          last_(arcs.size(), unmatched), taken_(arcs.size(), false), groups_(std::move(groups)),
          around_(a.borders, b.borders, around(groups_)) {}

    CrossChains run() {
        set_spots();
        match_all();
        add_clusters();
        for (const bool closed : {false, true}) {
            for (size_t arc = 0; arc < next_.size(); ++arc) {
                if (!taken_[arc] && (closed || last_[arc] == unmatched)) {
                    add_chain(arc, closed);
                }
            }
        }
        return std::move(result_);
    }

private:
    // An end of an arc that is still free: along one coordinate, its piece, its place in it, and the arc.
    using Free = std::tuple<int64_t, double, size_t>;
    struct Match {
        double apart;
        size_t from, to;
    };

    [[nodiscard]] const pieces::PieceGrid &grid(size_t i) const noexcept { return surfaces_[i / 2]->grid; }
    [[nodiscard]] bool wraps(size_t i) const noexcept { return surfaces_[i / 2]->borders.wraps(i % 2); }
    [[nodiscard]] bool is_periodic(size_t i) const noexcept {
        return surfaces_[i / 2]->borders.is_periodic(i % 2);
    }
    [[nodiscard]] int64_t count(size_t i) const noexcept { return grid(i).count(static_cast<int>(i % 2)); }
    // Arcs across corners of boxes may be mere points: they are left out.
    void set_spots() {
        for (size_t arc = 0; arc < arcs_.size(); ++arc) {
            for (size_t end = 0; end < 2; ++end) {
                spots_[end].push_back(arcs_[arc].spots[end]);
            }
            lengths_.push_back(length_of(spots_[0][arc], spots_[1][arc], no_length));
            taken_[arc] = lengths_[arc] <= 1;
        }
    }

    // Whether an arc may be made by rounding alone.
    [[nodiscard]] bool is_short(size_t arc) const noexcept { return lengths_[arc] <= 64; }

    // First joins ends that are in the same place; then drops short arcs with a loose end, and joins ends
    // that are separated by noise or by such an arc.
    void match_all() {
        match(1);
        while (drop_short_ends()) {
        }
        match(16);
    }
    bool drop_short_ends() {
        bool any = false;
        for (size_t arc = 0; arc < next_.size(); ++arc) {
            const bool begins = last_[arc] == unmatched && !arcs_[arc].open[0],
                       stops = next_[arc] == unmatched && !arcs_[arc].open[1];
            if (taken_[arc] || !is_short(arc) || (!begins && !stops)) {
                continue;
            }
            taken_[arc] = any = true;
            if (last_[arc] != unmatched) {
                next_[std::exchange(last_[arc], unmatched)] = unmatched;
            }
            if (next_[arc] != unmatched) {
                last_[std::exchange(next_[arc], unmatched)] = unmatched;
            }
        }
        return any;
    }
    // Joins ends to beginnings, the nearest pairs first.
    void match(double wide) {
        for (const size_t end : {size_t{0}, size_t{1}}) {
            set_free(end);
        }
        std::vector<Match> matches;
        for (const size_t end : {size_t{0}, size_t{1}}) {
            for (const auto &[index, place, arc] : free_[end][0]) {
                add_matches(arc, end, wide, matches);
            }
        }
        std::ranges::sort(matches, {}, [](const Match &m) { return std::tuple(m.apart, m.from, m.to); });
        for (const Match &m : matches) {
            if (next_[m.from] == unmatched && last_[m.to] == unmatched) {
                next_[m.from] = m.to;
                last_[m.to] = m.from;
            }
        }
    }
    // Sorts the beginnings (0) or the ends (1) that are free, by each coordinate.
    void set_free(size_t end) {
        const std::vector<size_t> &joined = end == 0 ? last_ : next_;
        for (size_t i = 0; i < 4; ++i) {
            std::vector<Free> &free = free_[end][i];
            free.clear();
            for (size_t arc = 0; arc < next_.size(); ++arc) {
                if (!taken_[arc] && joined[arc] == unmatched && !arcs_[arc].open[end]) {
                    const CrossSpot &spot = spots_[end][arc];
                    free.emplace_back(spot.index[i], spot.place[i], arc);
                }
            }
            std::ranges::sort(free);
        }
    }
    // The free beginnings or ends between two places of a piece along coordinate i.
    [[nodiscard]] std::span<const Free> free_between(size_t end, size_t i, int64_t piece, double lower,
                                                     double upper) const {
        const std::vector<Free> &free = free_[end][i];
        return {std::ranges::lower_bound(free, Free(piece, lower, 0)),
                std::ranges::upper_bound(free, Free(piece, upper, unmatched))};
    }
    // Those that may be one place with a spot, as far as coordinate i tells: in its piece, and in the pieces
    // before and after it. CrossDistances::apart() allows for the noise of both spots; only what has less of
    // it is certainly found here, because what has more looks for this spot in turn.
    [[nodiscard]] std::array<std::span<const Free>, 3> free_near(const CrossSpot &spot, size_t end, size_t i,
                                                                 double wide) const {
        const double noise = spot.noise[i] + largest(spot.noise), at = spot.place[i],
                     window = 1.01 * wide * (one_place + noise);
        const int64_t piece = spot.index[i], n = count(i);
        std::array<std::span<const Free>, 3> near{free_between(end, i, piece, at - window, at + window)};
        for (const bool up : {false, true}) {
            const int64_t beyond = up ? piece + 1 : piece - 1;
            if ((beyond >= 0 && beyond < n) || wraps(i)) {
                const int64_t other = (beyond + n) % n;
                const double own = distances_.length(i, piece), length = distances_.length(i, other),
                             place = (up ? at - 1 : at) * own / length + (up ? 0 : 1),
                             room = window * std::min(own, length) / length;
                near[up ? 2 : 1] = free_between(end, i, other, place - room, place + room);
            }
        }
        return near;
    }
    // Matches an end (1) or a beginning (0) of an arc with what is near it. Candidates are those along the
    // coordinate along which they are fewest: along others, many arcs may begin on one side of a piece.
    void add_matches(size_t arc, size_t end, double wide, std::vector<Match> &matches) const {
        const CrossSpot &spot = spots_[end][arc];
        const auto size_of = [](const auto &near) {
            return near[0].size() + near[1].size() + near[2].size();
        };
        std::array<std::span<const Free>, 3> near = free_near(spot, 1 - end, 0, wide);
        for (size_t i = 1; i < 4; ++i) {
            const auto own = free_near(spot, 1 - end, i, wide);
            near = size_of(own) < size_of(near) ? own : near;
        }
        count_work(100);
        for (const std::span<const Free> part : near) {
            for (const auto &[piece, place, other] : part) {
                count_work(40);
                const double far = distances_.apart(spot, spots_[1 - end][other], one_place);
                if (far <= wide && !(other == arc && is_short(arc))) {
                    matches.push_back({far, end == 1 ? arc : other, end == 1 ? other : arc});
                }
            }
        }
    }

    void add_clusters() {
        for (const CrossGroup &group : groups_) {
            add_node(group.touch ? NodeKind::touch : NodeKind::undecided, group.ranges);
        }
    }

    int64_t add_node(NodeKind kind, const std::array<Interval, 4> &ranges) {
        MeetNode node{0, kind, {}, {}};
        for (size_t k = 0; k < 2; ++k) {
            node.at[k] = ranges[k].lower / 2 + ranges[k].upper / 2;
            node.at_second[k] = ranges[2 + k].lower / 2 + ranges[2 + k].upper / 2;
            node.range[k] = ranges[k];
            node.range_second[k] = ranges[2 + k];
        }
        result_.nodes.push_back(node);
        return std::ssize(result_.nodes) - 1;
    }
    int64_t add_node(NodeKind kind, const CrossSpot &spot) {
        std::array<Interval, 4> ranges;
        for (size_t i = 0; i < 4; ++i) {
            const int axis = static_cast<int>(i % 2);
            const double at =
                std::clamp(spot.parameter[i], grid(i).break_at(axis, 0), grid(i).break_at(axis, count(i)));
            ranges[i] = {at, at};
        }
        return add_node(kind, ranges);
    }

    // Whether a spot is, to rounding, where a surface ends or jumps. An end may be there although it is on
    // another side of its box.
    [[nodiscard]] bool is_at_border(const CrossSpot &spot) const noexcept {
        for (size_t i = 0; i < 4; ++i) {
            const double room = one_place + spot.noise[i], at = spot.place[i];
            const SurfaceBorders &borders = surfaces_[i / 2]->borders;
            if ((at <= room && !borders.goes_on(i % 2, spot.index[i], false)) ||
                (at >= 1 - room && !borders.goes_on(i % 2, spot.index[i], true))) {
                return true;
            }
        }
        return false;
    }
    // The node at which a way begins or ends.
    int64_t node_at(size_t arc, size_t end) {
        const CrossSpot &spot = spots_[end][arc];
        if (arcs_[arc].open[end]) {
            return add_node(NodeKind::border, spot);
        }
        size_t first = groups_.size();
        around_.visit(ranges_of(spot), [&](size_t group) {
            first = group < first && is_in(spot, groups_[group].ranges, true) ? group : first;
        });
        if (first < groups_.size()) {
            return static_cast<int64_t>(first);
        }
        const bool ends = arcs_[arc].creased[end] || is_at_border(spot);
        return add_node(ends ? NodeKind::border : NodeKind::undecided, spot);
    }
    // The ranges of each group, widened on all sides by their own length.
    static std::vector<RangesTree::Ranges> around(const std::vector<CrossGroup> &groups) {
        std::vector<RangesTree::Ranges> all;
        for (const CrossGroup &group : groups) {
            RangesTree::Ranges &wide = all.emplace_back(group.ranges);
            for (Interval &range : wide) {
                const double size = range.upper - range.lower;
                range = {range.lower - size, range.upper + size};
            }
        }
        return all;
    }
    // The room of a spot along coordinate i, in parameters: for the shift of sides, for noise, and for what
    // seams move.
    [[nodiscard]] double room_of(const CrossSpot &spot, size_t i) const noexcept {
        return (one_place + 16 * spot.noise[i]) * distances_.length(i, spot.index[i]);
    }
    [[nodiscard]] RangesTree::Ranges ranges_of(const CrossSpot &spot) const noexcept {
        RangesTree::Ranges ranges;
        for (size_t i = 0; i < 4; ++i) {
            const double room = 1.01 * room_of(spot, i), at = spot.parameter[i];
            ranges[i] = {at - room, at + room};
        }
        return ranges;
    }
    // Whether a spot is in ranges, with that room. around: or as near to them as they are long. Around parts
    // in which arcs are not told apart, there are others in which rounding hides arcs: ends there count as
    // ends in the group, although nothing is proven of what is around it.
    [[nodiscard]] bool is_in(const CrossSpot &spot, const std::array<Interval, 4> &ranges,
                             bool around) const noexcept {
        for (size_t i = 0; i < 4; ++i) {
            const double room = room_of(spot, i) + (around ? ranges[i].upper - ranges[i].lower : 0),
                         at = spot.parameter[i];
            const double period = wraps(i) ? surfaces_[i / 2]->borders.period(i % 2) : 0;
            bool in = false;
            for (const double x : {at, at - period, at + period}) {
                in = in || (x >= ranges[i].lower - room && x <= ranges[i].upper + room);
            }
            if (!in) {
                return false;
            }
        }
        return true;
    }

    // Whether parameters jump between consecutive arcs, at the seam of an axis that closes but is not
    // periodic: chains are cut there.
    [[nodiscard]] bool is_seam(size_t before, size_t after) const noexcept {
        for (size_t i = 0; i < 4; ++i) {
            const double far = std::abs(spots_[1][before].parameter[i] - spots_[0][after].parameter[i]);
            if (!is_periodic(i) && wraps(i) && far > surfaces_[i / 2]->borders.period(i % 2) / 2) {
                return true;
            }
        }
        return false;
    }

    void add_chain(size_t first, bool closed) {
        std::vector<size_t> arcs;
        for (size_t arc = first; arc != unmatched && !taken_[arc]; arc = next_[arc]) {
            taken_[arc] = true;
            arcs.push_back(arc);
        }
        if (closed) {
            const auto after_seam =
                std::ranges::find_if(arcs, [&](size_t arc) { return is_seam(last_[arc], arc); });
            std::rotate(arcs.begin(), after_seam == arcs.end() ? arcs.begin() : after_seam, arcs.end());
        }
        if (closed && std::ranges::all_of(arcs, [&](size_t arc) { return is_short(arc); })) {
            add_node(NodeKind::undecided, spots_[0][first]);
            return;
        }
        const bool cut = closed && is_seam(arcs.back(), arcs.front());
        if (!closed && is_in_group(arcs)) {
            return;
        }
        const size_t begun = result_.chains.size();
        const int64_t loop = closed ? loops_++ : -1;
        CrossChain chain;
        for (size_t i = 0; i < arcs.size(); ++i) {
            chain.arcs.push_back(arcs[i]);
            if (i + 1 < arcs.size() && is_seam(arcs[i], arcs[i + 1])) {
                add_part(std::exchange(chain, {}), loop, begun);
            }
        }
        chain.closed = closed && !cut && chain.arcs.size() == arcs.size();
        add_part(std::move(chain), loop, begun);
        if (cut) {
            go_on(result_.chains.back().nodes[1], result_.chains[begun].nodes[0]);
        }
    }
    // Whether all of a chain is in a touch, in which branches are not told apart, or is a short one in or
    // around a group that is left open. Such chains are dropped.
    [[nodiscard]] bool is_in_group(const std::vector<size_t> &arcs) const {
        constexpr double little = 0x1p-8; // of pieces
        double length = 0;
        for (const size_t arc : arcs) {
            length += length_of(spots_[0][arc], spots_[1][arc]);
        }
        const auto holds = [&](const CrossGroup &group) {
            return (group.touch || length <= little) && std::ranges::all_of(arcs, [&](size_t arc) {
                       return is_in(spots_[0][arc], group.ranges, !group.touch) &&
                              is_in(spots_[1][arc], group.ranges, !group.touch);
                   });
        };
        bool any = false;
        around_.visit(ranges_of(spots_[0][arcs.front()]),
                      [&](size_t group) { any = any || holds(groups_[group]); });
        return any;
    }
    // Adds a part of a way that seams may cut. begun: the number of the first part; parts of one way follow
    // each other, and their nodes are linked.
    void add_part(CrossChain chain, int64_t loop, size_t begun) {
        chain.loop = loop;
        const size_t first = chain.arcs.front(), last = chain.arcs.back();
        if (!chain.closed) {
            chain.nodes = {
                last_[first] == unmatched ? node_at(first, 0) : add_node(NodeKind::seam, spots_[0][first]),
                next_[last] == unmatched ? node_at(last, 1) : add_node(NodeKind::seam, spots_[1][last])};
        }
        if (result_.chains.size() > begun) {
            go_on(result_.chains.back().nodes[1], chain.nodes[0]);
        }
        result_.chains.push_back(std::move(chain));
    }
    void go_on(int64_t from, int64_t to) {
        result_.nodes[static_cast<size_t>(from)].next = to;
        result_.nodes[static_cast<size_t>(to)].next = from;
    }

    std::array<const CrossSurface *, 2> surfaces_;
    CrossDistances distances_;
    const std::vector<JoinedArc> &arcs_;
    std::array<std::vector<CrossSpot>, 2> spots_;          // of beginnings and of ends
    std::array<std::array<std::vector<Free>, 4>, 2> free_; // beginnings and ends, along each coordinate
    std::vector<size_t> next_, last_;                      // arcs, or unmatched
    std::vector<bool> taken_;
    std::vector<CrossGroup> groups_; // of clusters; the first nodes are theirs
    RangesTree around_;              // of the groups and what is around() them
    std::vector<double> lengths_;    // of arcs
    int64_t loops_ = 0;
    CrossChains result_;
};

} // namespace

CrossChains joined_chains(const CrossSurface &a, const CrossSurface &b, const std::vector<JoinedArc> &arcs,
                          std::vector<CrossGroup> groups) {
    return CrossJoining(a, b, arcs, std::move(groups)).run();
}

CrossChains cross_chains(const CrossSurface &a, const CrossSurface &b, std::vector<CrossGroup> groups,
                         const CrossParts &found) {
    std::vector<JoinedArc> arcs;
    arcs.reserve(found.arcs.size());
    for (const CrossArc &arc : found.arcs) {
        const auto &[first, last] = arc.ends;
        arcs.push_back({{spot_of(arc, first), spot_of(arc, last)}, {first.open, last.open}, {}});
    }
    return joined_chains(a, b, arcs, std::move(groups));
}

} // namespace nrb::intersect
