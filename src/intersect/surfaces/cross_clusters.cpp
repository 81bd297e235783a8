// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_clusters.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/trace/cluster_groups.h"
#include "intersect/levels/trace/ranges_tree.h"

#include <algorithm>
#include <functional>

namespace nrb::intersect {

namespace {

using Ranges = std::array<Interval, 4>;
using Members = std::vector<size_t>;

class Groups {
public:
    Groups(const CrossSurface &a, const CrossSurface &b, const TouchTest &touch,
           const std::vector<CrossCluster> &clusters)
        : surfaces_{&a, &b}, touch_(touch), clusters_(clusters) {}

    std::vector<CrossGroup> run() {
        if (clusters_.empty()) {
            return {};
        }
        for (const Members &members : groups_on_both()) {
            groups_.push_back(together(members));
        }
        std::ranges::sort(groups_, std::ranges::greater(),
                          [](const Part &part) { return size_of(part.ranges); });
        absorb();
        std::vector<CrossGroup> result;
        for (auto &[group, room] : groups_) {
            if (holds_nothing(group)) {
                continue;
            }
            touch_.narrow(group);
            const bool touch = touch_.is_touch(group);
            if (touch) {
                widen(group);
            }
            result.push_back({group, touch});
        }
        return result;
    }

private:
    // A connected group, and the room around it in which it absorbs others: twice the width of its largest
    // member.
    struct Part {
        Ranges ranges;
        std::array<double, 4> room;
    };

    // Groups of clusters that are connected on both surfaces: groups on one surface are refined by the other
    // one. Where one surface bends, parts of the other one may be large, and touch each other although they
    // belong to different places of the first.
    [[nodiscard]] std::vector<Members> groups_on_both() const {
        Members all(clusters_.size());
        for (size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        std::vector<Members> groups{std::move(all)};
        for (const size_t surface : {size_t{0}, size_t{1}, size_t{0}}) {
            std::vector<Members> finer;
            for (const Members &group : groups) {
                add_groups(surface, group, finer);
            }
            groups = std::move(finer);
        }
        return groups;
    }
    void add_groups(size_t surface, const Members &of, std::vector<Members> &groups) const {
        std::vector<ParameterRanges> ranges;
        for (const size_t i : of) {
            ranges.push_back({clusters_[i].ranges[2 * surface], clusters_[i].ranges[2 * surface + 1]});
        }
        for (const Members &group :
             touching_groups(ranges, surfaces_[surface]->grid, surfaces_[surface]->borders)) {
            Members &members = groups.emplace_back();
            std::ranges::transform(group, std::back_inserter(members), [&](size_t i) { return of[i]; });
        }
    }

    [[nodiscard]] Part together(const Members &members) const {
        Part all{clusters_[members.front()].ranges, {}};
        for (const size_t member : members) {
            const Ranges &own = clusters_[member].ranges;
            enclose(own, all.ranges);
            const std::array<double, 4> room = room_of(own);
            for (size_t i = 0; i < 4; ++i) {
                all.room[i] = std::max(all.room[i], room[i]);
            }
        }
        return all;
    }

    // Whether a group certainly holds nothing, as arcs that were left open along a border of a piece may all
    // be beyond it. The group is examined with room for the shift of the sides of boxes.
    [[nodiscard]] bool holds_nothing(Ranges group) const {
        for (size_t i = 0; i < 4; ++i) {
            const Interval domain = domain_along(surfaces_[i / 2]->grid, i % 2);
            const double room = 4 * shift_of_sides * (domain.upper - domain.lower);
            group[i] = {group[i].lower - room, group[i].upper + room};
            keep_in_domain(i, group[i]);
        }
        touch_.narrow(group);
        return touch_.is_apart(group);
    }

    // Widens a touch, as long as it stays one, to take in what rounding leaves around it.
    void widen(Ranges &group) const {
        for (const double times : {64.0, 16.0, 4.0}) {
            Ranges wide = group;
            for (size_t i = 0; i < 4; ++i) {
                const double room = (times - 1) / 2 * (group[i].upper - group[i].lower);
                wide[i] = {group[i].lower - room, group[i].upper + room};
                keep_in_domain(i, wide[i]);
            }
            if (touch_.is_touch(wide)) {
                group = wide;
                return;
            }
        }
    }

    [[nodiscard]] double period(size_t i) const noexcept {
        const SurfaceBorders &borders = surfaces_[i / 2]->borders;
        return borders.wraps(i % 2) ? borders.period(i % 2) : 0;
    }
    // Moves a range into the domain. Where that closes, the range may run beyond the upper end, and one that
    // is as long as the period is the whole domain.
    void keep_in_domain(size_t i, Interval &range) const noexcept {
        const Interval domain = domain_along(surfaces_[i / 2]->grid, i % 2);
        if (period(i) == 0) {
            range = {std::max(range.lower, domain.lower), std::min(range.upper, domain.upper)};
        } else if (range.upper - range.lower >= period(i)) {
            range = domain;
        } else if (range.lower < domain.lower) {
            range = {range.lower + period(i), range.upper + period(i)};
        }
    }
    static double size_of(const Ranges &ranges) noexcept {
        return std::max(ranges[0].upper - ranges[0].lower, ranges[1].upper - ranges[1].lower);
    }
    // Extends `all` to hold `own`, across a seam where that makes it shorter.
    void enclose(const Ranges &own, Ranges &all) const noexcept {
        for (size_t i = 0; i < 4; ++i) {
            Interval best{-infinity, infinity};
            for (const double shift : {0.0, period(i), -period(i)}) {
                const Interval both{std::min(all[i].lower, own[i].lower + shift),
                                    std::max(all[i].upper, own[i].upper + shift)};
                best = both.upper - both.lower < best.upper - best.lower ? both : best;
            }
            all[i] = best;
            keep_in_domain(i, all[i]);
        }
    }

    // Larger groups, which come first, absorb those near them. A group that is not a touch takes only what is
    // near its original place; otherwise groups in a row would all become one.
    void absorb() {
        std::vector<Ranges> ranges;
        for (const Part &group : groups_) {
            ranges.push_back(group.ranges);
        }
        const RangesTree tree(surfaces_[0]->borders, surfaces_[1]->borders, ranges);
        std::vector<bool> taken(groups_.size(), false);
        std::vector<Part> kept;
        for (size_t i = 0; i < groups_.size(); ++i) {
            if (!taken[i]) {
                taken[i] = true;
                kept.push_back(with_near(groups_[i], tree, taken));
            }
        }
        groups_ = std::move(kept);
    }
    // A group with all that it absorbs. A touch takes whatever is near it; a group that is not one does not
    // take touches.
    [[nodiscard]] Part with_near(const Part &group, const RangesTree &tree, std::vector<bool> &taken) const {
        const bool touch = touch_.is_touch(group.ranges);
        Part all = group;
        for (bool any = true; any;) {
            any = false;
            const Part near = touch ? Part{all.ranges, room_of(all.ranges)} : group;
            tree.visit(widened(near.ranges, near.room), [&](size_t i) {
                const Ranges &own = groups_[i].ranges;
                if (!taken[i] && are_near(near, own) && (touch || !touch_.is_touch(own))) {
                    taken[i] = any = true;
                    enclose(own, all.ranges);
                }
            });
        }
        return all;
    }
    static std::array<double, 4> room_of(const Ranges &ranges) noexcept {
        std::array<double, 4> room{};
        for (size_t i = 0; i < 4; ++i) {
            room[i] = 2 * (ranges[i].upper - ranges[i].lower);
        }
        return room;
    }
    static Ranges widened(Ranges ranges, const std::array<double, 4> &room) noexcept {
        for (size_t k = 0; k < 4; ++k) {
            ranges[k] = {ranges[k].lower - room[k], ranges[k].upper + room[k]};
        }
        return ranges;
    }
    [[nodiscard]] bool are_near(const Part &large, const Ranges &small) const noexcept {
        for (size_t i = 0; i < 4; ++i) {
            bool any = false;
            for (const double shift : {0.0, period(i), -period(i)}) {
                any = any || (small[i].lower + shift <= large.ranges[i].upper + large.room[i] &&
                              small[i].upper + shift >= large.ranges[i].lower - large.room[i]);
            }
            if (!any) {
                return false;
            }
        }
        return true;
    }

    std::array<const CrossSurface *, 2> surfaces_;
    const TouchTest &touch_;
    const std::vector<CrossCluster> &clusters_;
    std::vector<Part> groups_;
};

} // namespace

std::vector<CrossGroup> cross_groups(const CrossSurface &a, const CrossSurface &b, const TouchTest &touch,
                                     const std::vector<CrossCluster> &clusters) {
    return Groups(a, b, touch, clusters).run();
}

} // namespace nrb::intersect
