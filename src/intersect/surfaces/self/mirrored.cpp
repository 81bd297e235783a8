// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/mirrored.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/trace/cluster_groups.h"
#include "intersect/surfaces/arc_places.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace nrb::intersect {

namespace {

// How far beyond its ends, along coordinate k of its chart, a zero still counts as on an arc, in lengths of
// its box.
constexpr double beyond_ends = 0x1p-10;

CrossSpot mirrored(const CrossSpot &spot) noexcept {
    CrossSpot result;
    for (size_t i = 0; i < 4; ++i) {
        const size_t other = (i + 2) % 4;
        result.index[i] = spot.index[other];
        result.place[i] = spot.place[other];
        result.parameter[i] = spot.parameter[other];
        result.noise[i] = spot.noise[other];
    }
    return result;
}

// Removes mirrored ways. Precondition: the chains of a way follow each other.
class MirroredWays {
public:
    MirroredWays(const CrossSurface &surface, const CrossParts &found, CrossChains &chains)
        : places_(surface, surface), found_(found), chains_(chains) {}

    void run() {
        set_ways();
        std::vector<size_t> order(ways_.size());
        std::iota(order.begin(), order.end(), size_t{0});
        std::ranges::stable_sort(order, std::ranges::greater(), [&](size_t way) { return ways_[way].arcs; });
        std::vector<bool> kept(ways_.size(), false);
        for (const size_t way : order) {
            const size_t mirror = mirror_of(way);
            kept[way] = mirror == way || mirror == ways_.size() || !kept[mirror];
        }
        keep(kept);
    }

private:
    struct Way {
        size_t first, count; // chains
        size_t arcs;
    };

    void set_ways() {
        way_of_arc_.resize(found_.arcs.size(), 0);
        int64_t goes_on_at = -1;
        for (size_t i = 0; i < chains_.chains.size(); ++i) {
            const CrossChain &chain = chains_.chains[i];
            if (goes_on_at < 0 || goes_on_at != chain.nodes[0]) {
                ways_.push_back({i, 0, 0});
            }
            ways_.back().count += 1;
            ways_.back().arcs += chain.arcs.size();
            for (const size_t arc : chain.arcs) {
                way_of_arc_[arc] = ways_.size();
                numbers_[spot_of(found_.arcs[arc], found_.arcs[arc].ends[0]).index].push_back(arc);
            }
            const int64_t end = chain.nodes[1];
            goes_on_at = end < 0 ? -1 : chains_.nodes[static_cast<size_t>(end)].next;
        }
    }

    // The way that contains the mirrored middle of this one; the number of ways if there is none.
    [[nodiscard]] size_t mirror_of(size_t way) const {
        const Way &own = ways_[way];
        const auto chains = std::span(chains_.chains).subspan(own.first, own.count);
        const CrossChain &longest =
            *std::ranges::max_element(chains, {}, [](const CrossChain &chain) { return chain.arcs.size(); });
        const CrossArc &middle = found_.arcs[longest.arcs[longest.arcs.size() / 2]];
        const std::optional<CrossSpot> spot = middle_of(middle);
        if (!spot) {
            return ways_.size();
        }
        const CrossSpot other = mirrored(*spot);
        for (const size_t arc : places_.near(other.index, numbers_)) {
            count_work(20);
            if (is_on(found_.arcs[arc], other)) {
                return way_of_arc_[arc] - 1;
            }
        }
        return ways_.size();
    }
    static std::optional<CrossSpot> middle_of(const CrossArc &arc) {
        CrossEnd middle;
        for (size_t i = 0; i < 4; ++i) {
            middle.at[i] = std::midpoint(arc.ends[0].at[i], arc.ends[1].at[i]);
        }
        middle.coordinate = arc.box.chart.axis();
        return arc.box.solve(middle.coordinate, middle.at) ? std::optional(spot_of(arc, middle))
                                                           : std::nullopt;
    }
    [[nodiscard]] bool is_on(const CrossArc &arc, const CrossSpot &spot) const {
        CrossPlace z{};
        if (!places_.is_zero_of(arc, spot, z)) {
            return false;
        }
        const size_t k = arc.box.chart.axis();
        const auto [from, to] = std::minmax(arc.ends[0].at[k], arc.ends[1].at[k]);
        return z[k] >= from - beyond_ends && z[k] <= to + beyond_ends;
    }

    // Keeps these ways, and numbers the loops anew.
    void keep(const std::vector<bool> &kept) {
        std::vector<CrossChain> chains;
        int64_t loops = 0;
        for (size_t way = 0; way < ways_.size(); ++way) {
            const Way &own = ways_[way];
            if (!kept[way]) {
                continue;
            }
            const bool loop = chains_.chains[own.first].loop >= 0;
            for (size_t i = own.first; i < own.first + own.count; ++i) {
                chains.push_back(std::move(chains_.chains[i]));
                chains.back().loop = loop ? loops : -1;
            }
            loops += loop ? 1 : 0;
        }
        chains_.chains = std::move(chains);
    }

    ArcPlaces places_;
    const CrossParts &found_;
    CrossChains &chains_;
    std::vector<Way> ways_;
    std::vector<size_t> way_of_arc_; // counted from 1; 0: of none
    NumbersOfPieces numbers_;        // of the arcs in ways, by pieces
};

ContactPoint mirrored(const ContactPoint &point) noexcept {
    ContactPoint result = point;
    std::swap(result.a, result.b);
    result.at = {point.at[2], point.at[3], point.at[0], point.at[1]};
    return result;
}

// Merges mirrored nodes that stand for parts of the domain, of kind touch or undecided.
class MirroredNodes {
public:
    MirroredNodes(const CrossSurface &surface, Meet &meet)
        : surface_(surface), meet_(meet), has_branch_(meet.nodes.size(), false) {
        for (const MeetBranch &branch : meet.branches) {
            for (const int64_t node : branch.nodes) {
                if (node >= 0) {
                    has_branch_[static_cast<size_t>(node)] = true;
                }
            }
        }
    }

    // Of two mirrored nodes one takes over what the other stands for. The other becomes a border node without
    // a branch, which Meet::tidy_nodes() removes.
    void run() {
        for (size_t i = 0; i < meet_.nodes.size(); ++i) {
            for (size_t j = i + 1; j < meet_.nodes.size() && is_part(i); ++j) {
                count_work(20);
                if (is_part(j) && !(has_branch_[i] && has_branch_[j]) && are_mirrored(i, j)) {
                    has_branch_[j] ? take(i, j) : take(j, i);
                }
            }
        }
    }
    // Whether both ranges of a node have places in common.
    [[nodiscard]] bool is_near_itself(const MeetNode &node) const {
        return overlap(node.range, node.range_second);
    }

private:
    [[nodiscard]] bool is_part(size_t i) const noexcept {
        const NodeKind kind = meet_.nodes[i].kind;
        return kind == NodeKind::touch || kind == NodeKind::undecided;
    }
    [[nodiscard]] bool are_mirrored(size_t i, size_t j) const {
        const MeetNode &a = meet_.nodes[i], &b = meet_.nodes[j];
        return overlap(a.range, b.range_second) && overlap(a.range_second, b.range);
    }
    // Extends node `to` by what the mirrored node `from` stands for.
    void take(size_t from, size_t to) {
        MeetNode &less = meet_.nodes[from], &more = meet_.nodes[to];
        for (size_t k = 0; k < 2; ++k) {
            enclose(less.range_second[k], k, more.range[k]);
            enclose(less.range[k], k, more.range_second[k]);
            more.at[k] = std::midpoint(more.range[k].lower, more.range[k].upper);
            more.at_second[k] = std::midpoint(more.range_second[k].lower, more.range_second[k].upper);
        }
        more.kind = less.kind == NodeKind::undecided ? less.kind : more.kind;
        less.kind = NodeKind::border;
    }
    // Extends `all` to contain `own`, across the seam where the result is shorter.
    void enclose(const Interval &own, size_t axis, Interval &all) const noexcept {
        const double period = surface_.borders.wraps(axis) ? surface_.borders.period(axis) : 0;
        Interval best{-infinity, infinity};
        for (const double shift : {0.0, period, -period}) {
            const Interval both{std::min(all.lower, own.lower + shift),
                                std::max(all.upper, own.upper + shift)};
            best = both.upper - both.lower < best.upper - best.lower ? both : best;
        }
        const Interval domain = domain_along(surface_.grid, axis);
        all = period > 0 && best.upper - best.lower >= period ? domain : best;
        all = all.lower < domain.lower ? Interval{all.lower + period, all.upper + period} : all;
    }
    [[nodiscard]] bool overlap(const std::array<Interval, 2> &a, const std::array<Interval, 2> &b) const {
        for (size_t k = 0; k < 2; ++k) {
            const double period = surface_.borders.wraps(k) ? surface_.borders.period(k) : 0;
            bool any = false;
            for (const double shift : {0.0, period, -period}) {
                any = any || (a[k].lower + shift <= b[k].upper && a[k].upper + shift >= b[k].lower);
            }
            if (!any) {
                return false;
            }
        }
        return true;
    }

    const CrossSurface &surface_;
    Meet &meet_;
    std::vector<bool> has_branch_;
};

std::array<Interval, 4> mirrored(const std::array<Interval, 4> &ranges) noexcept {
    return {ranges[2], ranges[3], ranges[0], ranges[1]};
}

} // namespace

std::vector<CrossGroup> mirrored_groups(const CrossSurface &surface, const CrossTouch &touch,
                                        std::vector<CrossCluster> clusters) {
    for (CrossCluster &cluster : clusters) {
        std::array<double, 4> at{};
        std::ranges::transform(cluster.ranges, at.begin(),
                               [](const Interval &x) { return std::midpoint(x.lower, x.upper); });
        if (std::pair(at[2], at[3]) < std::pair(at[0], at[1])) {
            cluster.ranges = mirrored(cluster.ranges);
        }
    }
    std::vector<CrossGroup> groups = cross_groups(surface, surface, touch, clusters);
    for (size_t i = 0, n = groups.size(); i < n; ++i) {
        groups.push_back({mirrored(groups[i].ranges), groups[i].touch});
    }
    return groups;
}

void remove_mirrored(const CrossSurface &surface, const CrossParts &found, CrossChains &chains) {
    MirroredWays(surface, found, chains).run();
}

void remove_mirrored(const ContactTracer &tracer, std::vector<ContactCurve> &curves) {
    std::vector<ContactCurve> kept;
    for (ContactCurve &curve : curves) {
        const ContactPoint middle = mirrored(curve.places[curve.places.size() / 2]);
        const auto passes = [&](const ContactCurve &other) { return tracer.passes(other, middle); };
        if (std::ranges::none_of(kept, passes)) {
            kept.push_back(std::move(curve));
        }
    }
    curves = std::move(kept);
}

void remove_mirrored(const CrossSurface &surface, const CrossTouch &touch, Meet &meet) {
    MirroredNodes nodes(surface, meet);
    nodes.run();
    for (MeetNode &node : meet.nodes) {
        const std::array<Interval, 4> ranges{node.range[0], node.range[1], node.range_second[0],
                                             node.range_second[1]};
        if (node.kind == NodeKind::touch && nodes.is_near_itself(node) &&
            !(touch.is_touch(ranges) && touch.is_spot(ranges))) {
            node.kind = NodeKind::undecided;
        }
    }
}

} // namespace nrb::intersect
