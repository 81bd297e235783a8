// SPDX-License-Identifier: MIT
#include "mesh/domain/angle_refinement.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// Least distance of a new vertex from others, as a multiple of the shortest side of the triangle: less than
// 1, since the place in the domain is not quite where it is wanted in space.
constexpr double least_of_shortest = 0.85;
// Triangles with a smaller angle are segments, as all are where an axis has degree 0.
constexpr double no_angle = 1e-6;
constexpr int most_tries = 4, most_passes = 32;
// As least_of_shortest, for the halves of a longest side, where no other place will do.
constexpr double least_half = 0.4;
// Maximum number of such halvings for each triangle that is bad at the start.
constexpr int64_t most_halvings_of_bad = 8;
// Multiply-adds, estimated: to look at the angles of a triangle, and at whether a side is better flipped.
constexpr int64_t work_of_a_look = 200, work_of_a_side = 400;
// Maximum number of new places for each equilateral triangle that there is room for at the start.
constexpr double most_places = 6;

} // namespace

bool AngleRefinement::fails(int32_t t) const {
    const auto &s = net_[t].sites;
    if (std::ranges::any_of(s, [&](int32_t site) { return is_fixed(site); }) ||
        least_angle(s) >= rule_.angle) {
        return false;
    }
    const int64_t barrier = place_for(t).barrier;
    return barrier < 0 ||
           net_[static_cast<int32_t>(barrier / 4)].sides[static_cast<size_t>(barrier % 4)].divides;
}

// A triangle at a pole is not bad, nor is one whose smallest angle lies between two given sides, as at the
// border.
bool AngleRefinement::is_bad(int32_t t) const noexcept {
    const auto &s = net_[t].sites;
    const double least = least_angle(s);
    if (has_pole(t) || !(least < rule_.angle * room && least > no_angle)) {
        return false;
    }
    const size_t k = shortest_side(t);
    const auto is_given = [&](size_t m) {
        const NetSide &side = net_[t].sides[m % 3];
        return side.stays && !side.divides;
    };
    return !(is_given(k + 1) && is_given(k + 2));
}

// Marks poles, and the sites at sides that can neither be flipped nor divided.
void AngleRefinement::join() {
    std::vector<int32_t> points;
    for (const Site &site : sites_.all()) {
        points.push_back(site.point);
    }
    net_.join(points);
    fixed_.assign(points.size(), 0);
    poles_.assign(points.size(), 0);
    for (int32_t t = 0; t < net_.size(); ++t) {
        for (const int32_t site : net_[t].sites) {
            if (cells_.pole_at(sites_[site].param) >= 0) {
                poles_[static_cast<size_t>(site)] = fixed_[static_cast<size_t>(site)] = 1;
            }
        }
    }
    for (int32_t t = 0; t < net_.size(); ++t) {
        for (size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<size_t>(net_[t].sites[(k + 1) % 3]),
                       b = static_cast<size_t>(net_[t].sites[(k + 2) % 3]);
            NetSide &side = net_.side(t, k);
            if (poles_[a] != 0 || poles_[b] != 0) {
                side.stays = true;
                side.divides = false;
            }
            if (side.stays && !side.divides) {
                fixed_[a] = fixed_[b] = 1;
            }
        }
    }
    set_budget();
    // A fixed site fixes all sites of its point.
    std::vector<char> at_points(static_cast<size_t>(sites_.point_count()), 0);
    for (size_t i = 0; i < points.size(); ++i) {
        at_points[static_cast<size_t>(points[i])] |= fixed_[i];
    }
    for (size_t i = 0; i < points.size(); ++i) {
        fixed_[i] = at_points[static_cast<size_t>(points[i])];
    }
}

// A triangle has room for about as many equilateral ones as the ratio of its longest side to its height.
void AngleRefinement::set_budget() {
    double room_for = 0;
    for (int32_t t = 0; t < net_.size(); ++t) {
        const auto &s = net_[t].sites;
        const size_t k = longest_side(t);
        const double longest = side_length(s[(k + 1) % 3], s[(k + 2) % 3]),
                     twice_area = length(cross(at(s[1]) - at(s[0]), at(s[2]) - at(s[0])));
        room_for += twice_area > 0 ? longest * longest / twice_area : 1;
    }
    constexpr double most = 1 << 28;
    budget_ = static_cast<int64_t>(std::min(most_places * room_for + 1000, most));
}

void AngleRefinement::want(int32_t t) {
    if (is_bad(t)) {
        const auto &s = net_[t].sites;
        waiting_.push_back({-least_angle(s), {t, s[0], s[1], s[2]}});
        std::ranges::push_heap(waiting_);
    }
}

// Removes the triangle if it is one half of a fin. Otherwise inserts a vertex that is no nearer to others
// than about the length of the shortest side.
bool AngleRefinement::improve(int32_t t) {
    for (size_t side = 0; side < 3; ++side) {
        if (net_.remove_fin(t, side)) {
            return true;
        }
    }
    const size_t k = shortest_side(t);
    const auto &s = net_[t].sites;
    const double shortest = side_length(s[(k + 1) % 3], s[(k + 2) % 3]);
    if (!(shortest > rule_.shortest)) {
        return false;
    }
    const Place place = place_for(t);
    const bool done = place.barrier >= 0 ? halve(static_cast<int32_t>(place.barrier / 4),
                                                 static_cast<size_t>(place.barrier % 4), shortest)
                                         : place.triangle >= 0 && insert(place, shortest * least_of_shortest);
    return done || halve_longest(t, shortest * least_half);
}

void AngleRefinement::keep_near() noexcept {
    keeps_near_ = true;
    budget_ = std::min<int64_t>(budget_, net_.size() / 8 + 1000);
}

// Used where flips are restricted (keep_near()). The number of halvings is limited, since for angles near 30
// degrees they would never end.
bool AngleRefinement::halve_longest(int32_t t, double shortest) {
    if (halvings_ <= 0) {
        return false;
    }
    --halvings_;
    return halve(t, longest_side(t), shortest);
}

// Repeats passes as long as there are flips, since one may make another worthwhile.
void AngleRefinement::flip_all() {
    bool any = true;
    for (int pass = 0; pass < most_passes && any && !work_ended(); ++pass) {
        any = false;
        count_work(work_of_a_side * net_.size());
        for (int32_t t = 0; t < net_.size(); ++t) {
            for (size_t k = 0; k < 3; ++k) {
                if (net_[t].sides[k].next > t && is_better_flipped(t, k)) {
                    net_.flip(t, k);
                    any = true;
                }
            }
        }
    }
}

void AngleRefinement::run() {
    flip_all();
    for (int pass = 0; pass < most_tries && improve_all() && !work_ended(); ++pass) {
    }
}

// The worst triangles first. Returns whether anything changed: then some may have room for a vertex that had
// none before.
bool AngleRefinement::improve_all() {
    bool any = false;
    count_work(work_of_a_look * net_.size());
    for (int32_t t = 0; t < net_.size(); ++t) {
        want(t);
    }
    halvings_ = keeps_near_ ? most_halvings_of_bad * std::ssize(waiting_) : 0;
    while (!waiting_.empty() && budget_ > 0 && !work_ended()) {
        std::ranges::pop_heap(waiting_);
        const auto [angle, own] = waiting_.back();
        waiting_.pop_back();
        const std::array<int32_t, 3> sites{own[1], own[2], own[3]};
        if (own[0] < net_.size() && net_[own[0]].sites == sites) {
            any = improve(own[0]) || any;
        }
    }
    waiting_.clear();
    return any;
}

AngleRefinement::Divided AngleRefinement::divide(int32_t t, double longer) {
    const auto &s = net_[t].sites;
    size_t best = 3;
    double most = longer * rule_.scale;
    for (size_t k = 0; k < 3; ++k) {
        const double size = side_length(s[(k + 1) % 3], s[(k + 2) % 3]);
        const NetSide &side = net_[t].sides[k];
        if (size > most && (side.divides || side.border >= 0)) {
            most = size;
            best = k;
        }
    }
    if (best == 3) {
        return {};
    }
    const int32_t border = net_[t].sides[best].border;
    return {border < 0 && halve(t, best, rule_.shortest), border};
}

} // namespace nrb::mesh
