// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/cones.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::intersect {

namespace {

using Rays = std::vector<TangentRay>;

// The largest product of quotients that counts as less than 1: the margin is far more than rounding.
constexpr double most_product = 0.999;

// The sum of the unit vectors along the rays; 0 if there are none.
Vector3 mean_of(const Rays &rays) noexcept {
    Vector3 sum;
    for (const TangentRay &ray : rays) {
        sum = sum + (1 / std::max(length(ray.way), 1e-300)) * ray.way;
    }
    return sum;
}

// The range of y / x; x > 0.
Interval quotient(const Interval &y, const Interval &x) noexcept {
    return {y.lower / (y.lower < 0 ? x.lower : x.upper), y.upper / (y.upper < 0 ? x.upper : x.lower)};
}

// The range of the scalar product, with the error of the ray and rounding. size: length of the vector.
Interval along(const TangentRay &ray, const Vector3 &vector, double size) noexcept {
    const double at = dot(ray.way, vector), room = size * (ray.off + 4 * eps * length(ray.way));
    return {at - room, at + room};
}

// The range of the quotients of the components of rays along y and x; none if a component along x may not be
// positive.
std::optional<Interval> quotients(const Rays &rays, const Vector3 &y, const Vector3 &x) {
    Interval all{infinity, -infinity};
    const double size_y = length(y), size_x = length(x);
    count_work(12 * std::ssize(rays));
    for (const TangentRay &ray : rays) {
        const Interval on_x = along(ray, x, size_x);
        if (!(on_x.lower > 0)) {
            return std::nullopt;
        }
        const Interval own = quotient(along(ray, y, size_y), on_x);
        all = {std::min(all.lower, own.lower), std::max(all.upper, own.upper)};
    }
    return rays.empty() ? std::nullopt : std::optional(all);
}

double magnitude(const Interval &x) noexcept {
    return std::max(std::abs(x.lower), std::abs(x.upper));
}

// The range of all products.
Interval largest_product(const Interval &a, const Interval &b) noexcept {
    const auto [least, most] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return {least, most};
}

} // namespace

// The plane is spanned by the mean directions of both derivatives, which are its axes.
bool are_cones_apart(const std::vector<Tangents> &parts) {
    std::array<Rays, 2> rays;
    for (const Tangents &part : parts) {
        part.add_rays(0, std::nullopt, rays[0]);
        part.add_rays(1, std::nullopt, rays[1]);
    }
    const Vector3 u = mean_of(rays[0]), v = mean_of(rays[1]), normal = cross(u, v);
    const double size = dot(normal, normal);
    if (!(size > 0x1p-40 * dot(u, u) * dot(v, v))) {
        return false;
    }
    const Vector3 p = (1 / size) * cross(v, normal), q = (1 / size) * cross(normal, u);
    const std::optional<Interval> turns_u = quotients(rays[0], q, p);
    const std::optional<Interval> turns_v = turns_u ? quotients(rays[1], p, q) : std::nullopt;
    return turns_v && largest_product(*turns_u, *turns_v).upper <= most_product;
}

namespace {

// The cones of columns at a pole, in a plane whose normal is the mean of those of the columns.
class PolarCones {
public:
    PolarCones(size_t axis, size_t end) : axis_(axis), end_(end) {}

    bool add_all(const std::vector<std::vector<Tangents>> &columns) {
        Vector3 sum;
        for (const std::vector<Tangents> &column : columns) {
            const Column &own = columns_.emplace_back(rays_of(column));
            sum = sum + unit(cross(mean_of(own.out), mean_of(own.round)));
        }
        normal_ = unit(sum);
        return dot(normal_, normal_) > 0 &&
               std::ranges::all_of(columns_, [&](const Column &column) { return add(column); });
    }
    [[nodiscard]] bool are_apart() const noexcept { return most_radial_ * most_angular_ <= most_product; }
    // The largest range of the angle of S - O within one column.
    [[nodiscard]] double wide() const noexcept { return wide_; }
    [[nodiscard]] const Vector3 &normal() const noexcept { return normal_; }

private:
    // Rays of S - O (out), of S_v directed away from the pole (away), and of S_u (round). S - O and S_u are
    // divided by the distance from the pole in the domain.
    struct Column {
        Rays out, away, round;
    };

    [[nodiscard]] Column rays_of(const std::vector<Tangents> &column) const {
        const Vector3 pole = column.front().corner(axis_ == 0 ? end_ : 0, axis_ == 1 ? end_ : 0);
        Column rays;
        for (size_t i = 0; i < column.size(); ++i) {
            const std::optional<size_t> without = i == 0 ? std::optional(end_) : std::nullopt;
            column[i].add_rays_from(pole, axis_, without, rays.out);
            column[i].add_rays(axis_, std::nullopt, rays.away);
            column[i].add_rays(1 - axis_, without, rays.round);
        }
        for (TangentRay &ray : rays.away) {
            ray.way = (end_ == 0 ? 1 : -1) * ray.way;
        }
        return rays;
    }
    // In the basis (out, round), up to positive factors, S - O is (1, t) with t in `outs`, S_v is (1, t')
    // with t' in `aways`, and S_u is (c, 1) with c in `rounds`. The angle from S - O to S_v has the tangent
    // (t' - t) / (1 + t t'), that to S_u the cotangent (c + t) / (1 - c t).
    bool add(const Column &column) {
        constexpr double least = 0.001;
        const Vector3 mean = mean_of(column.out), out = unit(mean - dot(mean, normal_) * normal_),
                      round = cross(normal_, out);
        const std::optional<Interval> outs = quotients(column.out, round, out),
                                      aways = quotients(column.away, round, out),
                                      rounds = quotients(column.round, out, round);
        if (!outs || !aways || !rounds) {
            return false;
        }
        const double cosine = 1 + largest_product(*outs, *aways).lower,
                     sine = 1 - largest_product(*outs, *rounds).upper;
        if (!(cosine > least && sine > least)) {
            return false;
        }
        most_radial_ = std::max(most_radial_,
                                magnitude({aways->lower - outs->upper, aways->upper - outs->lower}) / cosine);
        most_angular_ = std::max(
            most_angular_, magnitude({rounds->lower + outs->lower, rounds->upper + outs->upper}) / sine);
        wide_ = std::max(wide_, std::atan(outs->upper) - std::atan(outs->lower));
        return true;
    }

    size_t axis_, end_;
    std::vector<Column> columns_;
    Vector3 normal_;
    double most_radial_ = 0, most_angular_ = 0, wide_ = 0;
};

// The angle that the side opposite to the pole covers. Each column covers less than half a turn, so that its
// corners determine its share.
double turn_of(const std::vector<std::vector<Tangents>> &columns, size_t axis, size_t end,
               const Vector3 &normal) noexcept {
    double turn = 0;
    for (const std::vector<Tangents> &column : columns) {
        const auto corner = [&](const Tangents &part, size_t at, size_t other) {
            return axis == 0 ? part.corner(at, other) : part.corner(other, at);
        };
        const Vector3 pole = corner(column.front(), end, 0), from = corner(column.back(), 1 - end, 0) - pole,
                      to = corner(column.back(), 1 - end, 1) - pole;
        const double sine = dot(normal, cross(from, to)),
                     cosine = dot(from, to) - dot(from, normal) * dot(to, normal);
        turn += std::atan2(sine, cosine);
    }
    return turn;
}

} // namespace

bool are_polar_cones_apart(const std::vector<std::vector<Tangents>> &columns, size_t axis, size_t end,
                           bool closed) {
    constexpr double whole = 2 * std::numbers::pi;
    PolarCones cones(axis, end);
    if (!cones.add_all(columns) || !cones.are_apart()) {
        return false;
    }
    const double turn = turn_of(columns, axis, end, cones.normal());
    return closed ? std::abs(turn - whole) < 1 : turn + 2 * cones.wide() < 0.999 * whole;
}

} // namespace nrb::intersect
