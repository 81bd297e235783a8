// SPDX-License-Identifier: MIT
#include "mesh/domain/angle_refinement.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::mesh {

namespace {

// Multiply-adds of a new vertex with its flips, estimated.
constexpr int64_t work_of_a_vertex = 4000;
// Angles are aimed at by so much more than asked for, so that rounding does not count.
constexpr double room = 1 + 1e-6;
// Of the sizes that areas of the domain are the differences of: what is less is none.
constexpr double least_area = 1e-9;
// Of the shortest side of a triangle, for new ones: places of the domain are not quite where they are wanted in space.
constexpr double least_of_shortest = 0.85;
// New places see no side that stays under a larger angle.
constexpr double most_seen = 2 * std::numbers::pi / 3, most_seen_of_lines = std::numbers::pi / 2;
constexpr size_t most_changed = 64;
// Triangles with smaller ones are segments, as all are where an axis has degree 0.
constexpr double no_angle = 1e-6;
constexpr int most_tries = 4;
// New places for each triangle of equal sides that there is room for at first.
constexpr double most_places = 6;
// Of a side on a seam or a kink, to parts shorter than what is beside it.
constexpr int most_halvings = 10;
constexpr int most_steps = 64, most_passes = 32;

double angle_at(const Vector3 &x, const Vector3 &a, const Vector3 &b) noexcept {
    return std::atan2(length(cross(a - x, b - x)), dot(a - x, b - x));
}

} // namespace

double AngleRefinement::least_angle(const std::array<int32_t, 3> &s) const noexcept {
    double least = 4;
    for (size_t k = 0; k < 3; ++k) {
        least = std::min(least, angle_at(at(s[k]), at(s[(k + 1) % 3]), at(s[(k + 2) % 3])));
    }
    return least;
}

// Twice that in the domain; 0 if it is not certain, as rounded parameters have it, or next to nothing.
double AngleRefinement::area(int32_t a, int32_t b, const std::array<double, 2> &x) const noexcept {
    const auto &p = sites_[a].param, &q = sites_[b].param;
    std::array<double, 2> sides{}, rounding{};
    for (size_t k = 0; k < 2; ++k) {
        sides[k] = std::max(std::abs(q[k] - p[k]), std::abs(x[k] - p[k]));
        rounding[k] = 8 * eps * (std::abs(p[k]) + std::abs(q[k]) + std::abs(x[k]));
    }
    const double result = (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
    const double least = least_area * sides[0] * sides[1] + rounding[0] * sides[1] + rounding[1] * sides[0];
    return std::abs(result) > least ? result : 0;
}

double AngleRefinement::area(const std::array<int32_t, 3> &s) const noexcept {
    return area(s[0], s[1], sites_[s[2]].param);
}

bool AngleRefinement::has_pole(int32_t t) const noexcept {
    const auto is_pole = [&](int32_t site) {
        return static_cast<size_t>(site) < poles_.size() && poles_[static_cast<size_t>(site)] != 0;
    };
    return std::ranges::any_of(net_[t].sites, is_pole);
}

bool AngleRefinement::fails(int32_t t) const {
    const auto &s = net_[t].sites;
    if (std::ranges::any_of(s, [&](int32_t site) { return is_fixed(site); }) ||
        least_angle(s) >= rule_.angle) {
        return false;
    }
    const int32_t barrier = place_for(t).barrier;
    return barrier < 0 || net_[barrier / 4].sides[static_cast<size_t>(barrier % 4)].divides;
}

// Not at poles, nor between two sides of the border.
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

// Poles, and what is at sides that can neither be flipped nor divided.
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
    // All sites of a point.
    std::vector<char> at_points(static_cast<size_t>(sites_.point_count()), 0);
    for (size_t i = 0; i < points.size(); ++i) {
        at_points[static_cast<size_t>(points[i])] |= fixed_[i];
    }
    for (size_t i = 0; i < points.size(); ++i) {
        fixed_[i] = at_points[static_cast<size_t>(points[i])];
    }
}

// A triangle has room for as many of equal sides as it is longer than high.
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

size_t AngleRefinement::shortest_side(int32_t t) const noexcept {
    const auto &s = net_[t].sites;
    size_t best = 0;
    double least = infinity;
    for (size_t k = 0; k < 3; ++k) {
        const double size = side_length(s[(k + 1) % 3], s[(k + 2) % 3]);
        if (size < least) {
            least = size;
            best = k;
        }
    }
    return best;
}

size_t AngleRefinement::longest_side(int32_t t) const noexcept {
    const auto &s = net_[t].sites;
    const auto size = [&](size_t k) { return side_length(s[(k + 1) % 3], s[(k + 2) % 3]); };
    const size_t longer = size(0) >= size(1) ? 0 : 1;
    return size(longer) >= size(2) ? longer : 2;
}

// On the line from the middle of the shortest side to the centre of the circle: there, or before, where the side is seen under the angle.
AngleRefinement::Shares AngleRefinement::wanted_place(int32_t t, size_t k) const noexcept {
    const auto &s = net_[t].sites;
    Shares squares{}, shares{};
    for (size_t m = 0; m < 3; ++m) {
        const double size = side_length(s[(m + 1) % 3], s[(m + 2) % 3]);
        squares[m] = size * size;
    }
    double sum = 0;
    for (size_t m = 0; m < 3; ++m) {
        shares[m] = squares[m] * (squares[(m + 1) % 3] + squares[(m + 2) % 3] - squares[m]);
        sum += shares[m];
    }
    Shares middle{0.5, 0.5, 0.5};
    middle[k] = 0;
    Vector3 way{};
    for (size_t m = 0; m < 3; ++m) {
        shares[m] = shares[m] / sum - middle[m];
        way = way + shares[m] * (at(s[m]) - at(s[k]));
    }
    const double far = std::sqrt(squares[k]) / 2 / std::tan(rule_.angle * room / 2);
    const double part = std::min(1.0, far / length(way));
    for (size_t m = 0; m < 3; ++m) {
        shares[m] = middle[m] + part * shares[m];
    }
    return shares;
}

AngleRefinement::Place AngleRefinement::walk(int32_t t, const Shares &shares) const noexcept {
    Place place;
    for (size_t k = 0; k < 2; ++k) {
        for (size_t m = 0; m < 3; ++m) {
            place.param[k] += shares[m] * sites_[net_[t].sites[m]].param[k];
        }
    }
    int32_t from = -1;
    for (int step = 0; step < most_steps; ++step) {
        const auto &s = net_[t].sites;
        size_t out = 3;
        double most = 0;
        for (size_t k = 0; k < 3; ++k) {
            const double own = area(s[(k + 1) % 3], s[(k + 2) % 3], place.param);
            if (own < most && net_[t].sides[k].next != from) {
                most = own;
                out = k;
            }
        }
        if (out == 3) {
            place.triangle = t;
            return place;
        }
        const NetSide &side = net_[t].sides[out];
        if (side.stays) {
            place.barrier = 4 * t + static_cast<int32_t>(out);
            return place;
        }
        from = t;
        t = side.next;
    }
    return place;
}

bool AngleRefinement::is_near(const Vector3 &x, int32_t t, double distance) const noexcept {
    const auto is_close = [&](int32_t site) { return length(at(site) - x) < distance; };
    bool near = std::ranges::any_of(net_[t].sites, is_close);
    for (size_t k = 0; k < 3; ++k) {
        near = near || (!net_[t].sides[k].stays && is_close(net_.beyond(t, k)));
    }
    return near;
}

// One of a triangle that stays and that a place is too near to; -1: none.
int32_t AngleRefinement::side_seen(const Vector3 &x, int32_t t) const noexcept {
    const auto &s = net_[t].sites;
    for (size_t k = 0; k < 3; ++k) {
        const NetSide &side = net_[t].sides[k];
        const double seen = side.stays ? angle_at(x, at(s[(k + 1) % 3]), at(s[(k + 2) % 3])) : 0;
        if (seen > (side.divides ? most_seen_of_lines : most_seen)) {
            return 4 * t + static_cast<int32_t>(k);
        }
    }
    return -1;
}

// The same of all triangles that are going to be changed by flips.
int32_t AngleRefinement::side_in_the_way(const Vector3 &x, int32_t triangle) const {
    std::vector<std::pair<int32_t, int32_t>> open{{triangle, -1}};
    for (size_t i = 0; i < open.size() && i < most_changed; ++i) {
        const auto [t, from] = open[i];
        if (const int32_t side = side_seen(x, t); side >= 0) {
            return side;
        }
        const auto &s = net_[t].sites;
        for (size_t k = 0; k < 3; ++k) {
            const NetSide &side = net_[t].sides[k];
            if (side.stays || side.next == from) {
                continue;
            }
            const Vector3 &a = at(s[(k + 1) % 3]), &b = at(s[(k + 2) % 3]);
            if (angle_at(x, a, b) + angle_at(at(net_.beyond(t, k)), a, b) > std::numbers::pi) {
                open.emplace_back(side.next, t);
            }
        }
    }
    return -1;
}

int32_t AngleRefinement::make_site(const std::array<double, 2> &param, int32_t t) {
    std::array<double, 2> middle{};
    for (const int32_t site : net_[t].sites) {
        for (size_t k = 0; k < 2; ++k) {
            middle[k] += sites_[site].param[k] / 3;
        }
    }
    const auto fresh = static_cast<int32_t>(sites_.all().size());
    const int32_t site = sites_.of_param(param, cells_.tree().block_at(middle), -1);
    sites_.evaluate();
    count_work(work_of_a_vertex);
    --budget_;
    return site == fresh ? site : -1;
}

// Whether all triangles at a new place in side k are as they have to be in the domain.
bool AngleRefinement::makes_triangles(int32_t t, size_t k, const std::array<double, 2> &x) const noexcept {
    const auto &s = net_[t].sites;
    const bool one = area(s[k], s[(k + 1) % 3], x) > 0 && area(s[(k + 2) % 3], s[k], x) > 0;
    const NetSide &side = net_[t].sides[k];
    if (side.stays || !one) {
        return one;
    }
    const int32_t beyond = net_.beyond(t, k);
    return area(beyond, s[(k + 2) % 3], x) > 0 && area(s[(k + 1) % 3], beyond, x) > 0;
}

// In the middle; on both sides of a seam or a kink.
bool AngleRefinement::halve(int32_t t, size_t k, double shortest) {
    const NetSide side = net_[t].sides[k];
    const auto &s = net_[t].sites;
    const int32_t a = s[(k + 1) % 3], b = s[(k + 2) % 3];
    const double size = side_length(a, b);
    const bool can = size > 2 * shortest * (1 - 1e-9) ||
                     (side.stays && side.halvings < most_halvings && size > 2 * rule_.shortest);
    if (!side.divides || !net_.can_change(t, k) || !can) {
        return false;
    }
    if (side.next >= 0 && sites_[s[k]].point == sites_[net_.beyond(t, k)].point) {
        return false;
    }
    const auto middle = [&](int32_t from, int32_t to) {
        const auto &p = sites_[from].param, &q = sites_[to].param;
        return std::array<double, 2>{p[0] / 2 + q[0] / 2, p[1] / 2 + q[1] / 2};
    };
    const std::array<double, 2> x = middle(a, b);
    if (!makes_triangles(t, k, x)) {
        return false;
    }
    const int32_t v = make_site(x, t);
    int32_t w = v;
    if (side.stays) {
        const auto &other = net_[side.next].sites;
        const auto j = static_cast<size_t>(side.back);
        const std::array<double, 2> y = middle(other[(j + 1) % 3], other[(j + 2) % 3]);
        if (!makes_triangles(side.next, j, y)) {
            return false;
        }
        w = make_site(y, side.next);
    }
    if (v < 0 || w < 0 || sites_[v].point != sites_[w].point ||
        (!side.stays && is_near(at(v), t, shortest))) {
        return false;
    }
    const int32_t second = net_.size();
    net_.split_side(t, k, v, w);
    settle(v, {t, second, side.stays ? -1 : side.next, side.stays ? -1 : second + 1});
    if (side.stays) {
        settle(w, {side.next, second + 1, -1, -1});
    }
    return true;
}

bool AngleRefinement::insert(const Place &place, double shortest) {
    const int32_t t = place.triangle;
    const std::array<int32_t, 3> s = net_[t].sites;
    for (size_t k = 0; k < 3; ++k) { // on a side, or as good as that
        if (area(s[(k + 1) % 3], s[(k + 2) % 3], place.param) <= 1e-3 * area(s)) {
            const NetSide side = net_[t].sides[k];
            if (side.stays || !net_.can_change(t, k) || !makes_triangles(t, k, place.param) ||
                sites_[s[k]].point == sites_[net_.beyond(t, k)].point) {
                return false;
            }
            const int32_t v = make_site(place.param, t);
            if (v < 0 || is_near(at(v), t, shortest)) {
                return false;
            }
            const int32_t second = net_.size();
            net_.split_side(t, k, v, v);
            settle(v, {t, second, side.next, second + 1});
            return true;
        }
    }
    const bool alone =
        std::ranges::none_of(net_[t].sides, [&](const NetSide &side) { return side.next == t; });
    if (!alone) {
        return false;
    }
    const int32_t v = make_site(place.param, t);
    if (v < 0 || is_near(at(v), t, shortest)) {
        return false;
    }
    const int32_t second = net_.size();
    net_.split_triangle(t, v);
    settle(v, {t, second, second + 1, -1});
    return true;
}

// Whether a side leads from a corner of a triangle, or from another copy of it, to a point: around a closed axis that may be another way
// than that over the side in front of the corner.
bool AngleRefinement::are_joined(int32_t start, size_t corner, int32_t point) const noexcept {
    const int32_t centre = sites_[net_[start].sites[corner]].point;
    const auto is_point = [&](int32_t site, int32_t other) { return sites_[site].point == other; };
    for (const size_t turn : {size_t{1}, size_t{2}}) {
        int32_t t = start;
        size_t k = corner;
        for (size_t i = 0; i < most_changed; ++i) {
            if (std::ranges::any_of(net_[t].sites, [&](int32_t site) { return is_point(site, point); })) {
                return true;
            }
            const NetSide &side = net_[t].sides[(k + turn) % 3];
            if (side.next < 0 || side.next == start) {
                break;
            }
            const auto back = static_cast<size_t>(side.back);
            t = side.next;
            k = is_point(net_[t].sites[(back + 1) % 3], centre) ? (back + 1) % 3 : (back + 2) % 3;
        }
    }
    return false;
}

// New sides have to be such as are allowed, and triangles have to be as they are in the domain.
bool AngleRefinement::is_better_flipped(int32_t t, size_t k) const noexcept {
    const NetSide &side = net_[t].sides[k];
    if (side.stays || has_pole(t) || has_pole(side.next) || !net_.can_change(t, k)) {
        return false;
    }
    const auto &s = net_[t].sites;
    const int32_t p = s[k], a = s[(k + 1) % 3], b = s[(k + 2) % 3], q = net_.beyond(t, k);
    const std::array<int32_t, 3> one{p, a, q}, other{p, q, b};
    const double before = std::min(least_angle(s), least_angle(net_[side.next].sites));
    return area(one) > 0 && area(other) > 0 &&
           std::min(least_angle(one), least_angle(other)) > before * (1 + 1e-9) &&
           rule_.is_allowed_side(p, q) && !are_joined(t, k, sites_[q].point);
}

// Flips around a new site, where triangles are beside each other.
void AngleRefinement::settle(int32_t site, std::array<int32_t, 4> around) {
    to_flip_.clear();
    const auto add = [&](int32_t t) {
        want(t);
        for (size_t k = 0; k < 3; ++k) {
            if (net_[t].sites[k] == site) {
                to_flip_.emplace_back(t, k);
            }
        }
    };
    for (const int32_t t : around) {
        if (t >= 0) {
            add(t);
        }
    }
    while (!to_flip_.empty()) {
        const auto [t, k] = to_flip_.back();
        to_flip_.pop_back();
        if (net_[t].sites[k] == site && is_better_flipped(t, k)) {
            const int32_t other = net_[t].sides[k].next;
            net_.flip(t, k);
            add(t);
            add(other);
        }
    }
}

void AngleRefinement::want(int32_t t) {
    if (is_bad(t)) {
        const auto &s = net_[t].sites;
        waiting_.push_back({-least_angle(s), {t, s[0], s[1], s[2]}});
        std::ranges::push_heap(waiting_);
    }
}

// On the triangle over a place.
Vector3 AngleRefinement::point_in(int32_t t, const std::array<double, 2> &param) const noexcept {
    const auto &s = net_[t].sites;
    Vector3 x{};
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double share = area(s[(k + 1) % 3], s[(k + 2) % 3], param);
        x = x + share * at(s[k]);
        sum += share;
    }
    return (1 / sum) * x;
}

// Where a new vertex makes a triangle better, or what is in the way.
AngleRefinement::Place AngleRefinement::place_for(int32_t t) const {
    Place place = walk(t, wanted_place(t, shortest_side(t)));
    if (place.triangle >= 0) {
        place.barrier = side_in_the_way(point_in(place.triangle, place.param), place.triangle);
    }
    return place;
}

// By a place that is no nearer to others than the ends of its shortest side are to each other.
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
    return place.barrier >= 0 ? halve(place.barrier / 4, static_cast<size_t>(place.barrier % 4), shortest)
                              : place.triangle >= 0 && insert(place, shortest * least_of_shortest);
}

// As long as one makes another one better.
void AngleRefinement::flip_all() {
    bool any = true;
    for (int pass = 0; pass < most_passes && any; ++pass) {
        any = false;
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

// The worst ones first. Returns whether there is something new: then some may have room for what they had none for before.
bool AngleRefinement::improve_all() {
    bool any = false;
    for (int32_t t = 0; t < net_.size(); ++t) {
        want(t);
    }
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
    double most = longer;
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
