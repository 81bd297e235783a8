#include "build/conic_conditions.h"

#include "base/error.h"
#include "build/arc.h"
#include "build/plane_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace nrb {

namespace {

using Vector = std::vector<double>;

Vector copy(Coordinates x) {
    return {x.begin(), x.end()};
}

// Points of the plane (x, y, w), at infinity where w is 0; lines a x + b y + c w = 0.
struct Projective {
    double x;
    double y;
    double w;
};

Projective cross(const Projective &a, const Projective &b) noexcept {
    return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

Point2 operator*(double s, Point2 a) noexcept {
    return {s * a.x, s * a.y};
}
double length(Point2 a) noexcept {
    return std::hypot(a.x, a.y);
}

// An arc of a circle from the origin over a chord: it leaves in a direction of which cos and sin are the parts along
// the chord and across it. Half the angle of the arc is that between the tangent and the chord.
ConicArc circle_over(Coordinates a, Coordinates b, const PlaneFrame &plane, Point2 tangent) {
    const Point2 chord = plane.point(b);
    const Point2 unit = (1 / length(tangent)) * tangent;
    const double half = length(chord) / 2;
    const double cosine = (unit.x * chord.x + unit.y * chord.y) / (2 * half);
    return {copy(a), copy(b), plane.vector(half * unit), cosine};
}

// A conic through the origin and the end of a chord c, with tangents s and t there, as a function of a point:
// its homogeneous control point is (k (c x t) s, k (s x t)), in offsets from the origin. A point r0 (0, 1) +
// r1 ((c x t) s, s x t) + r2 (c, 1) of the plane is on it for k = r1 / (2 sqrt(r0 r2)).
class TangentPencil {
public:
    TangentPencil(Point2 chord, Point2 tangent_a, Point2 tangent_b)
        : chord_(chord), s_(tangent_a), t_(tangent_b), middle_(cross(chord, tangent_b)),
          weight_(cross(tangent_a, tangent_b)) {}

    struct Ratios {
        double r0;
        double r1;
        double r2;
    };
    [[nodiscard]] Ratios ratios(Point2 p) const noexcept {
        return {cross(chord_ - p, t_) / middle_, cross(p, chord_) / (middle_ * cross(s_, chord_)),
                cross(p, s_) / cross(chord_, s_)};
    }
    [[nodiscard]] bool degenerate(double rounding) const noexcept {
        return !(std::fabs(middle_) > rounding * length(t_)) ||
               !(std::fabs(cross(s_, chord_)) > rounding * length(s_));
    }
    [[nodiscard]] Point2 middle(double k) const noexcept { return (k * middle_) * s_; }
    [[nodiscard]] double weight(double k) const noexcept { return k * weight_; }

private:
    Point2 chord_;
    Point2 s_;
    Point2 t_;
    double middle_;
    double weight_;
};

double factor_through(const TangentPencil::Ratios &r) {
    if (!(r.r0 > 0) || !(r.r2 > 0)) {
        fail(NURBS_ERROR_CONIC, "no arc in one piece with these tangents passes through the point");
    }
    return r.r1 / (2 * std::sqrt(r.r0 * r.r2));
}

ConicArc arc_of_pencil(Coordinates a, Coordinates b, const PlaneFrame &plane, const TangentPencil &pencil,
                       double factor) {
    return {copy(a), copy(b), plane.vector(pencil.middle(factor)), pencil.weight(factor)};
}

// The tangent at p[0] of the conic through five points, by Pascal's theorem for the hexagon 0 0 1 2 3 4: the sides
// 01 and 34, 12 and 40 and the tangent and 23 meet on one line.
Point2 pascal_tangent(const std::array<Projective, 5> &p) noexcept {
    const Projective first = cross(cross(p[0], p[1]), cross(p[3], p[4]));
    const Projective second = cross(cross(p[1], p[2]), cross(p[4], p[0]));
    const Projective third = cross(cross(first, second), cross(p[2], p[3]));
    return {third.x - third.w * p[0].x, third.y - third.w * p[0].y};
}

std::array<Projective, 5> reversed(const std::array<Projective, 5> &p) noexcept {
    return {p[4], p[3], p[2], p[1], p[0]};
}

void check_triangles(const std::array<Projective, 5> &p, double rounding) {
    for (size_t i = 0; i < 5; ++i) {
        for (size_t j = i + 1; j < 5; ++j) {
            for (size_t k = j + 1; k < 5; ++k) {
                const Point2 a{p[j].x - p[i].x, p[j].y - p[i].y}, b{p[k].x - p[i].x, p[k].y - p[i].y};
                const double longest = std::max({length(a), length(b), length(b - a)});
                if (!(std::fabs(cross(a, b)) > rounding * longest)) {
                    fail(NURBS_ERROR_COLLINEAR,
                         "points[%zu], points[%zu] and points[%zu] are on a line, or two of them are equal, "
                         "to "
                         "within rounding",
                         i, j, k);
                }
            }
        }
    }
}

// Along the arc of a factor the ratio r2 / r0 increases from 0 to infinity.
void check_order(const TangentPencil &pencil, const std::array<Projective, 5> &p, double factor) {
    double last = 0;
    for (size_t i = 1; i < 4; ++i) {
        const TangentPencil::Ratios r = pencil.ratios({p[i].x, p[i].y});
        const bool on_arc = r.r0 > 0 && r.r2 > 0 && r.r1 * factor > 0;
        if (!on_arc || !(r.r2 / r.r0 > last)) {
            fail(NURBS_ERROR_CONIC,
                 "points[%zu] is not behind the others on one arc of their conic from points[0] to points[4]",
                 i);
        }
        last = r.r2 / r.r0;
    }
}

struct Crossing {
    double alpha;
    double beta;
    double miss;
    double sine; // of the angle between the lines
};

// a + alpha s and b - beta t where they come closest. The directions are units.
Crossing closest(Coordinates a, Coordinates s, Coordinates b, Coordinates t) {
    double st = 0, sc = 0, tc = 0, difference = 0, sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        st += s[i] * t[i];
        sc += s[i] * (b[i] - a[i]);
        tc += t[i] * (b[i] - a[i]);
        difference = std::hypot(difference, s[i] - t[i]);
        sum = std::hypot(sum, s[i] + t[i]);
    }
    const double sine = difference * sum / 2;
    const double alpha = (sc - st * tc) / sine / sine, beta = (tc - st * sc) / sine / sine;
    double miss = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        miss = std::hypot(miss, a[i] + alpha * s[i] - (b[i] - beta * t[i]));
    }
    return {alpha, beta, miss, sine};
}

Vector unit(Coordinates v) {
    double size = 0;
    for (const double x : v) {
        size = std::max(size, std::fabs(x));
    }
    double length = 0;
    for (const double x : v) {
        length = std::hypot(length, x / size);
    }
    Vector out = copy(v);
    for (double &x : out) {
        x = x / size / length;
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
    // The angle at b is half a turn less the one between the tangent and the chord.
    const Point2 p = plane.point(b), chord = plane.point(c);
    const Point2 to_a = Point2{0, 0} - p, to_c = chord - p;
    const double cosine = -(to_a.x * to_c.x + to_a.y * to_c.y), sine = cross(to_c, to_a);
    const Point2 tangent{cosine * chord.x + sine * chord.y, cosine * chord.y - sine * chord.x};
    const ConicArc arc = circle_over(a, c, plane, tangent);
    return conic_curve({&arc, 1}, form);
}

SplinePtr arc_tangent(Coordinates a, Coordinates tangent, Coordinates b, int32_t form) {
    check_arc_form(form);
    const Vector direction = unit(tangent);
    Vector beside = copy(a);
    double length = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        length = std::hypot(length, b[i] - a[i]);
    }
    for (size_t i = 0; i < a.size(); ++i) {
        beside[i] += length * direction[i];
    }
    const PlaneFrame plane(a, b, beside, "a, b and a point along the tangent");
    const ConicArc arc = circle_over(a, b, plane, plane.direction(tangent));
    return conic_curve({&arc, 1}, form);
}

SplinePtr conic_shoulder(Coordinates a, Coordinates tangent_a, Coordinates b, Coordinates tangent_b,
                         double rho) {
    if (!(rho >= 0 && rho < 1)) {
        fail(NURBS_ERROR_FACTOR, "rho = %s, expected 0 <= rho < 1", Number(rho).text);
    }
    const Vector s = unit(tangent_a), t = unit(tangent_b);
    const Crossing crossing = closest(a, s, b, t);
    const double reach = std::max(std::fabs(crossing.alpha), std::fabs(crossing.beta));
    if (!(crossing.sine > 8 * 0x1p-52)) {
        fail(NURBS_ERROR_CONIC, "the tangents are parallel to within rounding");
    }
    if (!(crossing.alpha > 0) || !(crossing.beta > 0)) {
        fail(NURBS_ERROR_CONIC, "the tangents meet behind a or in front of b");
    }
    if (crossing.miss > 16 * 0x1p-52 * (largest_coordinate(a, b) + reach)) {
        fail(NURBS_ERROR_CONIC, "the tangents pass each other at a distance of %s",
             Number(crossing.miss).text);
    }
    Vector corner = copy(a);
    for (size_t i = 0; i < corner.size(); ++i) {
        corner[i] += crossing.alpha * s[i];
    }
    return conic_segment(static_cast<int>(a.size()), a.data(), corner.data(), b.data(), rho / (1 - rho));
}

SplinePtr conic_point(Coordinates a, Coordinates tangent_a, Coordinates b, Coordinates tangent_b,
                      Coordinates point, int32_t form) {
    check_arc_form(form, NURBS_ARC_THIRDS);
    const PlaneFrame plane(a, b, point, "a, b and the point");
    plane.check_direction(tangent_a, "tangent_a");
    plane.check_direction(tangent_b, "tangent_b");
    const TangentPencil pencil(plane.point(b), plane.direction(tangent_a), plane.direction(tangent_b));
    if (pencil.degenerate(plane.rounding())) {
        fail(NURBS_ERROR_CONIC, "a tangent is along the chord from a to b");
    }
    const ConicArc arc =
        arc_of_pencil(a, b, plane, pencil, factor_through(pencil.ratios(plane.point(point))));
    return conic_curve({&arc, 1}, form);
}

SplinePtr conic_through(Coordinates points, int dim, int32_t form) {
    check_arc_form(form, NURBS_ARC_THIRDS);
    const auto width = static_cast<size_t>(dim);
    const auto place = [&](size_t i) { return points.subspan(i * width, width); };
    const PlaneFrame plane(place(0), place(4), place(2), "points[0], points[4] and points[2]");
    plane.check_point(place(1), "points[1]");
    plane.check_point(place(3), "points[3]");
    std::array<Projective, 5> p{};
    for (size_t i = 0; i < 5; ++i) {
        const Point2 x = plane.point(place(i));
        p[i] = {x.x, x.y, 1};
    }
    check_triangles(p, plane.rounding());
    const TangentPencil pencil({p[4].x, p[4].y}, pascal_tangent(p), pascal_tangent(reversed(p)));
    if (pencil.degenerate(plane.rounding())) {
        fail(NURBS_ERROR_CONIC, "the conic through the points has a tangent along its chord");
    }
    const double factor = factor_through(pencil.ratios({p[2].x, p[2].y}));
    check_order(pencil, p, factor);
    const ConicArc arc = arc_of_pencil(place(0), place(4), plane, pencil, factor);
    return conic_curve({&arc, 1}, form);
}

} // namespace nrb
