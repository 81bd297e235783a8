// SPDX-License-Identifier: MIT
#include "build/conics/conic_conditions.h"

#include "base/error.h"
#include "build/conics/arc.h"
#include "build/plane_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace nrb::build {

namespace {

std::vector<double> copy(Coordinates x) {
    return {x.begin(), x.end()};
}

// Points (x, y, w) of the projective plane, at infinity if w is 0; or the coefficients (a, b, c) of lines a x
// + b y + c w = 0.
struct Projective {
    DoubleDouble x;
    DoubleDouble y;
    DoubleDouble w;
};

Projective cross(const Projective &a, const Projective &b) noexcept {
    return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

DoubleDouble norm(const Point2 &v) noexcept {
    return square_root(dot(v, v));
}

ConicArc arc_in(const PlaneFrame &plane, Coordinates a, Coordinates b, const Point2 &middle,
                const DoubleDouble &weight) {
    return make_conic_arc(copy(a), copy(b), plane.point(b), middle, weight,
                          [&plane](const Point2 &v) { return plane.vector(v); });
}

// The circular arc from a, the origin of the plane, to b with a given tangent at a. Half the angle of the arc
// is the angle between the tangent and the chord.
ConicArc circle_over(Coordinates a, Coordinates b, const PlaneFrame &plane, const Point2 &tangent) {
    const Point2 chord = plane.point(b);
    const DoubleDouble width = norm(chord), size = norm(tangent);
    const DoubleDouble cosine = dot(tangent, chord) / (width * size);
    return arc_in(plane, a, b, width * DoubleDouble(0.5) / size * tangent, cosine);
}

// The pencil of conics through the origin and the end of a chord c with the tangents s and t there. A conic
// of the pencil is given by a factor k: in offsets from the origin, its homogeneous control point between the
// ends is (k (c x t) s, k (s x t)), where x is the plane cross product. A point r0 (0, 1) + r1 ((c x t) s, s
// x t) + r2 (c, 1) of the plane is on it for k = r1 / (2 sqrt(r0 r2)).
class TangentPencil {
public:
    TangentPencil(const Point2 &chord, const Point2 &tangent_a, const Point2 &tangent_b)
        : chord_(chord), s_(tangent_a), t_(tangent_b), middle_(cross(chord, tangent_b)),
          weight_(cross(tangent_a, tangent_b)) {}

    struct Ratios {
        DoubleDouble r0;
        DoubleDouble r1;
        DoubleDouble r2;
    };
    [[nodiscard]] Ratios ratios(const Point2 &p) const noexcept {
        return {cross(chord_ - p, t_) / middle_, cross(p, chord_) / (middle_ * cross(s_, chord_)),
                cross(p, s_) / cross(chord_, s_)};
    }
    [[nodiscard]] bool degenerate(double rounding) const noexcept {
        return !(std::fabs(middle_.value()) > rounding * length(t_)) ||
               !(std::fabs(cross(s_, chord_).value()) > rounding * length(s_));
    }
    [[nodiscard]] Point2 middle(const DoubleDouble &k) const noexcept { return (k * middle_) * s_; }
    [[nodiscard]] DoubleDouble weight(const DoubleDouble &k) const noexcept { return k * weight_; }

private:
    Point2 chord_;
    Point2 s_;
    Point2 t_;
    DoubleDouble middle_;
    DoubleDouble weight_;
};

DoubleDouble factor_through(const TangentPencil::Ratios &r) {
    if (!(r.r0.value() > 0) || !(r.r2.value() > 0)) {
        fail(Status::conic,
             "no arc in one piece with these tangents passes through the point, whose barycentric "
             "coordinates at a "
             "and b, %s and %s, would have to be positive",
             Number(r.r0.value()).text, Number(r.r2.value()).text);
    }
    return r.r1 / (DoubleDouble(2) * square_root(r.r0 * r.r2));
}

ConicArc arc_of_pencil(Coordinates a, Coordinates b, const PlaneFrame &plane, const TangentPencil &pencil,
                       const DoubleDouble &factor) {
    return arc_in(plane, a, b, pencil.middle(factor), pencil.weight(factor));
}

// The tangent at p[0] of the conic through five points, by Pascal's theorem for the hexagon 0 0 1 2 3 4: the
// opposite sides 01 and 34, 12 and 40, 23 and the tangent meet in three points of one line.
Point2 pascal_tangent(const std::array<Projective, 5> &p) noexcept {
    const Projective first = cross(cross(p[0], p[1]), cross(p[3], p[4]));
    const Projective second = cross(cross(p[1], p[2]), cross(p[4], p[0]));
    const Projective third = cross(cross(first, second), cross(p[2], p[3]));
    return {third.x - third.w * p[0].x, third.y - third.w * p[0].y};
}

std::array<Projective, 5> reversed(const std::array<Projective, 5> &p) noexcept {
    return {p[4], p[3], p[2], p[1], p[0]};
}

Point2 affine(const Projective &p) noexcept {
    return {p.x, p.y};
}

[[noreturn]] void refuse_line(size_t i, size_t j, size_t k) {
    constexpr const char *reason = "are on a line, or two of them are equal, to within rounding";
    fail(Status::collinear, "points[%zu], points[%zu] and points[%zu] %s", i, j, k, reason);
}

void check_triangles(const std::array<Projective, 5> &p, double rounding) {
    for (size_t i = 0; i < 5; ++i) {
        for (size_t j = i + 1; j < 5; ++j) {
            for (size_t k = j + 1; k < 5; ++k) {
                const Point2 a = affine(p[j]) - affine(p[i]), b = affine(p[k]) - affine(p[i]);
                const double longest = std::max({length(a), length(b), length(b - a)});
                if (!(std::fabs(cross(a, b).value()) > rounding * longest)) {
                    refuse_line(i, j, k);
                }
            }
        }
    }
}

// Checks that points 1 to 3 lie on the arc of a factor in this order: along the arc, the ratio r2 / r0
// increases from 0 to infinity.
void check_order(const TangentPencil &pencil, const std::array<Projective, 5> &p,
                 const DoubleDouble &factor) {
    double last = 0;
    for (size_t i = 1; i < 4; ++i) {
        const TangentPencil::Ratios r = pencil.ratios(affine(p[i]));
        const double r0 = r.r0.value(), r2 = r.r2.value();
        const bool on_arc = r0 > 0 && r2 > 0 && (r.r1 * factor).value() > 0;
        if (!on_arc || !(r2 / r0 > last)) {
            fail(Status::conic,
                 "points[%zu] is not behind the others on one arc of their conic from points[0] to points[4]",
                 i);
        }
        last = r2 / r0;
    }
}

struct Crossing {
    double alpha;
    double beta;
    double miss;  // distance between the two points
    double sine;  // of the angle between the lines
    double reach; // the longer of the distances from a and b
};

DoubleDouble wide_dot(std::span<const DoubleDouble> a, std::span<const DoubleDouble> b) noexcept {
    DoubleDouble sum;
    for (size_t i = 0; i < a.size(); ++i) {
        sum = sum + a[i] * b[i];
    }
    return sum;
}

// The points a + alpha s and b - beta t at which two lines come closest. The directions have lengths near 1.
// In double-double precision, lines at small angles meet as accurately as others.
Crossing closest(Coordinates a, Coordinates s, Coordinates b, Coordinates t) {
    const std::vector<DoubleDouble> u(s.begin(), s.end()), v(t.begin(), t.end());
    std::vector<DoubleDouble> chord;
    for (size_t i = 0; i < a.size(); ++i) {
        chord.push_back(DoubleDouble::sum(b[i], -a[i]));
    }
    const DoubleDouble uu = wide_dot(u, u), uv = wide_dot(u, v), vv = wide_dot(v, v);
    const DoubleDouble uc = wide_dot(u, chord), vc = wide_dot(v, chord), determinant = uu * vv - uv * uv;
    const DoubleDouble alpha = (uc * vv - uv * vc) / determinant, beta = (vc * uu - uv * uc) / determinant;
    double miss = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        miss = std::hypot(miss, (alpha * u[i] + beta * v[i] - chord[i]).value());
    }
    const double lengths = std::sqrt(uu.value()) * std::sqrt(vv.value());
    const double reach = std::max(std::fabs(alpha.value()) * std::sqrt(uu.value()),
                                  std::fabs(beta.value()) * std::sqrt(vv.value()));
    return {alpha.value(), beta.value(), miss, std::sqrt(std::max(0.0, determinant.value())) / lengths,
            reach};
}

// A direction times the power of two that brings its largest component into [1, 2).
std::vector<double> scaled_direction(Coordinates v) {
    double size = 0;
    for (const double x : v) {
        size = std::max(size, std::fabs(x));
    }
    std::vector<double> out = copy(v);
    for (double &x : out) {
        x = std::ldexp(x, -std::ilogb(size));
    }
    return out;
}

double largest_coordinate(Coordinates a, Coordinates b) noexcept {
    double size = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        size = std::max({size, std::fabs(a[i]), std::fabs(b[i])});
    }
    return size;
}

} // namespace

SplinePtr arc_through(Coordinates a, Coordinates b, Coordinates c, int32_t form) {
    check_arc_form(form);
    const PlaneFrame plane(a, c, b, "a, b and c");
    // The inscribed angle at b is half a turn minus the angle between the tangent at a and the chord from a
    // to c.
    const Point2 p = plane.point(b), chord = plane.point(c);
    const DoubleDouble cosine = dot(p, chord - p), sine = cross(p, chord);
    const Point2 tangent{cosine * chord.x + sine * chord.y, cosine * chord.y - sine * chord.x};
    const ConicArc arc = circle_over(a, c, plane, tangent);
    return conic_curve({&arc, 1}, form);
}

SplinePtr arc_tangent(Coordinates a, Coordinates tangent, Coordinates b, int32_t form) {
    check_arc_form(form);
    const std::vector<double> direction = scaled_direction(tangent);
    std::vector<double> beside = copy(a);
    double length = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        length = std::hypot(length, b[i] - a[i]);
    }
    for (size_t i = 0; i < a.size(); ++i) {
        beside[i] += length * direction[i];
    }
    const PlaneFrame plane(a, b, beside, "a, b and the tangent at a");
    const ConicArc arc = circle_over(a, b, plane, plane.direction(tangent));
    return conic_curve({&arc, 1}, form);
}

SplinePtr conic_shoulder(Coordinates a, Coordinates tangent_a, Coordinates b, Coordinates tangent_b,
                         double rho) {
    if (!(rho >= 0 && rho < 1)) {
        fail(Status::factor, "rho = %s, expected 0 <= rho < 1", Number(rho).text);
    }
    const std::vector<double> s = scaled_direction(tangent_a), t = scaled_direction(tangent_b);
    const Crossing crossing = closest(a, s, b, t);
    if (!(crossing.sine > 8 * 0x1p-52)) {
        fail(Status::conic, "the tangents are parallel to within rounding: the sine of their angle is %s",
             Number(crossing.sine).text);
    }
    if (!(crossing.alpha > 0) || !(crossing.beta > 0)) {
        fail(Status::conic,
             "the tangents meet at %s along tangent_a from a and %s against tangent_b from b, expected "
             "positive lengths",
             Number(crossing.alpha).text, Number(crossing.beta).text);
    }
    if (crossing.miss > 16 * 0x1p-52 * (largest_coordinate(a, b) + crossing.reach)) {
        fail(Status::conic, "the tangents pass each other at a distance of %s", Number(crossing.miss).text);
    }
    std::vector<double> corner = copy(a);
    for (size_t i = 0; i < corner.size(); ++i) {
        corner[i] += crossing.alpha * s[i];
    }
    return conic_segment(static_cast<int>(a.size()), a.data(), corner.data(), b.data(), rho / (1 - rho));
}

SplinePtr conic_point(Coordinates a, Coordinates tangent_a, Coordinates b, Coordinates tangent_b,
                      Coordinates point, int32_t form) {
    check_arc_form(form, arc_thirds);
    const PlaneFrame plane(a, b, point, "a, b and the point");
    plane.check_direction(tangent_a, "tangent_a");
    plane.check_direction(tangent_b, "tangent_b");
    const TangentPencil pencil(plane.point(b), plane.direction(tangent_a), plane.direction(tangent_b));
    if (pencil.degenerate(plane.rounding())) {
        fail(Status::conic, "a tangent is along the chord from a to b to within rounding, %s of its length",
             Number(plane.rounding()).text);
    }
    const ConicArc arc =
        arc_of_pencil(a, b, plane, pencil, factor_through(pencil.ratios(plane.point(point))));
    return conic_curve({&arc, 1}, form);
}

SplinePtr conic_through(Coordinates points, int dim, int32_t form) {
    check_arc_form(form, arc_thirds);
    const auto width = static_cast<size_t>(dim);
    const auto place = [&](size_t i) { return points.subspan(i * width, width); };
    const PlaneFrame plane(place(0), place(4), place(2), "points[0], points[4] and points[2]");
    plane.check_point(place(1), "points[1]");
    plane.check_point(place(3), "points[3]");
    std::array<Projective, 5> p{};
    for (size_t i = 0; i < 5; ++i) {
        const Point2 x = plane.point(place(i));
        p[i] = {x.x, x.y, DoubleDouble(1)};
    }
    check_triangles(p, plane.rounding());
    const TangentPencil pencil(affine(p[4]), pascal_tangent(p), pascal_tangent(reversed(p)));
    if (pencil.degenerate(plane.rounding())) {
        fail(Status::conic,
             "the conic through the points has a tangent along the chord from points[0] to points[4]");
    }
    const DoubleDouble factor = factor_through(pencil.ratios(affine(p[2])));
    check_order(pencil, p, factor);
    const ConicArc arc = arc_of_pencil(place(0), place(4), plane, pencil, factor);
    return conic_curve({&arc, 1}, form);
}

} // namespace nrb::build
