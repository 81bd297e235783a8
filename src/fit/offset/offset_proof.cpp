// SPDX-License-Identifier: MIT
#include "fit/offset/offset_proof.h"

#include "base/numbers.h"
#include "bernstein/rounded_polynomial.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr int axis_u = 1, axis_v = 2; // of the three
// What the few roundings of plain numbers below may amount to.
constexpr double rounded_up = 1 + 64 * eps;

struct Range {
    double lower = infinity, upper = -infinity;
    [[nodiscard]] double magnitude() const noexcept { return std::max(-lower, upper); }
};

Range range_of(const RoundedPolynomial &a) noexcept {
    Range range;
    for (size_t i = 0; i < a.values.size(); ++i) {
        range.lower = std::min(range.lower, a.values[i] - a.error(i));
        range.upper = std::max(range.upper, a.values[i] + a.error(i));
    }
    return range;
}

// A curve or a surface on one piece: w (x - c), and w.
struct HomogeneousPiece {
    RoundedPolynomial points, weight;
};

HomogeneousPiece piece_of(const pieces::BernsteinNet &net, int64_t piece) {
    BernsteinShape shape = net.shape();
    shape.width = 1;
    const auto count = static_cast<size_t>(shape.coefficients());
    std::vector<double> weights(count, 1.0);
    HomogeneousPiece made{{shape, std::vector<double>(space_dim * count), {}}, {shape, {}, {}}};
    made.points.shape.width = space_dim;
    net.copy(piece, made.points.values.data(), weights.data());
    for (const double w : weights) {
        made.weight.errors.push_back(net.weighted() ? net.error() * w : 0);
        made.points.errors.insert(made.points.errors.end(), space_dim, net.error() * net.size(piece) * w);
    }
    made.weight.values = std::move(weights);
    return made;
}

// w^2 times the derivative by the place on an axis.
RoundedPolynomial tangent(const HomogeneousPiece &s, int axis, bool weighted) {
    const RoundedPolynomial along = derivative(s.points, axis);
    return weighted ? along * s.weight - s.points * derivative(s.weight, axis) : along;
}

RoundedPolynomial cross(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    std::vector<RoundedPolynomial> result;
    for (const int c : {0, 1, 2}) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        result.push_back(component(a, d) * component(b, e) - component(a, e) * component(b, d));
    }
    return side_by_side(result);
}

// The direction of the sum of all coefficients.
Vector3 mean_direction(const RoundedPolynomial &a) noexcept {
    Vector3 sum;
    for (size_t i = 0; i + 2 < a.values.size(); i += 3) {
        sum = sum + Vector3{a.values[i], a.values[i + 1], a.values[i + 2]};
    }
    const double l = length(sum);
    return l > 0 ? (1 / l) * sum : sum;
}

// At most the smallest length of a vector polynomial: its part along one direction, a unit vector to rounding.
double least_length(const RoundedPolynomial &a, const Vector3 &direction) {
    const RoundedPolynomial along = scaled(component(a, 0), direction.x) +
                                    scaled(component(a, 1), direction.y) +
                                    scaled(component(a, 2), direction.z);
    return range_of(along).lower / rounded_up;
}

// The piece of the candidate is on the side of the surface that the sign of the distance says.
bool right_side(const RoundedPolynomial &v, const RoundedPolynomial &normal, double distance) noexcept {
    const Vector3 a{v.values[0], v.values[1], v.values[2]},
        n{normal.values[0], normal.values[1], normal.values[2]};
    return (distance < 0 ? -1 : 1) * dot(a, n) > length(a) * length(n) / 2;
}

double squared(double x) noexcept {
    return x * x;
}

// S_u and S_v times w^2, and the extent of w.
struct Tangents {
    RoundedPolynomial p, q;
    Range weights;
};

// At most |b|^2, where |S_u x S_v| is at least `area`.
double squared_tangential_part(const RoundedPolynomial &v, const Tangents &tangents, double area) {
    const auto &[p, q, weights] = tangents;
    const double w3 = weights.lower * squared(weights.lower), w4 = w3 * weights.lower;
    const double along_u = range_of(dot(v, p)).magnitude() / w3,
                 along_v = range_of(dot(v, q)).magnitude() / w3;
    const double e = range_of(dot(p, p)).upper / w4, f = range_of(dot(p, q)).magnitude() / w4,
                 g = range_of(dot(q, q)).upper / w4;
    return rounded_up * (g * squared(along_u) + 2 * f * along_u * along_v + e * squared(along_v)) /
           squared(area);
}

// At most | |a| - |d| |, from (v^2 - d^2) w^2. From a^2 - d^2 = x follows |a| - |d| = x / (|d| + sqrt(d^2 + x)), which rises with x.
double normal_part(Range off, Range weights, double b2, double distance) {
    const double small = squared(weights.lower), large = squared(weights.upper), d2 = squared(distance);
    const double more = off.upper / (off.upper > 0 ? small : large),
                 less = b2 - off.lower / (off.lower < 0 ? small : large);
    if (!(d2 > 2 * less) || !(d2 > -2 * more)) { // nothing is near, and differences would not be known well
        return infinity;
    }
    const auto along = [&](double x) { return x / (std::abs(distance) + std::sqrt(d2 + x)); };
    return std::max({along(more), -along(-less), 0.0});
}

// At most |(|a| - |d|, |b|)|, from |b|^2.
double whole_bound(const RoundedPolynomial &v, const HomogeneousPiece &s, double b2, double distance) {
    const Range off = range_of(dot(v, v) - scaled(s.weight * s.weight, squared(distance)));
    return rounded_up * std::hypot(normal_part(off, range_of(s.weight), b2, distance), std::sqrt(b2)) +
           4 * eps * std::abs(distance);
}

double surface_bound(const HomogeneousPiece &s, const RoundedPolynomial &v, bool weighted, double distance) {
    const Tangents tangents{tangent(s, axis_u, weighted), tangent(s, axis_v, weighted), range_of(s.weight)};
    const Range weights = tangents.weights;
    const RoundedPolynomial normal = cross(tangents.p, tangents.q);
    const double area = least_length(normal, mean_direction(normal)) / squared(squared(weights.upper));
    if (!(weights.lower > 0) || !(area > 0) || !right_side(v, normal, distance)) {
        return infinity;
    }
    return whole_bound(v, s, squared_tangential_part(v, tangents, area), distance);
}

// |b| = |v x n| / |n| with n = V x C'.
double curve_bound(const HomogeneousPiece &c, const RoundedPolynomial &v, bool weighted,
                   const CurveOffset &offset) {
    const auto &[x, y, z] = offset.reference;
    const RoundedPolynomial normal =
        cross(side_by_side({constant(x), constant(y), constant(z)}), tangent(c, last_axis, weighted));
    const Range weights = range_of(c.weight);
    const double size = least_length(normal, mean_direction(normal)) / squared(weights.upper);
    if (!(weights.lower > 0) || !(size > 0) || !right_side(v, normal, offset.distance)) {
        return infinity;
    }
    const RoundedPolynomial across = cross(v, normal);
    const double w6 = squared(weights.lower * squared(weights.lower));
    return whole_bound(v, c, rounded_up * range_of(dot(across, across)).upper / (w6 * squared(size)),
                       offset.distance);
}

// What bound_of() makes of the pieces of a spline and the differences v of a candidate from them.
template <class BoundOf>
std::vector<double> bounds_of(const Spline &spline, const Spline &candidate,
                              const pieces::BernsteinNet::Breaks &breaks, BoundOf &&bound_of) {
    const std::vector<double> centre = pieces::centre_of(spline);
    const auto net_of = [&](const Spline &given) {
        return pieces::BernsteinNet(
            given, pieces::centred_records(given, centre, given.rational(), pieces::weight_exponent(given)),
            breaks, pieces::degrees_of(given));
    };
    const pieces::BernsteinNet s = net_of(spline), r = net_of(candidate);
    std::vector<double> bounds;
    for (int64_t i = 0; i < s.pieces(); ++i) {
        const HomogeneousPiece piece = piece_of(s, i);
        const RoundedPolynomial points = piece_of(r, i).points;
        const RoundedPolynomial v = (s.weighted() ? points * piece.weight : points) - piece.points;
        bounds.push_back(s.positive() ? bound_of(piece, v, s.weighted()) : infinity);
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
