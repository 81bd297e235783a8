// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/level_chains.h"

#include "base/numbers.h"
#include "intersect/levels/trace/cluster_groups.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr int32_t none = -1;

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
    using Ranges = ParameterRanges;
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

    void add_clusters() {
        constexpr double room = 0x1p-36;
        std::vector<std::array<double, 2>> places;
        std::ranges::transform(found_.roots, std::back_inserter(places), &LevelRoot::at);
        const SortedPlaces roots(std::move(places));
        std::vector<Ranges> ranges;
        for (const LevelCluster &cluster : found_.clusters) {
            const Ranges own = ranges_of(cluster.part);
            if (!cluster.beside || !roots.any_in(own, borders_, room)) {
                ranges.push_back(own);
                clusters_.push_back(&cluster);
            }
        }
        for (const std::vector<size_t> &group : touching_groups(ranges, grid_, borders_)) {
            add_part(group, ranges);
        }
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
            const auto &[along, across] = ranges[i];
            auto corner = found_.corners.lower_bound({along.lower, across.lower});
            for (; corner != found_.corners.end() && corner->first[0] <= along.upper; ++corner) {
                int32_t &own = node_[root(corner->second)];
                own = own == none && is_in(corner->first, ranges[i]) ? node : own;
            }
        }
    }

    // In the domain.
    [[nodiscard]] std::array<double, 2> middle(const Ranges &ranges) const {
        std::array<double, 2> at{};
        for (size_t k = 0; k < 2; ++k) {
            at[k] = ranges[k].lower / 2 + ranges[k].upper / 2;
            at[k] = at[k] > domain_along(grid_, k).upper ? at[k] - borders_.period(k) : at[k];
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
        const Interval domain = domain_along(grid_, k);
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
