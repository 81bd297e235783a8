// SPDX-License-Identifier: MIT
#include "pieces/slopes.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/products.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::pieces {

namespace {

// Scaled Bernstein coefficients: multiplied by their binomials, so that products are convolutions.
struct Scaled {
    BernsteinShape shape;
    std::vector<double> values;
};

Scaled product(const Scaled &a, const Scaled &b) {
    Scaled result{product_shape(a.shape, b.shape), {}};
    result.values.assign(static_cast<size_t>(result.shape.values()), 0.0);
    add_convolution(a.shape, a.values.data(), b.shape, b.values.data(), result.values.data());
    return result;
}

// The components [first, first + width) of the records.
Scaled components(const BezierPiece &piece, int first, int width) {
    Scaled result{piece.shape(), {}};
    result.shape.width = width;
    result.values = binomial_factors(result.shape);
    auto value = result.values.begin();
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        for (int c = first; c < first + width; ++c) {
            *value++ *= piece.record(i)[c];
        }
    }
    return result;
}

// From (n choose i) a_i of degree n to the same for the derivative: n (n - 1 choose i) (a_(i+1) - a_i).
Scaled derivative(const Scaled &a, int axis) {
    Scaled result{a.shape, {}};
    const int n = a.shape.degrees[static_cast<size_t>(axis)];
    const AxisLayers from = a.shape.along(axis);
    --result.shape.degrees[static_cast<size_t>(axis)];
    for (int64_t o = 0; o < from.outer; ++o) {
        for (int i = 0; i < n; ++i) {
            for (int64_t c = 0; c < from.inner; ++c) {
                const auto at = [&](int layer) {
                    return a.values[static_cast<size_t>(from.at(o, layer, c))];
                };
                result.values.push_back((i + 1) * at(i + 1) - (n - i) * at(i));
            }
        }
    }
    return result;
}

int64_t weights_of(const BezierPiece &piece, double &least, double &most) noexcept {
    least = most = piece.weight(0);
    int64_t others = 0;
    for (int64_t i = 1; i < piece.coefficients(); ++i) {
        const double w = piece.weight(i);
        least = std::min(least, w);
        most = std::max(most, w);
        others += w != piece.weight(0) ? 1 : 0;
    }
    return others;
}

} // namespace

Slopes::Slopes(const BezierPiece &piece, int axis) : dim_(static_cast<size_t>(piece.dim())) {
    const int p = piece.degree(axis);
    double least = 1, most = 1;
    const bool even = weights_of(piece, least, most) == 0;
    count_work(16 * piece.coefficients() * piece.dim());
    if (p == 0) {
        vectors_.assign(dim_, 0.0);
    } else if (even) {
        set_polynomial(piece, axis);
    } else {
        set_rational(piece, axis);
    }
    const size_t size = vectors_.size();
    vectors_.resize(size + dim_, 0.0);
    for (size_t i = 0; i < size; ++i) {
        vectors_[size + i % dim_] += vectors_[i] / static_cast<double>(count());
    }
    for (size_t i = 0; i < count(); ++i) {
        largest_ = std::max(largest_, dot(vector(i), vector(i), piece.dim()));
    }
    largest_ = std::sqrt(largest_) + 0x1p-500; // squares may have underflowed
    // Coefficients have the errors of the points; the derivative takes differences of p of them, in quotients
    // by squares of weights.
    const double ratio = most / least;
    int degrees = 0;
    for (int k = 0; k < piece.axes(); ++k) {
        degrees += piece.degree(k);
    }
    error_ = 4 * (p + 1) * ratio * ratio * (piece.moved() + 8 * (degrees + 2) * eps * piece.reach());
}

Interval Slopes::along(const double *direction) const noexcept {
    const int dim = static_cast<int>(dim_);
    Interval range{infinity, -infinity};
    for (size_t i = 0; i < count(); ++i) {
        const double x = dot(direction, vector(i), dim);
        range = {std::min(range.lower, x), std::max(range.upper, x)};
    }
    const double room = 1.01 * error_ + 4 * dim * eps * largest_;
    return {range.lower - room, range.upper + room};
}

void Slopes::set_polynomial(const BezierPiece &piece, int axis) {
    BernsteinShape points = piece.shape();
    points.width = piece.dim();
    const AxisLayers layers = points.along(max_axes - piece.axes() + axis);
    vectors_.reserve(static_cast<size_t>(points.values()) + dim_);
    for (int64_t o = 0; o < layers.outer; ++o) {
        for (int i = 0; i < layers.degree; ++i) {
            const double *a = piece.point(0) + layers.at(o, i, 0), *b = a + layers.inner;
            for (int64_t c = 0; c < layers.inner; ++c) {
                vectors_.push_back(layers.degree * (b[c] - a[c]));
            }
        }
    }
}

void Slopes::set_rational(const BezierPiece &piece, int axis) {
    const int k = max_axes - piece.axes() + axis;
    const Scaled a = components(piece, 0, piece.dim()), w = components(piece, piece.dim(), 1);
    const Scaled square = product(w, w), first = product(derivative(a, k), w),
                 second = product(a, derivative(w, k));
    const AxisLayers from = first.shape.along(k), to = square.shape.along(k);
    vectors_.resize(square.values.size() * dim_);
    for (size_t j = 0; j < vectors_.size(); ++j) { // of degree 2 p - 1, elevated by one
        const auto coefficient = static_cast<int64_t>(j / dim_),
                   o = coefficient / (to.inner * (to.degree + 1)),
                   i = coefficient / to.inner % (to.degree + 1);
        const int64_t c =
            coefficient % to.inner * static_cast<int64_t>(dim_) + static_cast<int64_t>(j % dim_);
        const auto at = [&](int64_t layer) {
            if (layer < 0 || layer > from.degree) {
                return 0.0;
            }
            const auto place = static_cast<size_t>(from.at(o, static_cast<int>(layer), c));
            return first.values[place] - second.values[place];
        };
        vectors_[j] = (at(i) + at(i - 1)) / square.values[j / dim_];
    }
}

} // namespace nrb::pieces
