// SPDX-License-Identifier: MIT
#include "intersect/levels/level_chains.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>

namespace nrb::intersect {

namespace {

constexpr int32_t none = -1;

// Sets that are joined step by step.
class Union {
public:
    explicit Union(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), size_t{0}); }

    size_t find(size_t i) noexcept {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    void join(size_t a, size_t b) noexcept { parent_[find(b)] = find(a); }

private:
    std::vector<size_t> parent_;
};

class Joining {
public:
    Joining(const pieces::PieceGrid &grid, const SurfaceBorders &borders, const LevelPieces &found)
        : grid_(grid), borders_(borders), found_(found), next_(found.roots.size(), none),
          last_(found.roots.size(), none), node_(found.roots.size(), none) {}

    LevelChains run() {
        add_clusters();
        link();
        for (const bool closed : {false, true}) {
            for (size_t arc = 0; arc < found_.arcs.size(); ++arc) {
                if (!taken_[arc] && (closed || last_[root(found_.arcs[arc].from)] == none)) {
                    add_chain(arc, closed);
                }
            }
        }
        return std::move(result_);
    }

private:
    using Ranges = std::array<Interval, 2>;
    static size_t root(int32_t i) noexcept { return static_cast<size_t>(i); }

    // Parameters of a part.
    [[nodiscard]] Ranges ranges_of(const LevelPart &part) const {
        const PieceDomain domain = domain_of(grid_, part.piece);
        Ranges ranges;
        for (size_t k = 0; k < 2; ++k) {
            ranges[k] = {domain.parameter(k, part.lower[k]),
                         domain.parameter(k, part.lower[k] + part.length[k])};
        }
        return ranges;
    }

    // With as much on either side: between parts of what is near there may be some that are not quite.
    static Ranges widened(const Ranges &ranges) noexcept {
        Ranges wide = ranges;
        for (Interval &range : wide) {
            const double size = range.upper - range.lower;
            range = {range.lower - size, range.upper + size};
        }
        return wide;
    }

    // By rising ranges of the first axis: those that end before a cluster begins touch none of those after it.
    void add_clusters() {
        std::vector<Ranges> ranges;
        for (const LevelCluster &cluster : found_.clusters) {
            if (const Ranges own = ranges_of(cluster.part); !cluster.beside || !has_root(own)) {
                ranges.push_back(own);
                clusters_.push_back(&cluster);
            }
        }
        std::vector<Ranges> wide;
        std::ranges::transform(ranges, std::back_inserter(wide), widened);
        std::vector<size_t> order(ranges.size());
        std::iota(order.begin(), order.end(), size_t{0});
        std::ranges::sort(order, {}, [&](size_t i) { return wide[i][0].lower; });
        Union sets(ranges.size());
        join_neighbours(wide, order, sets);
        join_at_seams(ranges, sets);
        join_at_poles(ranges, sets);
        std::map<size_t, std::vector<size_t>> members;
        for (const size_t i : order) {
            members[sets.find(i)].push_back(i);
        }
        for (const auto &[set, all] : members) {
            add_part(all, ranges);
        }
    }

    // Whether an arc begins or ends in a part, which is a place or an interval on a side of a piece.
    [[nodiscard]] bool has_root(const Ranges &part) const {
        return std::ranges::any_of(found_.roots, [&](const LevelRoot &root) {
            for (size_t k = 0; k < 2; ++k) {
                const double size = borders_.period(k), room = 0x1p-36 * size;
                const auto is_in = [&](double at) {
                    return at >= part[k].lower - room && at <= part[k].upper + room;
                };
                const bool beyond =
                    borders_.wraps(k) && (is_in(root.at[k] - size) || is_in(root.at[k] + size));
                if (!is_in(root.at[k]) && !beyond) {
                    return false;
                }
            }
            return true;
        });
    }

    // Intervals by their lower ends, none longer than the longest: those that touch another one are near its ends.
    struct Line {
        std::multimap<double, size_t> by_lower;
        double longest = 0;

        void add(const Interval &range, size_t i) {
            by_lower.emplace(range.lower, i);
            longest = std::max(longest, range.upper - range.lower);
        }
        template <class Visit>
        void visit(const Interval &range, Visit &&visit) const {
            const auto last = by_lower.upper_bound(range.upper);
            for (auto i = by_lower.lower_bound(range.lower - 1.001 * longest); i != last; ++i) {
                count_work(20);
                visit(i->second);
            }
        }
    };

    static bool touch(const Interval &a, const Interval &b) noexcept {
        return a.lower <= b.upper && b.lower <= a.upper;
    }

    // From one end of the first axis to the other.
    static void join_neighbours(const std::vector<Ranges> &ranges, const std::vector<size_t> &order,
                                Union &sets) {
        Line active;
        std::multimap<double, std::multimap<double, size_t>::iterator> ends;
        for (const size_t i : order) {
            while (!ends.empty() && ends.begin()->first < ranges[i][0].lower) {
                active.by_lower.erase(ends.begin()->second);
                ends.erase(ends.begin());
            }
            active.visit(ranges[i][1], [&](size_t j) {
                if (touch(ranges[j][1], ranges[i][1])) {
                    sets.join(j, i);
                }
            });
            active.longest = std::max(active.longest, ranges[i][1].upper - ranges[i][1].lower);
            ends.emplace(ranges[i][0].upper, active.by_lower.emplace(ranges[i][1].lower, i));
        }
    }

    // Clusters on both sides of a seam.
    void join_at_seams(const std::vector<Ranges> &ranges, Union &sets) {
        for (size_t k = 0; k < 2; ++k) {
            if (!borders_.wraps(k)) {
                continue;
            }
            const Interval domain = domain_along(k);
            Line at_end;
            for (size_t j = 0; j < ranges.size(); ++j) {
                if (ranges[j][k].upper == domain.upper) {
                    at_end.add(ranges[j][1 - k], j);
                }
            }
            for (size_t i = 0; i < ranges.size(); ++i) {
                if (ranges[i][k].lower == domain.lower) {
                    at_end.visit(ranges[i][1 - k], [&](size_t j) {
                        if (touch(ranges[i][1 - k], ranges[j][1 - k])) {
                            sets.join(i, j);
                        }
                    });
                }
            }
        }
    }

    // Those at a side of one point.
    void join_at_poles(const std::vector<Ranges> &ranges, Union &sets) {
        for (size_t k = 0; k < 2; ++k) {
            for (const bool up : {false, true}) {
                if (!borders_.is_collapsed(k, up ? grid_.count(static_cast<int>(k)) - 1 : 0, up)) {
                    continue;
                }
                std::optional<size_t> first;
                for (size_t i = 0; i < ranges.size(); ++i) {
                    if (up ? ranges[i][k].upper == domain_along(k).upper
                           : ranges[i][k].lower == domain_along(k).lower) {
                        first = first.value_or(i);
                        sets.join(*first, i);
                    }
                }
            }
        }
    }

    [[nodiscard]] Interval domain_along(size_t k) const {
        const int axis = static_cast<int>(k);
        return {grid_.break_at(axis, 0), grid_.break_at(axis, grid_.count(axis))};
    }

    // Clusters that hang together are one part.
    void add_part(const std::vector<size_t> &members, const std::vector<Ranges> &ranges) {
        Ranges whole;
        for (size_t k = 0; k < 2; ++k) {
            whole[k] = range_of(members, ranges, k);
        }
        std::array<double, 2> at = middle(whole);
        const auto has = [&](size_t i) { return is_in(at, ranges[i]); };
        at = std::ranges::any_of(members, has) ? at : middle(ranges[members.front()]);
        const bool near = std::ranges::all_of(members, [&](size_t i) { return clusters_[i]->near; });
        const int32_t node = add_node(near ? NodeKind::touch : NodeKind::undecided, at, whole);
        for (const size_t i : members) {
            for (const int32_t of : clusters_[i]->roots) {
                node_[root(of)] = node;
            }
            for (const auto &[corner, of] : found_.corners) {
                node_[root(of)] =
                    node_[root(of)] == none && is_in(corner, ranges[i]) ? node : node_[root(of)];
            }
        }
    }

    // In the domain.
    [[nodiscard]] std::array<double, 2> middle(const Ranges &ranges) const {
        std::array<double, 2> at{};
        for (size_t k = 0; k < 2; ++k) {
            at[k] = ranges[k].lower / 2 + ranges[k].upper / 2;
            at[k] = at[k] > domain_along(k).upper ? at[k] - borders_.period(k) : at[k];
        }
        return at;
    }
    static bool is_in(const std::array<double, 2> &at, const Ranges &ranges) noexcept {
        return at[0] >= ranges[0].lower && at[0] <= ranges[0].upper && at[1] >= ranges[1].lower &&
               at[1] <= ranges[1].upper;
    }

    // Where they are on both sides of a seam, the range runs beyond it, from behind the widest gap to the one before.
    [[nodiscard]] Interval range_of(const std::vector<size_t> &members, const std::vector<Ranges> &ranges,
                                    size_t k) const {
        std::vector<Interval> all;
        all.reserve(members.size());
        for (const size_t i : members) {
            all.push_back(ranges[i][k]);
        }
        std::ranges::sort(all, {}, &Interval::lower);
        Interval gap{0, 0}, range = all.front();
        for (const Interval &next : all) {
            if (next.lower - range.upper > gap.upper - gap.lower) {
                gap = {range.upper, next.lower};
            }
            range.upper = std::max(range.upper, next.upper);
        }
        const Interval domain = domain_along(k);
        const bool beyond = borders_.wraps(k) && gap.upper > gap.lower && range.lower == domain.lower &&
                            range.upper == domain.upper;
        return beyond ? Interval{gap.upper, gap.lower + borders_.period(k)} : range;
    }

    int32_t add_node(NodeKind kind, const std::array<double, 2> &at, const Ranges &range) {
        result_.nodes.push_back({0, kind, at, range});
        return static_cast<int32_t>(result_.nodes.size()) - 1;
    }

    // What begins and ends in each root: an arc alone, where one piece closes. A root at which two arcs begin or end belongs
    // to neither.
    void link() {
        taken_.assign(found_.arcs.size(), false);
        for (size_t i = 0; i < found_.arcs.size(); ++i) {
            const LevelArc &arc = found_.arcs[i];
            int32_t &next = next_[root(arc.from)], &last = last_[root(arc.to)];
            if ((arc.from == arc.to && arc.is_point()) || next != none || last != none) {
                taken_[i] = true;
                add_node(NodeKind::undecided, found_.roots[root(arc.from)].at, ranges_of(arc.part));
                continue;
            }
            next = last = static_cast<int32_t>(i);
        }
    }

    void add_chain(size_t first, bool closed) {
        std::vector<size_t> arcs;
        for (auto arc = static_cast<int32_t>(first); arc != none && !taken_[root(arc)];
             arc = next_[root(found_.arcs[root(arc)].to)]) {
            taken_[root(arc)] = true;
            arcs.push_back(root(arc));
        }
        if (closed) { // a seam, if there is one, comes first
            const auto after_seam =
                std::ranges::find_if(arcs, [&](size_t arc) { return is_seam(next_of_last(arc), arc); });
            std::rotate(arcs.begin(), after_seam == arcs.end() ? arcs.begin() : after_seam, arcs.end());
        }
        const bool point = std::ranges::all_of(arcs, [&](size_t arc) { return found_.arcs[arc].is_point(); });
        if (point) {
            add_touch(found_.arcs[arcs.front()], found_.arcs[arcs.back()]);
        } else {
            add_parts(arcs, closed ? loops_++ : none);
        }
    }
    // A place where f is 0 and below around it.
    void add_touch(const LevelArc &first, const LevelArc &last) {
        if (node_[root(first.from)] == none && node_[root(last.to)] == none) {
            const std::array<double, 2> &at = found_.roots[root(first.from)].at;
            add_node(NodeKind::touch, at, {Interval{at[0], at[0]}, Interval{at[1], at[1]}});
        }
    }
    [[nodiscard]] size_t next_of_last(size_t arc) const { return root(last_[root(found_.arcs[arc].from)]); }

    // Where parameters do not go on the chain is cut.
    [[nodiscard]] bool is_seam(size_t before, size_t after) const {
        const LevelArc &a = found_.arcs[before], &b = found_.arcs[after];
        const PieceDomain of_a = domain_of(grid_, a.part.piece), of_b = domain_of(grid_, b.part.piece);
        for (size_t k = 0; k < 2; ++k) {
            const double apart = std::abs(of_a.parameter(k, a.last[k]) - of_b.parameter(k, b.first[k]));
            if (!borders_.is_periodic(k) && apart > borders_.period(k) / 2) {
                return true;
            }
        }
        return false;
    }

    void add_parts(const std::vector<size_t> &arcs, int32_t loop) {
        LevelChain chain;
        chain.loop = loop;
        const size_t first = result_.chains.size();
        for (size_t i = 0; i < arcs.size(); ++i) {
            chain.arcs.push_back(arcs[i]);
            const bool last = i + 1 == arcs.size();
            if (last || is_seam(arcs[i], arcs[i + 1])) {
                const bool point =
                    std::ranges::all_of(chain.arcs, [&](size_t arc) { return found_.arcs[arc].is_point(); });
                if (point) {
                    chain.arcs.clear();
                    continue;
                }
                const bool whole = last && loop != none && chain.arcs.size() == arcs.size();
                chain.closed = whole && !is_seam(arcs[i], arcs[0]);
                if (!chain.closed) {
                    chain.nodes = {node_at(found_.arcs[chain.arcs.front()], true),
                                   node_at(found_.arcs[chain.arcs.back()], false)};
                }
                if (!is_in_node(chain)) {
                    if (result_.chains.size() > first) {
                        go_on(result_.chains.back().nodes[1], chain.nodes[0]);
                    }
                    result_.chains.push_back(chain);
                }
                chain.arcs.clear();
                chain.nodes = {none, none};
            }
        }
        if (loop != none && result_.chains.size() > first && !result_.chains.back().closed) {
            go_on(result_.chains.back().nodes[1], result_.chains[first].nodes[0]);
        }
    }
    void go_on(int32_t from, int32_t to) {
        if (result_.nodes[root(from)].kind == NodeKind::seam &&
            result_.nodes[root(to)].kind == NodeKind::seam) {
            result_.nodes[root(from)].next = to;
            result_.nodes[root(to)].next = from;
        }
    }

    // Between clusters of one part.
    [[nodiscard]] bool is_in_node(const LevelChain &chain) const {
        if (chain.nodes[0] == none || chain.nodes[0] != chain.nodes[1]) {
            return false;
        }
        const MeetNode &node = result_.nodes[root(chain.nodes[0])];
        return std::ranges::all_of(chain.arcs, [&](size_t arc) {
            return is_in(found_.roots[root(found_.arcs[arc].from)].at, node.range) &&
                   is_in(found_.roots[root(found_.arcs[arc].to)].at, node.range);
        });
    }

    // Where an arc begins or ends.
    int32_t node_at(const LevelArc &arc, bool begins) {
        const int32_t i = begins ? arc.from : arc.to;
        const bool goes_on = next_[root(i)] != none && last_[root(i)] != none;
        int32_t &node = node_[root(i)];
        if (node == none || goes_on) {
            const PieceDomain domain = domain_of(grid_, arc.part.piece);
            const std::array<double, 2> &place = begins ? arc.first : arc.last;
            const std::array<double, 2> at{domain.parameter(0, place[0]), domain.parameter(1, place[1])};
            const auto kind = goes_on                                               ? NodeKind::seam
                              : found_.roots[root(i)].is_end || borders_.is_end(at) ? NodeKind::border
                                                                                    : NodeKind::undecided;
            node = add_node(kind, at, {Interval{at[0], at[0]}, Interval{at[1], at[1]}});
        }
        return node;
    }

    int32_t loops_ = 0;
    const pieces::PieceGrid &grid_;
    const SurfaceBorders &borders_;
    const LevelPieces &found_;
    std::vector<const LevelCluster *> clusters_; // that count
    std::vector<int32_t> next_, last_;           // arcs that begin, and that end, in a root
    std::vector<int32_t> node_;                  // of roots
    std::vector<bool> taken_;
    LevelChains result_;
};

} // namespace

LevelChains chains_of(const pieces::PieceGrid &grid, const SurfaceBorders &borders,
                      const LevelPieces &found) {
    return Joining(grid, borders, found).run();
}

} // namespace nrb::intersect
