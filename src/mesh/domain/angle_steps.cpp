// SPDX-License-Identifier: MIT
#include "mesh/domain/angle_refinement.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// Multiply-adds of a new vertex with its flips, estimated.
constexpr int64_t work_of_a_vertex = 4000;
// How often a side on a seam or a kink is halved although its parts become shorter than the sides beside it.
constexpr int most_halvings = 10;
// Maximum number of triangles around a point that are examined.
constexpr size_t most_around_point = 64;

} // namespace

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

// Whether all triangles at a new place on side k are counterclockwise in the domain.
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

// At the midpoint; on a seam or a kink, with a site on both of its sides.
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
    std::array<double, 2> y = x; // on the other side
    if (side.stays) {
        const auto &other = net_[side.next].sites;
        const auto j = static_cast<size_t>(side.back);
        y = middle(other[(j + 1) % 3], other[(j + 2) % 3]);
        if (!makes_triangles(side.next, j, y)) {
            return false;
        }
    }
    const int32_t v = make_site(x, t), w = side.stays ? make_site(y, side.next) : v;
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
    for (size_t k = 0; k < 3; ++k) { // on a side, or nearly so
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

// Whether a side already leads from a corner of a triangle, or from another copy of that corner, to a point.
// Around a closed axis it may lead another way than across the side opposite the corner.
bool AngleRefinement::are_joined(int32_t start, size_t corner, int32_t point) const noexcept {
    const int32_t centre = sites_[net_[start].sites[corner]].point;
    const auto is_point = [&](int32_t site, int32_t other) { return sites_[site].point == other; };
    for (const size_t turn : {size_t{1}, size_t{2}}) {
        int32_t t = start;
        size_t k = corner;
        for (size_t i = 0; i < most_around_point; ++i) {
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

// Whether a flip enlarges the smallest angle of the two triangles. The new side has to be allowed, and the
// new triangles have to be counterclockwise in the domain.
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
           rule_.is_allowed_side(p, q) && (!keeps_near_ || rule_.is_near_side(p, q)) &&
           !are_joined(t, k, sites_[q].point);
}

// Flips sides opposite a new site, as long as that enlarges angles. around: the triangles at the site; -1:
// none.
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

} // namespace nrb::mesh
