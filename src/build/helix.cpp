// SPDX-License-Identifier: MIT
#include "build/helix.h"

#include "base/checked.h"
#include "base/error.h"
#include "build/make_shape.h"
#include "numeric/binomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace nrb::build {

namespace {

constexpr double turn = 2 * std::numbers::pi;

using Polynomial = std::vector<double>; // Bernstein coefficients over [0, 1]

Polynomial multiplied(const Polynomial &a, const Polynomial &b) {
    const auto p = static_cast<int>(a.size()) - 1, q = static_cast<int>(b.size()) - 1;
    Polynomial product(a.size() + b.size() - 1);
    for (int i = 0; i <= p; ++i) {
        for (int j = 0; j <= q; ++j) {
            product[static_cast<size_t>(i + j)] += binomial(p, i) * binomial(q, j) / binomial(p + q, i + j) *
                                                   a[static_cast<size_t>(i)] * b[static_cast<size_t>(j)];
        }
    }
    return product;
}

// The constant 1 as a polynomial of a degree.
Polynomial one(int degree) {
    return Polynomial(static_cast<size_t>(degree) + 1, 1.0);
}

// h(y) = atan(sqrt y) / sqrt y = sum (-y)^k / (2 k + 1), or its first or second derivative, for 0 <= y <
// 0.18.
double arc_tangent_quotient(double y, int derivative) noexcept {
    double sum = 0;
    for (int k = 31; k >= derivative; --k) { // 0.18^31 < 1e-23
        double term = (k % 2 == 0 ? 1.0 : -1.0) / (2 * k + 1);
        for (int i = 0; i < derivative; ++i) {
            term *= k - i;
        }
        sum = sum * y + term;
    }
    return sum;
}

// The coefficients of q (helix.h) in powers of y - k^2: g(k^2), g'(k^2), g''(k^2) / 2.
std::array<double, 3> taylor_of_angle(double y) noexcept {
    const double h0 = arc_tangent_quotient(y, 0), h1 = arc_tangent_quotient(y, 1),
                 h2 = arc_tangent_quotient(y, 2);
    const double s = 1 + y;
    return {2 * s * s * s * h0, 2 * s * s * (3 * h0 + s * h1), s * (6 * h0 + s * (6 * h1 + s * h2))};
}

// A piece centred on the angle 0, of which all pieces are made: its control points for the radius 1 (x, y)
// and for a radius equal to the approximated angle (growing_x, growing_y), and the coefficients of that
// angle.
struct CoilPiece {
    int degree;
    Polynomial weights;
    Polynomial x, y;
    Polynomial growing_x, growing_y;
    Polynomial angle;
};

void divide(Polynomial &a, const Polynomial &weights) noexcept {
    for (size_t i = 0; i < a.size(); ++i) {
        a[i] /= weights[i];
    }
}

// The numerator of the approximated angle over the denominator w^3, w = (1 + x^2) / (1 + k^2).
Polynomial angle_numerator(double k) {
    const std::array<double, 3> q = taylor_of_angle(k * k);
    const Polynomial below = {0, -2 * k * k, 0}; // x^2 - k^2
    Polynomial sum = multiplied(below, below);
    const Polynomial raised = multiplied(below, one(2));
    const double scale = std::pow(1 + k * k, -3);
    for (size_t i = 0; i < sum.size(); ++i) {
        sum[i] = scale * (q[0] + q[1] * raised[i] + q[2] * sum[i]);
    }
    return multiplied(multiplied({-k, k}, sum), one(1));
}

CoilPiece make_piece(double angle, bool growing) {
    const double c = std::cos(angle / 2), s = std::sin(angle / 2);
    const Polynomial w = {1, c, 1}, cosine = {c, 1, c}, sine = {-s, 0, s};
    const Polynomial squared = multiplied(w, w), cubed = multiplied(squared, w);
    const Polynomial numerator = angle_numerator(std::tan(angle / 4));
    CoilPiece piece;
    const Polynomial &factor = growing ? cubed : squared;
    piece.weights = multiplied(factor, w);
    piece.degree = static_cast<int>(piece.weights.size()) - 1;
    piece.x = multiplied(cosine, factor);
    piece.y = multiplied(sine, factor);
    piece.growing_x = growing ? multiplied(cosine, numerator) : Polynomial(piece.weights.size());
    piece.growing_y = growing ? multiplied(sine, numerator) : Polynomial(piece.weights.size());
    piece.angle = growing ? multiplied(numerator, w) : numerator;
    for (Polynomial *p : {&piece.x, &piece.y, &piece.growing_x, &piece.growing_y, &piece.angle}) {
        divide(*p, piece.weights);
    }
    return piece;
}

void check_helix(const Helix &shape, int dim, double tolerance) {
    const auto refuse = [](const char *name, double value, const char *expected) {
        fail(Status::length, "%s = %s, expected %s", name, Number(value).text, expected);
    };
    if (!std::isfinite(shape.growth)) {
        refuse("growth", shape.growth, "a finite length");
    }
    if (!std::isfinite(shape.radius) || shape.radius < 0 || (shape.radius == 0 && shape.growth == 0)) {
        refuse("radius", shape.radius, "a finite length that is at least 0, and more where growth is 0");
    }
    if (!std::isfinite(shape.pitch) || (dim == 2 && shape.pitch != 0)) {
        refuse("pitch", shape.pitch, "a finite length, and 0 in dimension 2");
    }
    if (!std::isfinite(shape.turns) || !(shape.turns > 0)) {
        fail(Status::factor, "turns = %s, expected a finite number above 0", Number(shape.turns).text);
    }
    const double last = std::fma(shape.growth, shape.turns, shape.radius);
    if (!(last >= -4 * 0x1p-52 * shape.radius)) { // down to here it is rounding, and becomes 0
        refuse("radius + growth * turns", last, "at least 0");
    }
    if (!std::isfinite(tolerance) || !(tolerance > 0)) {
        fail(Status::tolerance, "tolerance = %s, expected a finite length above 0", Number(tolerance).text);
    }
}

constexpr double error_factor = 0.21760; // 32 / 35 (6/7)^3 / sqrt(7) = 0.217596...

// A bound of the error of the approximated angle on a piece.
double angle_error(double piece_angle) noexcept {
    return error_factor * std::pow(std::tan(piece_angle / 4), 7);
}

// The movement in radius and height per radian, without the movement around the axis.
double slope(const Helix &shape) noexcept {
    return std::hypot(shape.growth, shape.pitch) / turn;
}

// The fewest pieces of at most a quarter turn that keep the tolerance.
int64_t piece_count(const Helix &shape, double tolerance) {
    const double k = std::pow(tolerance / (error_factor * slope(shape)), 1.0 / 7);
    const double largest = std::min(std::numbers::pi / 2, 4 * std::atan(k));
    const double pieces = std::ceil(turn * shape.turns / largest * (1 - 0x1p-50));
    if (!(pieces < 0x1p40)) {
        fail(Status::overflow, "%s turns to a tolerance of %s need %s pieces", Number(shape.turns).text,
             Number(tolerance).text, Number(pieces).text);
    }
    auto count = std::max<int64_t>(1, static_cast<int64_t>(pieces));
    while (slope(shape) * angle_error(turn * shape.turns / static_cast<double>(count)) > tolerance) {
        ++count; // because the root was rounded
    }
    return count;
}

class HelixPoints {
public:
    HelixPoints(const Placement &place, const Helix &shape, int64_t pieces)
        : place_(place), shape_(shape), halves_(2 * pieces), start_(make_angle(shape.start, "start")) {}

    // Joint i, where piece i begins: a point of the true curve.
    void joint(int64_t i, double *out) const noexcept {
        const double turns = turns_at(2 * i);
        const Direction d = direction_at(2 * i);
        const double radius = std::max(0.0, std::fma(shape_.growth, turns, shape_.radius));
        place_.point(radius * d.cos, radius * d.sin, shape_.pitch * turns, out);
    }
    // Inner control point j of piece i.
    void inner(const CoilPiece &piece, int64_t i, size_t j, double *out) const noexcept {
        const double turns = turns_at(2 * i + 1), growth = shape_.growth / turn;
        const Direction d = direction_at(2 * i + 1);
        const double radius = shape_.radius + shape_.growth * turns;
        const double x = radius * piece.x[j] + growth * piece.growing_x[j];
        const double y = radius * piece.y[j] + growth * piece.growing_y[j];
        place_.point(x * d.cos - y * d.sin, x * d.sin + y * d.cos,
                     shape_.pitch * turns + shape_.pitch / turn * piece.angle[j], out);
    }
    [[nodiscard]] double knot(int64_t i) const noexcept { return turns_at(2 * i); }

private:
    // The number of turns from the start to the end of `half` half pieces.
    [[nodiscard]] double turns_at(int64_t half) const noexcept {
        return half == halves_ ? shape_.turns
                               : shape_.turns * static_cast<double>(half) / static_cast<double>(halves_);
    }
    // The direction there. The rounding error of the product is added back to the fraction of a turn.
    [[nodiscard]] Direction direction_at(int64_t half) const noexcept {
        const auto k = static_cast<double>(half), n = static_cast<double>(halves_);
        const double product = k * shape_.turns, rest = std::fma(k, shape_.turns, -product);
        const double part = (std::fmod(product, n) + rest) / n;
        return start_.plus(Angle::from_radians(turn * part), 1, 1).direction();
    }

    const Placement &place_;
    const Helix &shape_;
    int64_t halves_;
    Angle start_;
};

std::vector<double> helix_knots(const HelixPoints &points, int64_t pieces, int degree) {
    std::vector<double> knots;
    knots.push_back(points.knot(0));
    for (int64_t i = 0; i <= pieces; ++i) {
        knots.insert(knots.end(), static_cast<size_t>(degree), points.knot(i));
    }
    knots.push_back(points.knot(pieces));
    return knots;
}

} // namespace

HelixCurve helix(const Placement &place, const Helix &shape, double tolerance) {
    check_helix(shape, place.dim, tolerance);
    const int64_t pieces = piece_count(shape, tolerance);
    const double angle = turn * shape.turns / static_cast<double>(pieces);
    const CoilPiece piece = make_piece(angle, shape.growth != 0);
    const HelixPoints at(place, shape, pieces);
    const auto dim = static_cast<size_t>(place.dim), degree = static_cast<size_t>(piece.degree);
    const int64_t count = checked_sum(checked_product(pieces, piece.degree, "points"), 1, "points");
    std::vector<double> points(static_cast<size_t>(checked_product(count, place.dim, "points")));
    std::vector<double> weights(static_cast<size_t>(count), 1.0);
    for (int64_t i = 0; i < pieces; ++i) {
        const size_t first = static_cast<size_t>(i) * degree;
        at.joint(i, points.data() + first * dim);
        for (size_t j = 1; j < degree; ++j) {
            at.inner(piece, i, j, points.data() + (first + j) * dim);
            weights[first + j] = piece.weights[j];
        }
    }
    at.joint(pieces, points.data() + static_cast<size_t>(count - 1) * dim);
    KnotVectorPtr axis = make_knot_vector(piece.degree, helix_knots(at, pieces, piece.degree));
    return {make_shape({std::move(axis)}, place.dim, std::move(points), std::move(weights)),
            slope(shape) * angle_error(angle)};
}

} // namespace nrb::build
