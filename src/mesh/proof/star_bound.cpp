// SPDX-License-Identifier: MIT
#include "mesh/proof/star_bound.h"

#include "mesh/proof/views.h"

#include <cmath>
#include <numbers>

namespace nrb::mesh {

namespace {

double cosine_of(double chord) noexcept {
    return 1 - chord * chord / 2;
}
// From above: the sine is at most the chord.
double tangent_of(double chord) noexcept {
    return chord / cosine_of(chord);
}

class Star {
public:
    Star(const Neighbours &neighbours, std::span<const TriangleBound> bounds, size_t triangle)
        : neighbours_(neighbours), bounds_(bounds), triangle_(triangle), own_(bounds[triangle]),
          star_(neighbours.star(triangle)) {
        for (const StarTriangle &u : star_) {
            turned_ = std::max(turned_, chord_between(own_, of(u)));
        }
    }

    // Whether what the star says of T holds.
    [[nodiscard]] bool holds() const noexcept;
    [[nodiscard]] double from_shape(double enough) const noexcept;
    [[nodiscard]] double from_mesh(double enough) const noexcept;

private:
    [[nodiscard]] const TriangleBound &of(const StarTriangle &u) const noexcept {
        return bounds_[static_cast<size_t>(u.triangle)];
    }
    [[nodiscard]] double seen_angle(const Neighbour &next, size_t corner) const noexcept;
    [[nodiscard]] bool comes_out_over(size_t side, const Neighbour &next) const noexcept;
    [[nodiscard]] bool stays_within(const StarTriangle &u, size_t end) const noexcept;
    [[nodiscard]] bool is_excluded(const StarTriangle &u) const noexcept;
    [[nodiscard]] double beside(const StarTriangle &u) const noexcept;
    [[nodiscard]] double over_corner(const StarTriangle &u, double enough) const noexcept;
    // How far points of S(U) are from U, as seen along the normal.
    [[nodiscard]] double reach(const TriangleBound &u) const noexcept {
        return u.out + u.height * tangent_of(chord_between(own_, u));
    }

    const Neighbours &neighbours_;
    std::span<const TriangleBound> bounds_;
    size_t triangle_;
    const TriangleBound &own_;
    std::vector<StarTriangle> star_;
    double turned_ = 0;
};

bool Star::holds() const noexcept {
    double altitude = infinity, most = own_.out;
    for (const StarTriangle &u : star_) {
        altitude = std::min(altitude, of(u).altitudes[u.corner]);
        most = std::max({most, reach(of(u)), u.shares_side ? 0 : of(u).sides[u.corner]});
    }
    return !star_.empty() && turned_ < most_turned &&
           most < share_of_altitude * altitude * cosine_of(turned_);
}

// A lower bound on the angle at a corner: at most a right angle, and 0 if the triangle is turned too far.
double Star::seen_angle(const Neighbour &next, size_t corner) const noexcept {
    const TriangleBound &v = bounds_[static_cast<size_t>(next.triangle)];
    const double chord = chord_between(own_, v), cosine = cosine_of(chord);
    return chord < most_turned_by_sides
               ? std::asin(std::min(1.0, share_of_sines * cosine * cosine * v.sines[corner]))
               : 0;
}

// Whether S(T) comes out over a side only over the triangle across.
bool Star::comes_out_over(size_t side, const Neighbour &next) const noexcept {
    const auto within = [&](size_t end) {
        return std::atan(own_.turns[(side + end) % 3][2 - end]) < seen_angle(next, (next.side + 3 - end) % 3);
    };
    return next.triangle >= 0 && within(1) && within(2);
}

double Star::from_shape(double enough) const noexcept {
    double result = own_.height;
    for (size_t k = 0; k < 3; ++k) {
        const double height = own_.height_over(k), any = height + own_.out * tangent_of(turned_);
        const Neighbour next = any <= enough ? Neighbour{} : neighbours_.across(triangle_, k);
        result = std::max(result, comes_out_over(k, next)
                                      ? height + own_.outs[k] *
                                                     tangent_of(chord_between(
                                                         own_, bounds_[static_cast<size_t>(next.triangle)]))
                                      : any);
    }
    return result * rounded_sum;
}

// Whether S(U) comes out, over the first (1) or second (2) side at the common corner, within an angle that is smaller
// than the angles of the triangles up to T: goes around the corner from one of them to the next.
bool Star::stays_within(const StarTriangle &u, size_t end) const noexcept {
    constexpr int most_between = 16;
    const int32_t corner = neighbours_[static_cast<size_t>(u.triangle)].points[u.corner];
    const double turn = std::atan(of(u).turns[u.corner][end - 1] / cosine_of(chord_between(own_, of(u))));
    double gap = 0;
    Neighbour at{u.triangle, u.corner};
    for (int i = 0; i < most_between && turn < std::numbers::pi / 2 - 1e-3; ++i) {
        at = neighbours_.across(static_cast<size_t>(at.triangle), (at.side + end) % 3);
        if (at.triangle < 0 || static_cast<size_t>(at.triangle) == triangle_) {
            return false;
        }
        const auto &points = neighbours_[static_cast<size_t>(at.triangle)].points;
        at.side = static_cast<size_t>(std::ranges::find(points, corner) - points.begin());
        gap += seen_angle(at, at.side);
        if (turn < gap) {
            return true;
        }
    }
    return false;
}

bool Star::is_excluded(const StarTriangle &u) const noexcept {
    return chord_between(own_, of(u)) < most_turned_by_sides && stays_within(u, 1) && stays_within(u, 2);
}

double Star::beside(const StarTriangle &u) const noexcept {
    const double height = of(u).height_over(u.corner), cosine = dot(own_.normal, of(u).normal) - 8 * eps,
                 sine = length(cross(own_.normal, of(u).normal)) + 8 * eps;
    return std::max(height * cosine + of(u).outs[u.corner] * sine, height / cosine);
}

// 0 if no point of S(U) is over T.
double Star::over_corner(const StarTriangle &u, double enough) const noexcept {
    const double chord = chord_between(own_, of(u)), cosine = cosine_of(turned_), far = reach(of(u));
    const double height =
        (chord < most_turned_by_sides ? of(u).height_beyond() : of(u).height) / cosine_of(chord);
    const double any = height + far * (tangent_of(chord) + tangent_of(turned_));
    if (any <= enough || is_excluded(u)) {
        return any <= enough ? any : 0;
    }
    double parting = tangent_of(chord);
    for (const StarTriangle &v : star_) {
        parting = std::max(parting, chord_between(of(u), of(v)) / (cosine * cosine));
    }
    return std::min(any, height + far * parting);
}

double Star::from_mesh(double enough) const noexcept {
    double result = own_.height;
    for (const StarTriangle &u : star_) {
        const bool by_side = u.shares_side && chord_between(own_, of(u)) < most_turned_by_sides;
        result = std::max(result, by_side ? beside(u) : over_corner(u, enough));
    }
    return result * rounded_sum;
}

} // namespace

Distances star_bound(const Neighbours &neighbours, std::span<const TriangleBound> bounds, size_t triangle,
                     double enough) {
    const Star star(neighbours, bounds, triangle);
    return star.holds() ? Distances{star.from_shape(enough), star.from_mesh(enough)}
                        : Distances{infinity, infinity};
}

} // namespace nrb::mesh
