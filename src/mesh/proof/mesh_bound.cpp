// SPDX-License-Identifier: MIT
#include "mesh/proof/mesh_bound.h"

#include "mesh/proof/star_bound.h"
#include "mesh/proof/views.h"

#include <algorithm>
#include <numbers>

namespace nrb::mesh {

namespace {

constexpr double share_of_half_right = 0.94; // for images that come out within 45 degrees
// Of the angles of two triangles at a common corner: if the first is less than most_own, or the second less
// than most_other, both and 45 degrees add up to less than 360 degrees, as seen along the normal of the
// first.
constexpr double most_own = 2.35, most_other = 1.83;

} // namespace

MeshBound::MeshBound(size_t points, std::span<const MeshTriangle> triangles,
                     std::span<const TriangleBound> bounds, std::span<const int32_t> wanted)
    : bounds_(bounds), points_(points), neighbours_(points, triangles, wanted) {
    for (int32_t i = 0; i < static_cast<int32_t>(points); ++i) {
        if (!neighbours_.fan(i).empty()) {
            set_point(i);
        }
    }
}

void MeshBound::set_point(int32_t number) {
    Point &point = points_[static_cast<size_t>(number)];
    const std::span<const int32_t> fan = neighbours_.fan(number);
    for (const int32_t triangle : fan) {
        point.normal = point.normal + bounds_[static_cast<size_t>(triangle)].normal;
    }
    const bool none = point.normal.x == 0 && point.normal.y == 0 && point.normal.z == 0;
    point.normal = none ? point.normal : unit(point.normal);
    for (size_t i = 0; i < fan.size(); ++i) {
        const auto triangle = static_cast<size_t>(fan[i]);
        for (size_t k = 0; k < 3 && (i == 0 || fan[i - 1] != fan[i]); ++k) {
            if (neighbours_[triangle].points[k] == number) {
                add_corner(triangle, k, point);
            }
        }
    }
    // As angles are seen, less than twice around; a fan at the border may go around once.
    const double cosine = 1 - point.turned * point.turned / 2;
    if (!(point.angle < (point.on_border ? 2 : 4) * std::numbers::pi * cosine)) {
        point.turned = 2;
    }
}

void MeshBound::add_corner(size_t triangle, size_t corner, Point &point) const noexcept {
    const TriangleBound &bound = bounds_[triangle];
    const double turned = bound.has_plane() ? length(bound.normal - point.normal) + 8 * eps : 2;
    point.turned = std::max(point.turned, turned);
    point.angle += bound.angles[corner];
    point.altitude = std::min(point.altitude, bound.least_altitude());
    point.height = std::max(point.height, bound.height);
    point.out = std::max(point.out, bound.out);
    point.beside = std::max(point.beside, bound.beside);
    for (size_t k = 0; k < 3; ++k) {
        if (k != corner && neighbours_[triangle].border[k]) {
            point.on_border = true;
        }
    }
}

// The chords of two angles add up to at least the chord of their sum.
MeshBound::Around MeshBound::around(size_t triangle) const noexcept {
    Around all;
    for (size_t k = 0; k < 3; ++k) {
        const Point &point = point_of(triangle, k);
        all.turned =
            std::max(all.turned, point.turned + length(bounds_[triangle].normal - point.normal) + 8 * eps);
        all.altitude = std::min(all.altitude, point.altitude);
        all.height = std::max(all.height, point.height);
        all.out = std::max(all.out, point.out);
        all.beside = std::max(all.beside, point.beside);
        all.on_border = all.on_border || point.on_border;
    }
    return all;
}

// Whether, at the ends of a side, the surface over the triangle comes out within the angles of the triangle
// across, and the images of the other sides of the latter come inside within them. Factors of the cosine
// allow for foreshortening.
bool MeshBound::is_beside(size_t triangle, size_t side, const Neighbour &next) const noexcept {
    const TriangleBound &own = bounds_[triangle], &other = bounds_[static_cast<size_t>(next.triangle)];
    const double cosine = dot(own.normal, other.normal) - 8 * eps;
    bool result = length(own.normal - other.normal) + 8 * eps < most_turned_by_sides;
    for (const size_t end : {size_t{1}, size_t{2}}) { // the two run along the side in opposite directions
        const size_t k = (side + end) % 3, j = (next.side + 3 - end) % 3;
        const double most = share_of_sines * cosine * cosine * other.sines[j];
        // At corner k, side k + 1 comes first and side k + 2 second. Number 2 - end is the common side in the
        // first triangle, and the other side at that corner in the second one.
        result = result && own.turns[k][2 - end] < most && other.leans[j][2 - end] < most &&
                 other.turns[j][2 - end] < share_of_half_right * cosine &&
                 (own.angles[k] < most_own || other.angles[j] < most_other);
    }
    return result;
}

Distances MeshBound::over_side(size_t triangle, size_t side) const noexcept {
    const TriangleBound &own = bounds_[triangle];
    const Neighbour next = neighbours_.across(triangle, side);
    if (next.triangle < 0 || !is_beside(triangle, side, next)) {
        return {infinity, infinity};
    }
    const TriangleBound &other = bounds_[static_cast<size_t>(next.triangle)];
    const double cosine = dot(own.normal, other.normal) - 8 * eps,
                 sine = length(cross(own.normal, other.normal)) + 8 * eps;
    const double near = own.height_over(side), beside = other.height_over(next.side);
    return {near + own.outs[side] * (sine / cosine),
            std::max(beside * cosine + other.outs[next.side] * sine, beside / cosine)};
}

Distances MeshBound::over_border(size_t triangle, size_t side) const noexcept {
    const TriangleBound &own = bounds_[triangle];
    const bool along = own.turns[(side + 1) % 3][1] < infinity && own.turns[(side + 2) % 3][0] < infinity;
    return {along ? diagonal(own.height_over(side), own.outs[side]) : infinity, own.sides[side]};
}

// For the chord c of the angle a, cos a = 1 - c^2 / 2 and sin a <= c, so that tan a <= c / cos a. Let x be a
// point over a point p of T that belongs to another triangle U of the star, at height h' above U and out of
// it by r'. The line through x along n meets the plane of U at most h' / cos a from x and at most
// r' + h' tan a from U. From there to p, the plane of U and the star diverge with a slope of at most 2 tan a.
Distances MeshBound::by_star(size_t triangle, const Around &around) const noexcept {
    const double cosine = 1 - around.turned * around.turned / 2;
    const double slope = around.turned / cosine, parting = 2.1 * around.turned / (cosine * cosine);
    const TriangleBound &own = bounds_[triangle];
    return {std::max(own.height, own.height_beyond() + own.out * slope) * rounded_sum,
            (around.height / cosine + (around.out + around.height * slope) * parting) * rounded_sum};
}

Distances MeshBound::by_sides(size_t triangle) const noexcept {
    const TriangleBound &own = bounds_[triangle];
    Distances result{own.height, own.height};
    for (size_t k = 0; k < 3; ++k) {
        const Distances over =
            neighbours_[triangle].border[k] ? over_border(triangle, k) : over_side(triangle, k);
        result.from_shape = std::max(result.from_shape, over.from_shape * rounded_sum);
        result.from_mesh = std::max(result.from_mesh, over.from_mesh * rounded_sum);
    }
    return result;
}

double MeshBound::edge_about(size_t triangle, double from_mesh) const noexcept {
    const TriangleBound &own = bounds_[triangle];
    double result = own.edge;
    for (size_t k = 0; k < 3; ++k) {
        const Neighbour next =
            neighbours_[triangle].border[k] ? Neighbour{} : neighbours_.across(triangle, k);
        const double edge = next.triangle < 0 ? 0 : bounds_[static_cast<size_t>(next.triangle)].edge;
        if (edge > 0) {
            const TriangleBound &other = bounds_[static_cast<size_t>(next.triangle)];
            const double sine = length(cross(own.normal, other.normal)) + 8 * eps;
            result = std::max(
                result,
                (edge + (std::min(edge, other.outs[next.side]) + std::max(from_mesh, other.height)) * sine) *
                    rounded_sum);
        }
    }
    return result;
}

// The star comes first, since it takes the least time.
Distances MeshBound::distances(size_t triangle, double enough, double allowed) const {
    const TriangleBound &own = bounds_[triangle];
    Distances best{own.from_shape(), own.from_mesh()};
    const auto take = [&](const Distances &other) {
        best.from_shape = std::min(best.from_shape, other.from_shape);
        best.from_mesh = std::min(best.from_mesh, other.from_mesh);
    };
    const Around all = around(triangle);
    const double cosine = 1 - all.turned * all.turned / 2;
    if (!all.on_border && all.turned < most_turned &&
        std::max(all.out + all.height, all.beside) < share_of_altitude * all.altitude * cosine) {
        take(by_star(triangle, all));
    }
    if (!(best.most() <= enough)) {
        take(by_sides(triangle));
    }
    if (!(best.most() <= allowed) && !all.on_border && all.turned < 2) {
        take(star_bound(neighbours_, bounds_, triangle, allowed));
    }
    return best;
}

} // namespace nrb::mesh
