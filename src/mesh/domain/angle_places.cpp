// SPDX-License-Identifier: MIT
#include "mesh/domain/angle_refinement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::mesh {

namespace {

// Areas in the domain below this share of the product of their extents along the axes count as 0.
constexpr double least_area = 1e-9;
// From a new place, no side that stays is seen under a larger angle: the first for sides that are given, the
// second for those on seams and kinks.
constexpr double most_seen = 2 * std::numbers::pi / 3, most_seen_of_lines = std::numbers::pi / 2;
// Maximum number of triangles that a walk passes, and of those in which flips at a new place are anticipated.
constexpr int most_steps = 64;
constexpr size_t most_ahead = 64;

double angle_at(const Vector3 &x, const Vector3 &a, const Vector3 &b) noexcept {
    return std::atan2(length(cross(a - x, b - x)), dot(a - x, b - x));
}

} // namespace

// The angle opposite the shortest side.
double AngleRefinement::least_angle(const std::array<int32_t, 3> &s) const noexcept {
    const std::array<Vector3, 3> x{at(s[0]), at(s[1]), at(s[2])};
    size_t best = 0;
    double shortest = infinity;
    for (size_t k = 0; k < 3; ++k) {
        const Vector3 side = x[(k + 1) % 3] - x[(k + 2) % 3];
        if (const double square = dot(side, side); square < shortest) {
            shortest = square;
            best = k;
        }
    }
    return angle_at(x[best], x[(best + 1) % 3], x[(best + 2) % 3]);
}

// Twice the signed area in the domain; 0 if its sign is uncertain, given the rounding of parameters, or if it
// is negligible.
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

// The off-centre, on the line from the midpoint of the shortest side to the circumcentre: at the circumcentre
// or before it, where the side is seen under the angle that is aimed at.
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

// Walks from triangle to triangle, each time over a side that the place is beyond, to the triangle that holds
// it or to a side that stays.
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
            place.barrier = int64_t{4} * t + static_cast<int64_t>(out);
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

// A side of a triangle that stays and that a place is too near to, as in Place::barrier; -1: none.
int64_t AngleRefinement::side_seen(const Vector3 &x, int32_t t) const noexcept {
    const auto &s = net_[t].sites;
    for (size_t k = 0; k < 3; ++k) {
        const NetSide &side = net_[t].sides[k];
        const double seen = side.stays ? angle_at(x, at(s[(k + 1) % 3]), at(s[(k + 2) % 3])) : 0;
        if (seen > (side.divides ? most_seen_of_lines : most_seen)) {
            return int64_t{4} * t + static_cast<int64_t>(k);
        }
    }
    return -1;
}

// The same for all triangles that flips at the new place are going to change.
int64_t AngleRefinement::side_in_the_way(const Vector3 &x, int32_t triangle) const {
    std::vector<std::pair<int32_t, int32_t>> open{{triangle, -1}};
    for (size_t i = 0; i < open.size() && i < most_ahead; ++i) {
        const auto [t, from] = open[i];
        if (const int64_t side = side_seen(x, t); side >= 0) {
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

// The point of a triangle in space over a place of the domain.
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

// Where a new vertex makes a triangle better, or the side that is in the way.
AngleRefinement::Place AngleRefinement::place_for(int32_t t) const {
    Place place = walk(t, wanted_place(t, shortest_side(t)));
    if (place.triangle >= 0) {
        place.barrier = side_in_the_way(point_in(place.triangle, place.param), place.triangle);
    }
    return place;
}

} // namespace nrb::mesh
