// SPDX-License-Identifier: MIT
#include "recognize/piece_distance.h"

#include "base/numbers.h"
#include "recognize/shape_forms.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

bool straight(int32_t kind) noexcept {
    return kind == shape_point || kind == shape_line || kind == shape_plane;
}

// The largest value of a distance function at the control points. It bounds the distance of the piece because
// the function is convex and homogeneous.
template <class Distance>
double hull_bound(const pieces::BezierPiece &piece, Distance distance) {
    double largest = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (piece.has_point(i)) {
            largest = std::max(largest, distance(point_of(piece, i)));
        }
    }
    return largest * (1 + 8 * eps);
}

double smallest_coordinate(const pieces::BezierPiece &piece, double Vector3::*coordinate) noexcept {
    double least = infinity;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (piece.has_point(i)) {
            least = std::min(least, point_of(piece, i).*coordinate);
        }
    }
    return least - 4 * eps * std::abs(least);
}

// The mean of the control points.
Vector3 middle_of(const pieces::BezierPiece &piece) noexcept {
    Vector3 sum;
    double count = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (piece.has_point(i)) {
            sum = sum + point_of(piece, i);
            ++count;
        }
    }
    return (1 / count) * sum;
}

// For d >= 0 with d^2 - r^2 in [least, most]: a bound on |d - r|.
DistanceBound from_square(double least, double most, double error, double r) noexcept {
    const double square = r * r;
    const double outside = most > 0 ? most / (r + std::sqrt(square * (1 - 4 * eps) + most)) : 0;
    const double inner = std::sqrt(std::max(0.0, square * (1 - 4 * eps) + least));
    const double inside = least < 0 ? std::min(r, -least / (r + inner)) : 0;
    return {std::max(outside, inside) * (1 + 8 * eps), error / r};
}

} // namespace

PieceDistance::PieceDistance(const Shape &shape) : shape_(shape) {
    if (!straight(shape.kind) && shape.kind != shape_torus) {
        quadric_ = quadric_of(shape);
    }
}

DistanceBound PieceDistance::upper(const pieces::BezierPiece &piece) const {
    DistanceBound bound;
    if (straight(shape_.kind)) {
        bound.upper =
            hull_bound(piece, [this](const Vector3 &p) { return std::abs(signed_distance(shape_, p)); });
    } else {
        bound = shape_.kind == shape_torus ? from_torus(piece) : in_plane(piece);
    }
    if (shape_.planar()) {
        const double height = hull_bound(piece, [](const Vector3 &p) { return std::abs(p.z); });
        bound.upper = std::hypot(bound.upper, height);
    }
    bound.upper = bound.upper * (1 + 16 * eps) + piece.records_moved();
    bound.noise += piece.records_moved() + 4 * eps * piece.reach();
    return std::isnan(bound.upper) ? DistanceBound{} : bound;
}

double PieceDistance::lower(const pieces::BezierPiece &piece, double noise) const {
    double largest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int64_t i = piece.shape().corner(corner);
        if (piece.has_point(i)) {
            largest = std::max(largest, least_distance(shape_, point_of(piece, i)));
        }
    }
    return std::max(0.0, largest * (1 - 64 * eps) - 64 * eps * piece.reach() - noise);
}

// For circles and conics the distance within their plane; for quadric surfaces the distance.
DistanceBound PieceDistance::in_plane(const pieces::BezierPiece &piece) const {
    if (quadric_.round()) {
        const FormRange range = ShapeForms(piece).quadratic(quadric_);
        return from_square(range.least, range.most, range.error, shape_.sizes[0]);
    }
    const DistanceBound bound = by_gradient(piece), extent{by_extent(piece), 0};
    return extent.upper < bound.upper || beyond(piece, bound.upper) ? extent : bound;
}

// Whether a zero of the equation within this distance may belong to the other half of the cone or the other
// branch of the hyperbola.
bool PieceDistance::beyond(const pieces::BezierPiece &piece, double distance) const noexcept {
    return (shape_.kind == shape_cone && smallest_coordinate(piece, &Vector3::z) < distance) ||
           (shape_.kind == shape_hyperbola && smallest_coordinate(piece, &Vector3::x) < distance);
}

// The bound of Quadric::curvature().
DistanceBound PieceDistance::by_gradient(const pieces::BezierPiece &piece) const {
    const ShapeForms forms(piece);
    const FormRange value = forms.quadratic(quadric_);
    const double f = std::max(std::abs(value.least), std::abs(value.most));
    const double squared = forms.squared_gradient(quadric_).least;
    const double curved = quadric_.curvature() * f * (1 + 8 * eps);
    if (!(squared >= curved) || squared == 0) {
        return {};
    }
    const double divisor = (std::sqrt(squared) + std::sqrt(squared - curved)) * (1 - 4 * eps);
    return {f / divisor, value.error / divisor};
}

// With s the distance from the axis and G = s^2 + z^2 + R^2 - r^2, the product of
// (s - R)^2 + z^2 - r^2 = G - 2 R s and (s + R)^2 + z^2 - r^2 = G + 2 R s is G^2 - 4 R^2 s^2. Divided by a
// lower bound on the second factor, its range bounds the first one.
DistanceBound PieceDistance::from_torus(const pieces::BezierPiece &piece) const {
    const double major = shape_.sizes[0], minor = shape_.sizes[1];
    const TorusForms torus = ShapeForms(piece).torus(major, minor);
    const double twice = 2 * major * std::sqrt(std::max(0.0, torus.squared_radius.least));
    const double factor = (torus.sum.least + twice) - 8 * eps * (std::abs(torus.sum.least) + twice);
    const DistanceBound extent{by_extent(piece), 0};
    if (!(factor > 0)) {
        return extent;
    }
    const FormRange &product = torus.product;
    const DistanceBound bound =
        from_square(product.least / factor, product.most / factor, product.error / factor, minor);
    return extent.upper < bound.upper || across_axis(torus, bound.upper) ? extent : bound;
}

// For a torus with r > R: whether the nearest point of the generating circle may be beyond the axis, where
// the outer torus has no points. With d the distance from the centre of that circle, the nearest point is at
// R + (s - R) r / d from the axis, which is not negative if s r >= R (r - d).
bool PieceDistance::across_axis(const TorusForms &torus, double distance) const noexcept {
    const double major = shape_.sizes[0], minor = shape_.sizes[1];
    const double least = std::sqrt(std::max(0.0, torus.squared_radius.least));
    return minor > major && !(least * minor >= major * distance * (1 + 8 * eps));
}

// The distance of one point plus the radius of a ball about it that contains all control points.
double PieceDistance::by_extent(const pieces::BezierPiece &piece) const {
    const Vector3 middle = middle_of(piece);
    const bool plane = shape_.planar();
    const double radius = hull_bound(piece, [&](const Vector3 &p) {
        return plane ? std::hypot(p.x - middle.x, p.y - middle.y) : length(p - middle);
    });
    return most_distance(shape_, middle) + radius +
           16 * eps * (piece.reach() + shape_.sizes[0] + shape_.sizes[1]);
}

} // namespace nrb::recognize
