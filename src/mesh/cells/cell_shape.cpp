// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_shape.h"

#include "mesh/proof/pairs.h"

#include <cmath>

namespace nrb::mesh {

namespace {

// A cell that needs more parts than this along an axis is halved.
constexpr double most_parts = 8;
// The share of the width of a cell by which the surface may come out of a triangle and still be over adjacent
// triangles only.
constexpr double most_out = 0.25;
// The largest relative variation of second derivatives over parts that count as alike.
constexpr double most_varied = 0.1;
// By what factor the halves of a cell exceed the tolerance: from certainly_over on, both of them do for
// certain; from far_over on, a half needs more than most_parts / 2 parts.
constexpr double certainly_over = 2, far_over = 16;
// The approximate weight of slopes in the bounds of MeshBound.
constexpr double slope_times = 0.05;

Vector3 point_of(const double *corner) noexcept {
    return (1 / corner[3]) * Vector3{corner[0], corner[1], corner[2]};
}

// The unit vector of v, or another one if v has no direction.
Vector3 direction(const Vector3 &v, const Vector3 &other) noexcept {
    const double size = length(v);
    return size > 0 && std::isfinite(size) ? (1 / size) * v : other;
}

Vector3 any_across(const Vector3 &t) noexcept {
    const Vector3 least = std::abs(t.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    return direction(cross(t, least), {0, 0, 1});
}

} // namespace

HessianBox box_about(const CellCorners &corners) noexcept {
    const Vector3 a = point_of(corners[0]), b = point_of(corners[1]), c = point_of(corners[2]),
                  d = point_of(corners[3]);
    const Vector3 along = direction((b - a) + (c - d), direction((d - a) + (c - b), {1, 0, 0}));
    const Vector3 product = cross(c - a, d - b);
    const Vector3 across = product - dot(product, along) * along;
    const Vector3 normal = direction(across, any_across(along));
    return HessianBox(a, {along, cross(normal, along), normal}, corners);
}

namespace {

// For each of the two sides along axis k, let N be the coordinate of A - w P in the plane of the cell and
// across that side, with P on it, so that N is 0 at both of its ends. The result is the most |second
// derivative| of N along the side, for both sides.
double beside_sides(const HessianBox &box, size_t k) noexcept {
    const Hessian &coordinate = box.of(1 - k), &weight = box.of(3);
    const Range &a = k == 0 ? coordinate.uu : coordinate.vv, &w = k == 0 ? weight.uu : weight.vv;
    const auto on_side = [&](double end) {
        const double p = end * box.speed(1 - k), middle = a.middle - p * w.middle, u = a.u - p * w.u,
                     v = a.v - p * w.v;
        return std::abs(middle + (end - 0.5) * (k == 0 ? v : u)) + std::abs(k == 0 ? u : v) / 2 + a.radius +
               p * w.radius;
    };
    return std::max(on_side(0), on_side(1));
}

} // namespace

CellBend bend_of(const HessianBox &box) noexcept {
    const Hessian &height = box.of(2);
    const double w = box.mean_weight();
    const auto divided = [&](const Range &range) {
        return Range{range.middle / w, range.u / w, range.v / w, range.radius / w};
    };
    const Hessian heights{divided(height.uu), divided(height.uv), divided(height.vv), height.rest / w};
    const double u = box.speed(0), v = box.speed(1), uv = heights.uv.most();
    return {heights,
            {beside_sides(box, 0) / w / 8, beside_sides(box, 1) / w / 8},
            {u, v},
            {heights.uu.most() / u, uv / v, uv / u, heights.vv.most() / v}};
}

namespace {

using Place = std::array<double, 2>;

// How far heights are from their linear interpolant over the triangle abc of three corners of a part, whose
// places are relative to the middle of the cell: b differs from a along u, and from c along v.
double over_triangle(const Hessian &h, const Place &a, const Place &b, const Place &c) noexcept {
    const double u = b[0] - a[0], v = c[1] - b[1];
    const auto bends = [&](const Place &x) { // second derivatives along the sides opposite of a, b and c
        const double uu = h.uu.at(x[0], x[1]) * u * u, vv = h.vv.at(x[0], x[1]) * v * v;
        return Four(vv, uu + 2 * h.uv.at(x[0], x[1]) * u * v + vv, uu, 0);
    };
    const double all = h.beside(u, v);
    return Bend({bends(a), bends(b), bends(c)}, {h.vv.radius * v * v, all, h.uu.radius * u * u, all}, h.rest)
        .both();
}

} // namespace

// The change of slopes over a part of u by v sides of the cell, at most 1.
double CellBend::slope(double u, double v) const noexcept {
    const double most =
        std::max(diagonal(slopes[0] * u, slopes[1] * u), diagonal(slopes[2] * v, slopes[3] * v));
    return std::isfinite(most) ? std::min(most, 1.0) : 1.0;
}

// Adds what comes out over the sides, `out`, to a height. Where a triangle has others around it, it counts by
// the slopes of these only (mesh_bound.h).
double CellBend::with_out(double height, double u, double v) const noexcept {
    const double out = std::max(beside[0] * u * u, beside[1] * v * v);
    const double width = std::min(speeds[0] * u, speeds[1] * v);
    return alone || out > most_out * width ? diagonal(height, out)
                                           : height + (out + height) * slope_times * slope(u, v);
}

// Of all parts, the one in the middle of which the surface bends most counts.
double CellBend::in_parts(double u_parts, double v_parts) const noexcept {
    const double u = 1 / u_parts, v = 1 / v_parts, a = u / 2, b = v / 2;
    const auto part = [&](const Range &range) {
        const double away = (std::abs(range.u) * (1 - u) + std::abs(range.v) * (1 - v)) / 2;
        return Range{range.middle < 0 ? range.middle - away : range.middle + away, range.u, range.v,
                     range.radius};
    };
    const double rest = heights.rest * (u * u * v * v); // its terms are of fourth order or higher
    const Hessian h{part(heights.uu), part(heights.uv), part(heights.vv), rest};
    // Triangles are going to have the diagonal along which the surface bends less in the middle of the cell.
    const bool rising = std::abs(heights.along(u, v)) <= std::abs(heights.along(u, -v));
    const double height = rising ? std::max(over_triangle(h, {-a, -b}, {a, -b}, {a, b}),
                                            over_triangle(h, {a, b}, {-a, b}, {-a, -b}))
                                 : std::max(over_triangle(h, {a, -b}, {-a, -b}, {-a, b}),
                                            over_triangle(h, {-a, b}, {a, b}, {a, -b}));
    return with_out(height, u, v);
}

namespace {

// As few parts along both axes as keep to the tolerance; two each if an axis needs many.
std::array<double, 2> parts_for(const CellBend &bend, double chord) noexcept {
    std::array<double, 2> parts{1, 1};
    while (!(bend.in_parts(parts[0], parts[1]) <= chord)) {
        const bool first = bend.in_parts(2 * parts[0], parts[1]) <= bend.in_parts(parts[0], 2 * parts[1]);
        double &more = parts[first ? 0 : 1];
        more *= 2;
        if (more > most_parts) {
            return {2, 2};
        }
    }
    for (double &own : parts) {
        do {
            own -= 1;
        } while (own > 1 && bend.in_parts(parts[0], parts[1]) <= chord);
        own += 1;
    }
    return parts;
}

// Whether the surface bends about as much in all parts along an axis.
bool are_alike(const Hessian &heights, size_t axis) noexcept {
    const Range &range = axis == 0 ? heights.uu : heights.vv;
    return !(range.width() > most_varied * std::abs(range.middle));
}

// A cut of so many equal parts into two groups that are as equal as possible; in the middle if there are many
// parts.
Cut halves(size_t axis, double parts) noexcept {
    return {axis, parts > 2 && parts <= most_parts ? std::floor(parts / 2) / parts : 0.5};
}

} // namespace

namespace {

// The axis along which both halves of a cell are best cut in the middle, if that is certain: halves exceed
// the tolerance by the factor `over`.
std::optional<size_t> cut_of_halves(const CellBend &bend, size_t axis, double over) noexcept {
    if (!(over > certainly_over)) {
        return std::nullopt;
    }
    const double both = bend.in_parts(2, 2);
    const bool first = axis == 0 ? bend.in_parts(4, 1) <= both : both <= bend.in_parts(1, 4);
    const size_t next = first ? 0 : 1;
    return over > far_over || !are_alike(bend.heights, next) ? std::optional(next) : std::nullopt;
}

} // namespace

Cut best_cut(const CellBend &bend, double chord) noexcept {
    const double u = bend.in_parts(2, 1), v = bend.in_parts(1, 2);
    const size_t axis = u <= v ? 0 : 1;
    Cut cut = halves(axis, are_alike(bend.heights, axis) ? parts_for(bend, chord)[axis] : 2);
    if (cut.share == 0.5) {
        cut.next = cut_of_halves(bend, axis, std::min(u, v) / chord);
    }
    return cut;
}

// The slopes of the surface over the plane of the cell change by second derivatives of its height.
CellTurn turn_of(const HessianBox &box, double least) noexcept {
    const Hessian &height = box.of(2);
    const double mixed = height.uv.most(), w = box.least_weight();
    std::array<std::array<double, 2>, 2> slopes{}; // [towards][along]
    for (size_t k = 0; k < 2; ++k) {
        if (box.move(k == 0 ? 1 : 0, k == 0 ? 0 : 1) > least) {
            const double speed = box.speed(k) * w, own = (k == 0 ? height.uu : height.vv).most();
            slopes[k][k] = own / speed;
            slopes[k][1 - k] = mixed / speed;
        }
    }
    return {{diagonal(slopes[0][0], slopes[1][0]), diagonal(slopes[0][1], slopes[1][1])},
            diagonal(slopes[0][0] + slopes[0][1], slopes[1][0] + slopes[1][1])};
}

// The axis may use what the other one leaves of the angle, in squares, but no less than half of it.
Cut cut_for_angle(const HessianBox &box, const CellTurn &turn, double angle) noexcept {
    const size_t axis = turn.along[0] >= turn.along[1] ? 0 : 1;
    const double other = turn.along[1 - axis];
    const double room = std::sqrt(std::max(angle * angle - other * other, angle * angle / 2));
    return halves(axis, are_alike(box.of(2), axis) ? std::ceil(turn.along[axis] / room) : 2);
}

} // namespace nrb::mesh
