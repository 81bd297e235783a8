// SPDX-License-Identifier: MIT
#include "closest/pair/pair_bound.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

// A bound on the rounding errors of products of vectors whose coordinates are at most about 1.
double rounding(int dim) noexcept {
    return 8 * (dim + 4) * eps;
}

} // namespace

double box_distance(const double *a, const double *b, int dim) noexcept {
    double square = 0;
    for (int c = 0; c < dim; ++c) {
        const double gap = std::max({0.0, a[c] - b[dim + c], b[c] - a[dim + c]});
        square += gap * gap;
    }
    return std::sqrt(square) * (1 - (dim + 4) * eps);
}

// The gap along normal_, for which |n| = 1 to rounding.
double PairBound::plane(const pieces::BezierPiece &a, const pieces::BezierPiece &b) const noexcept {
    double most = -infinity, least = infinity;
    for (int64_t i = 0; i < a.coefficients(); ++i) {
        most = std::max(most, dot(normal_.data(), a.point(i), a.dim()));
    }
    for (int64_t i = 0; i < b.coefficients(); ++i) {
        least = std::min(least, dot(normal_.data(), b.point(i), b.dim()));
    }
    return (least - most) * (1 - 8 * eps) - rounding(a.dim());
}

void PairBound::project(double *v) const noexcept {
    const int dim = static_cast<int>(normal_.size());
    if (projected_) {
        const double part = dot(v, direction_.data(), dim);
        for (int c = 0; c < dim; ++c) {
            v[c] -= part * direction_[static_cast<size_t>(c)];
        }
    }
}

// Samples the piece at the parameters 0, 1/2 and 1 of every axis.
void PairBound::sample(const pieces::BezierPiece &piece, std::vector<double> &out) {
    out.clear();
    std::array<int, max_axes> at{};
    for (bool more = true; more;) {
        jet_.evaluate(piece, {at[0] / 2.0, at[1] / 2.0, at[2] / 2.0}, false);
        out.insert(out.end(), jet_.value(), jet_.value() + piece.dim());
        more = false;
        for (int k = piece.axes(); k-- > 0 && !more;) {
            at[static_cast<size_t>(k)] = (at[static_cast<size_t>(k)] + 1) % 3;
            more = at[static_cast<size_t>(k)] != 0;
        }
    }
}

// The extreme quotients of the Bernstein coefficients of |P (A - c w)|^2 and w^2, where P is the projection
// and c the centre; the binomials cancel. Each coefficient is a sum of at most coefficients() terms per
// coordinate, whose magnitudes, relative to the weights, are at most the square of the largest distance of a
// control point from c.
PairBound::Extremes PairBound::distances(const pieces::BezierPiece &piece, const double *centre) {
    const int dim = piece.dim();
    const int64_t count = piece.coefficients();
    BernsteinShape shape = piece.shape();
    shape.width = 1;
    const BernsteinShape product = product_shape(shape, shape);
    count_work(4 * (count * (dim + 4) + product.coefficients()));
    factors_ = binomial_factors(shape);
    coordinate_.resize(static_cast<size_t>(count * (dim + 1)));
    squares_.assign(static_cast<size_t>(product.coefficients()), 0.0);
    weights_ = squares_;
    difference_.resize(static_cast<size_t>(dim));
    double reach = 0;
    for (int64_t i = 0; i < count; ++i) {
        const double w = piece.record(i)[dim] * factors_[static_cast<size_t>(i)];
        for (int c = 0; c < dim; ++c) {
            difference_[static_cast<size_t>(c)] = piece.point(i)[c] - centre[c];
        }
        reach = std::max(reach, norm(difference_.data(), dim));
        project(difference_.data());
        for (int c = 0; c < dim; ++c) {
            coordinate_[static_cast<size_t>(c * count + i)] = difference_[static_cast<size_t>(c)] * w;
        }
        coordinate_[static_cast<size_t>(dim * count + i)] = w;
    }
    for (int c = 0; c < dim; ++c) {
        const double *row = coordinate_.data() + c * count;
        add_convolution(shape, row, shape, row, squares_.data());
    }
    const double *row = coordinate_.data() + dim * count;
    add_convolution(shape, row, shape, row, weights_.data());
    Extremes found{infinity, 0};
    for (size_t i = 0; i < squares_.size(); ++i) {
        const double quotient = squares_[i] / weights_[i];
        found.least = std::min(found.least, quotient);
        found.most = std::max(found.most, quotient);
    }
    const double error = (static_cast<double>(count) + 3 * dim + 32) * eps * reach * reach;
    return {std::sqrt(std::max(found.least - error, 0.0)) * (1 - 2 * eps),
            std::sqrt(found.most + error) * (1 + 2 * eps)};
}

// The lower bound for the sphere whose centre is at distance `radius` from the foot of the inner piece, in
// the direction of the normal times -sign.
double PairBound::sphere(const pieces::BezierPiece &inside, const pieces::BezierPiece &outside,
                         const double *foot, double sign, double radius) {
    const int dim = inside.dim();
    centre_.resize(static_cast<size_t>(dim));
    for (int c = 0; c < dim; ++c) {
        centre_[static_cast<size_t>(c)] = foot[c] - sign * radius * normal_[static_cast<size_t>(c)];
    }
    const double most = distances(inside, centre_.data()).most;
    return distances(outside, centre_.data()).least - most - rounding(dim);
}

// The ranges of radii R for spheres about c = p - R n, where p is the foot of the inner piece, q that of the
// outer one, d their distance, and n the unit vector from p to q. A sample x of the inner piece lies within R
// of c if 2 R n . (p - x) >= |x - p|^2; a sample y of the outer piece is at least R + d away from c if
// 2 (R + d) n . (q - y) <= |y - q|^2.
double PairBound::spheres(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at,
                          double enough) {
    const int dim = a.dim();
    const double gap = at.distance;
    double best = -infinity;
    std::vector<double> v(static_cast<size_t>(dim));
    const auto range = [&](const std::vector<double> &samples, const std::vector<double> &foot, double sign) {
        Extremes radii{infinity, 0};
        for (size_t i = 0; i < samples.size(); i += static_cast<size_t>(dim)) {
            for (size_t c = 0; c < v.size(); ++c) {
                v[c] = samples[i + c] - foot[c];
            }
            project(v.data());
            const double square = dot(v.data(), v.data(), dim),
                         depth = -sign * dot(v.data(), normal_.data(), dim);
            if (square > 1e-20 && depth > 1e-6 * square) {
                radii.least = std::min(radii.least, square / (2 * depth));
                radii.most = std::max(radii.most, square / (2 * depth));
            } else if (square > 1e-20) {
                radii.most = infinity;
            }
        }
        return radii;
    };
    for (const bool a_inside : {true, false}) {
        const double sign = a_inside ? 1 : -1;
        const Extremes inner = range(a_inside ? samples_a_ : samples_b_, a_inside ? at.from : at.to, sign);
        const Extremes outer = range(a_inside ? samples_b_ : samples_a_, a_inside ? at.to : at.from, sign);
        const double low = inner.most, high = outer.least - gap;
        const pieces::BezierPiece &inside = a_inside ? a : b, &outside = a_inside ? b : a;
        const double *foot = (a_inside ? at.from : at.to).data();
        for (const double radius :
             {low < high ? std::min(2 * low, low / 2 + high / 2) : low / 2 + high / 2, low, high}) {
            if (radius > 0 && radius < 1e5 && best < enough) {
                best = std::max(best, sphere(inside, outside, foot, sign, radius));
            }
        }
    }
    return best;
}

// Sets direction_, along which cylinders project: the sum of the legs of the control net along an axis, made
// orthogonal to the normal.
void PairBound::leg_direction(const pieces::BezierPiece &piece, int axis) {
    const int dim = piece.dim();
    int64_t step = 1;
    for (int k = piece.axes(); k-- > axis + 1;) {
        step *= piece.degree(k) + 1;
    }
    direction_.assign(static_cast<size_t>(dim), 0.0);
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (i / step % (piece.degree(axis) + 1) < piece.degree(axis)) {
            for (int c = 0; c < dim; ++c) {
                direction_[static_cast<size_t>(c)] += piece.point(i + step)[c] - piece.point(i)[c];
            }
        }
    }
    const double along = dot(direction_.data(), normal_.data(), dim);
    for (size_t c = 0; c < direction_.size(); ++c) {
        direction_[c] -= along * normal_[c];
    }
    const double length = norm(direction_.data(), dim);
    projected_ = length > 1e-9;
    for (double &x : direction_) {
        x /= length;
    }
}

double PairBound::lower(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at,
                        double enough) {
    const int dim = a.dim();
    const double moved = a.moved() + b.moved();
    double best = box_distance(a.lower(), b.lower(), dim);
    normal_.resize(static_cast<size_t>(dim));
    for (size_t c = 0; c < normal_.size(); ++c) {
        normal_[c] = (at.to[c] - at.from[c]) / at.distance;
    }
    if (!(at.distance > 1e-14)) {
        return best - moved;
    }
    best = std::max(best, plane(a, b));
    if (best - moved >= enough) {
        return best - moved;
    }
    sample(a, samples_a_);
    sample(b, samples_b_);
    projected_ = false;
    best = std::max(best, spheres(a, b, at, enough + moved));
    for (const pieces::BezierPiece *piece : {&a, &b}) {
        for (int k = 0; k < piece->axes() && piece->axes() > 1 && best - moved < enough; ++k) {
            leg_direction(*piece, k);
            if (projected_) {
                best = std::max(best, spheres(a, b, at, enough + moved));
            }
        }
    }
    projected_ = false;
    return best - moved;
}

} // namespace nrb::closest
