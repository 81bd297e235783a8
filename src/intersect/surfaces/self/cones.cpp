// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/cones.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::intersect {

namespace {

// What products of quotients may be at most: less than 1 by far more than their rounding.
constexpr double most_product = 0.999;

void enclose(const Interval &own, Interval &all) noexcept {
    all = {std::min(all.lower, own.lower), std::max(all.upper, own.upper)};
}

// y / x with x > 0.
Interval quotient(const Interval &y, const Interval &x) noexcept {
    return {y.lower / (y.lower < 0 ? x.lower : x.upper), y.upper / (y.upper < 0 ? x.upper : x.lower)};
}

double magnitude(const Interval &x) noexcept {
    return std::max(std::abs(x.lower), std::abs(x.upper));
}

bool are_products_below_one(const Interval &a, const Interval &b) noexcept {
    return std::max({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper}) <=
           most_product;
}

} // namespace

// The plane is that of the mean directions of both derivatives, which are its axes.
bool are_cones_apart(const std::vector<CrossCell *> &cells) {
    Vector3 u, v;
    for (const CrossCell *cell : cells) {
        u = u + unit(cell->slope(0));
        v = v + unit(cell->slope(1));
    }
    const Vector3 normal = cross(u, v);
    const double size = dot(normal, normal);
    if (!(size > 0x1p-40 * dot(u, u) * dot(v, v))) {
        return false;
    }
    const Vector3 p = (1 / size) * cross(v, normal), q = (1 / size) * cross(normal, u);
    Interval turns_u{infinity, -infinity}, turns_v{infinity, -infinity};
    for (const CrossCell *cell : cells) {
        count_work(400);
        const CrossExtents on_p = cell->along(p), on_q = cell->along(q);
        if (!(on_p.slopes[0].lower > 0 && on_q.slopes[1].lower > 0)) {
            return false;
        }
        enclose(quotient(on_q.slopes[0], on_p.slopes[0]), turns_u);
        enclose(quotient(on_p.slopes[1], on_q.slopes[1]), turns_v);
        if (!are_products_below_one(turns_u, turns_v)) {
            return false;
        }
    }
    return true;
}

namespace {

// What is known of columns at a pole, as a plane sees it.
class PolarCones {
public:
    PolarCones(size_t axis, size_t end) : axis_(axis), sign_(end == 0 ? 1 : -1) {}

    bool set_plane(const std::vector<std::vector<CrossCell *>> &columns) {
        Vector3 sum;
        for (const auto &column : columns) {
            for (const CrossCell *cell : column) {
                sum = sum + unit(cross(away(*cell), cell->slope(1 - axis_)));
            }
        }
        normal_ = unit(sum);
        return dot(normal_, normal_) > 0;
    }

    // Whether angles rise along the column, and points go away from the pole; both kinds of quotients are in all().
    bool add(const std::vector<CrossCell *> &column) {
        const Vector3 slope = away(*column.front()),
                      out = unit(slope - dot(slope, normal_) * normal_), // zero: nothing below holds
            round = cross(normal_, out);
        Interval tilts{infinity, -infinity}, turns{infinity, -infinity};
        for (const CrossCell *cell : column) {
            count_work(4000);
            const CrossBends on_out = cell->bends_along(out), on_round = cell->bends_along(round);
            const Interval away_out = signed_(on_out.extents.slopes[axis_]),
                           away_round = signed_(on_round.extents.slopes[axis_]),
                           twist_out = signed_(on_out.bends[1]), twist_round = signed_(on_round.bends[1]);
            if (!(away_out.lower > 0 && twist_round.lower > 0)) {
                return false;
            }
            enclose(quotient(away_round, away_out), tilts);
            enclose(quotient(twist_out, twist_round), turns);
        }
        return add(tilts, turns);
    }

    [[nodiscard]] bool are_apart() const noexcept { return most_radial_ * most_angular_ <= most_product; }
    // No angle differs more than this at both ends of what begins at the pole.
    [[nodiscard]] double wide() const noexcept { return wide_; }
    [[nodiscard]] const Vector3 &normal() const noexcept { return normal_; }

private:
    [[nodiscard]] Vector3 away(const CrossCell &cell) const noexcept { return sign_ * cell.slope(axis_); }
    [[nodiscard]] Interval signed_(const Interval &x) const noexcept {
        return sign_ > 0 ? x : Interval{-x.upper, -x.lower};
    }
    // S - O and S_v are (1, t) with t in tilts, S_u is (c, 1) with c in turns: their products are 1 + t t', c + t and 1 - c t.
    bool add(const Interval &tilts, const Interval &turns) noexcept {
        const double cosine = 1 + std::min(tilts.lower * tilts.upper, 0.0),
                     sine = 1 - magnitude(tilts) * magnitude(turns);
        if (!(cosine > 0.001 && sine > 0.001)) {
            return false;
        }
        most_radial_ = std::max(most_radial_, (tilts.upper - tilts.lower) / cosine);
        most_angular_ =
            std::max(most_angular_, magnitude({turns.lower + tilts.lower, turns.upper + tilts.upper}) / sine);
        wide_ = std::max(wide_, std::atan(tilts.upper) - std::atan(tilts.lower));
        return true;
    }

    size_t axis_;
    double sign_;
    Vector3 normal_;
    double most_radial_ = 0, most_angular_ = 0, wide_ = 0;
};

// At a corner of a cell.
Vector3 corner_of(const CrossCell &cell, size_t axis, size_t end, size_t other_end) noexcept {
    std::array<double, 2> at{};
    at[axis] = static_cast<double>(end);
    at[1 - axis] = static_cast<double>(other_end);
    return cell.piece().evaluate(cell.in_piece(at.data())).at;
}

// The angle by which what is farthest from the pole goes round, each column by less than half a turn.
double turn_of(const std::vector<std::vector<CrossCell *>> &columns, size_t axis, size_t end,
               const Vector3 &normal) noexcept {
    double turn = 0;
    for (const auto &column : columns) {
        const Vector3 pole = corner_of(*column.front(), axis, end, 0),
                      from = corner_of(*column.back(), axis, 1 - end, 0) - pole,
                      to = corner_of(*column.back(), axis, 1 - end, 1) - pole;
        const double sine = dot(normal, cross(from, to)),
                     cosine = dot(from, to) - dot(from, normal) * dot(to, normal);
        turn += std::atan2(sine, cosine);
    }
    return turn;
}

} // namespace

bool are_polar_cones_apart(const std::vector<std::vector<CrossCell *>> &columns, size_t axis, size_t end,
                           bool closed) {
    constexpr double whole = 2 * std::numbers::pi;
    PolarCones cones(axis, end);
    if (!cones.set_plane(columns)) {
        return false;
    }
    for (const auto &column : columns) {
        if (!cones.add(column)) {
            return false;
        }
    }
    const double turn = turn_of(columns, axis, end, cones.normal());
    return cones.are_apart() &&
           (closed ? std::abs(turn - whole) < 1 : turn + 2 * cones.wide() < 0.999 * whole);
}

} // namespace nrb::intersect
