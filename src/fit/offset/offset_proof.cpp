// SPDX-License-Identifier: MIT
#include "fit/offset/offset_proof.h"

#include "base/numbers.h"
#include "bernstein/coarse_products.h"
#include "fit/offset/homogeneous_piece.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr int axis_u = 1, axis_v = 2; // of the three axes of a piece
// Covers the few roundings of plain numbers below.
constexpr double rounded_up = 1 + 64 * eps;

struct Range {
    double lower = infinity, upper = -infinity;
    [[nodiscard]] double magnitude() const noexcept { return std::max(-lower, upper); }
};

// The range of the coefficients, errors included. Where something overflows, nothing is known.
Range range_of(const RoundedPolynomial &a) noexcept {
    Range range;
    for (size_t i = 0; i < a.values.size(); ++i) {
        if (!std::isfinite(a.values[i]) || !std::isfinite(a.errors[i])) {
            return {-infinity, infinity};
        }
        range.lower = std::min(range.lower, a.values[i] - a.error(i));
        range.upper = std::max(range.upper, a.values[i] + a.error(i));
    }
    return range;
}

// w^2 times the derivative with respect to the place on an axis.
RoundedPolynomial tangent(const HomogeneousPiece &s, int axis, bool weighted) {
    const RoundedPolynomial along = derivative(s.points, axis);
    return weighted ? coarse_times(along, s.weight) - coarse_times(s.points, derivative(s.weight, axis))
                    : along;
}

Vector3 coefficient(const RoundedPolynomial &a, size_t i) noexcept {
    return {a.values[3 * i], a.values[3 * i + 1], a.values[3 * i + 2]};
}

Vector3 sum_of(const RoundedPolynomial &a) noexcept {
    Vector3 sum;
    for (size_t i = 0; 3 * i < a.values.size(); ++i) {
        sum = sum + coefficient(a, i);
    }
    return sum;
}

// The vector of length 1 in the direction of a; 0 for 0.
Vector3 direction_of(const Vector3 &a) noexcept {
    const double l = length(a);
    return l > 0 ? (1 / l) * a : a;
}

// An upper bound of the length of a vector polynomial, whose values are convex combinations of its
// coefficients.
double most_length(const RoundedPolynomial &a) noexcept {
    double most = 0, error = 0;
    for (size_t i = 0; 3 * i < a.values.size(); ++i) {
        most = std::max(most, length(coefficient(a, i)));
        error = std::max({error, a.error(3 * i), a.error(3 * i + 1), a.error(3 * i + 2)});
    }
    return rounded_up * (most + 2 * error);
}

// The vector product with a polynomial; the error bounds cover two products and a sum for each value.
RoundedPolynomial cross(const Vector3 &a, RoundedPolynomial b) {
    const double size = largest(a);
    for (size_t i = 0; 3 * i < b.values.size(); ++i) {
        const Vector3 of = coefficient(b, i), made = cross(a, of);
        const double error = std::max({b.error(3 * i), b.error(3 * i + 1), b.error(3 * i + 2)});
        std::fill_n(b.errors.begin() + static_cast<ptrdiff_t>(3 * i), 3,
                    2 * size * (error + 2 * eps * largest(of)));
        b.values[3 * i] = made.x;
        b.values[3 * i + 1] = made.y;
        b.values[3 * i + 2] = made.z;
    }
    return b;
}

// A lower bound of |p x q|: of its component along a direction m near all of its values, which is (m x p).q.
double least_area(const RoundedPolynomial &p, const RoundedPolynomial &q) {
    const Vector3 m = direction_of(cross(sum_of(p), sum_of(q)));
    return range_of(coarse_dot(cross(m, p), q)).lower / rounded_up;
}

// A lower bound of the length of a vector polynomial: of its component along a direction, a unit vector up to
// rounding.
double least_length(const RoundedPolynomial &a, const Vector3 &direction) {
    const RoundedPolynomial along = scaled(component(a, 0), direction.x) +
                                    scaled(component(a, 1), direction.y) +
                                    scaled(component(a, 2), direction.z);
    return range_of(along).lower / rounded_up;
}

// Whether the piece of the candidate begins on the side of the surface that the sign of the distance says.
bool right_side(const RoundedPolynomial &v, const Vector3 &normal, double distance) noexcept {
    const Vector3 a = coefficient(v, 0);
    return (distance < 0 ? -1 : 1) * dot(a, normal) > length(a) * length(normal) / 2;
}

double squared(double x) noexcept {
    return x * x;
}

// S_u and S_v times w^2, and the range of w.
struct Tangents {
    RoundedPolynomial p, q;
    Range weights;
};

// An upper bound of |b|^2, where |S_u x S_v| is at least `area`; v is multiplied by w.
double squared_tangential_part(const RoundedPolynomial &v, const Tangents &tangents, double area) {
    const auto &[p, q, weights] = tangents;
    const double w3 = weights.lower * squared(weights.lower), w4 = w3 * weights.lower;
    const double along_u = range_of(coarse_dot(v, p)).magnitude() / w3,
                 along_v = range_of(coarse_dot(v, q)).magnitude() / w3;
    const double e = squared(most_length(p)) / w4, f = range_of(coarse_dot(p, q)).magnitude() / w4,
                 g = squared(most_length(q)) / w4;
    return rounded_up * (g * squared(along_u) + 2 * f * along_u * along_v + e * squared(along_v)) /
           squared(area);
}

// An upper bound of | |a| - |d| |, from the range `off` of (v^2 - d^2) w^2 and an upper bound b2 of |b|^2.
// From a^2 - d^2 = x follows |a| - |d| = x / (|d| + sqrt(d^2 + x)), which increases with x.
double normal_part(Range off, Range weights, double b2, double distance) {
    const double small = squared(weights.lower), large = squared(weights.upper), d2 = squared(distance);
    const double more = off.upper / (off.upper > 0 ? small : large),
                 less = b2 - off.lower / (off.lower < 0 ? small : large);
    if (!(d2 > 2 * less) || !(d2 > -2 * more)) { // far off, where differences would be inaccurate
        return infinity;
    }
    const auto along = [&](double x) { return x / (std::abs(distance) + std::sqrt(d2 + x)); };
    return std::max({along(more), -along(-less), 0.0});
}

// v and d w side by side, so that v^2 - (d w)^2 is a single product.
RoundedPolynomial with_distance(const RoundedPolynomial &v, const HomogeneousPiece &s, double distance) {
    BernsteinShape shape = v.shape;
    shape.width = 1;
    return side_by_side({component(v, 0), component(v, 1), component(v, 2),
                         scaled(coarse_raised(s.weight, shape), distance)});
}

// An upper bound of |(|a| - |d|, |b|)|, from one of |b|^2.
double whole_bound(const RoundedPolynomial &v, const HomogeneousPiece &s, double b2, double distance) {
    const RoundedPolynomial both = with_distance(v, s, distance);
    const Range off = range_of(coarse_dot(both, both, -1));
    return rounded_up * std::hypot(normal_part(off, range_of(s.weight), b2, distance), std::sqrt(b2)) +
           4 * eps * std::abs(distance);
}

double surface_bound(const HomogeneousPiece &s, const RoundedPolynomial &v, bool weighted, double distance) {
    const Tangents tangents{tangent(s, axis_u, weighted), tangent(s, axis_v, weighted), range_of(s.weight)};
    const Range weights = tangents.weights;
    const double area = least_area(tangents.p, tangents.q) / squared(squared(weights.upper));
    const Vector3 normal = cross(coefficient(tangents.p, 0), coefficient(tangents.q, 0));
    if (!(weights.lower > 0) || !(area > 0) || !right_side(v, normal, distance)) {
        return infinity;
    }
    return whole_bound(v, s, squared_tangential_part(v, tangents, area), distance);
}

// |b| = |v x n| / |n| with n = V x C'.
double curve_bound(const HomogeneousPiece &c, const RoundedPolynomial &v, bool weighted,
                   const CurveOffset &offset) {
    const RoundedPolynomial normal = cross(offset.reference, tangent(c, last_axis, weighted));
    const Range weights = range_of(c.weight);
    const double size = least_length(normal, direction_of(sum_of(normal))) / squared(weights.upper);
    if (!(weights.lower > 0) || !(size > 0) || !right_side(v, coefficient(normal, 0), offset.distance)) {
        return infinity;
    }
    const double w3 = weights.lower * squared(weights.lower);
    return whole_bound(v, c, rounded_up * squared(most_length(cross(v, normal)) / (w3 * size)),
                       offset.distance);
}

BernsteinShape highest(BernsteinShape a, const BernsteinShape &b) noexcept {
    for (size_t k = 0; k < a.degrees.size(); ++k) {
        a.degrees[k] = std::max(a.degrees[k], b.degrees[k]);
    }
    return a;
}

// Applies bound_of() to the pieces of a spline and the differences v, times w, of a candidate from them.
template <class BoundOf>
std::vector<double> bounds_of(const Spline &spline, const Spline &candidate,
                              const pieces::BernsteinNet::Breaks &breaks, BoundOf &&bound_of) {
    const std::vector<double> centre = pieces::centre_of(spline);
    const HomogeneousPieces given(spline, breaks, centre), found(candidate, breaks, centre);
    std::vector<double> bounds;
    for (int64_t i = 0; i < given.count(); ++i) {
        const HomogeneousPiece s = given.piece(i);
        const RoundedPolynomial points = found.piece(i).points;
        const RoundedPolynomial moved = given.weighted() ? coarse_times(points, s.weight) : points;
        const BernsteinShape shape = highest(moved.shape, s.points.shape);
        const RoundedPolynomial v = coarse_raised(moved, shape) - coarse_raised(s.points, shape);
        const double bound = given.positive() ? bound_of(s, v, given.weighted()) : infinity;
        bounds.push_back(bound >= 0 ? bound : infinity); // rather than NaN
    }
    return bounds;
}

} // namespace

std::vector<double> offset_bounds(const Spline &surface, double distance, const Spline &candidate,
                                  const std::array<std::vector<double>, 2> &breaks) {
    return bounds_of(surface, candidate, {breaks[0], breaks[1], {}},
                     [distance](const HomogeneousPiece &s, const RoundedPolynomial &v, bool weighted) {
                         return surface_bound(s, v, weighted, distance);
                     });
}

std::vector<double> offset_bounds(const Spline &curve, const CurveOffset &offset, const Spline &candidate,
                                  const std::vector<double> &breaks) {
    return bounds_of(curve, candidate, {breaks, {}, {}},
                     [&offset](const HomogeneousPiece &c, const RoundedPolynomial &v, bool weighted) {
                         return curve_bound(c, v, weighted, offset);
                     });
}

} // namespace nrb::fit
