// SPDX-License-Identifier: MIT
#include "intersect/pairs/slopes.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/binomial.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// Bernstein coefficients times their binomials, so that products are convolutions.
using Scaled = std::vector<double>;

Scaled product(const Scaled &a, const Scaled &b) {
    Scaled result(a.size() + b.size() - 1, 0.0);
    for (size_t i = 0; i < a.size(); ++i) {
        for (size_t j = 0; j < b.size(); ++j) {
            result[i + j] += a[i] * b[j];
        }
    }
    return result;
}

Scaled component(const pieces::BezierPiece &piece, int c) {
    const int p = piece.degree(0);
    Scaled values;
    for (int i = 0; i <= p; ++i) {
        values.push_back(binomial(p, i) * piece.record(i)[c]);
    }
    return values;
}

// (n choose i) a_i of degree n to the same of its derivative: n (n - 1 choose i) (a_(i + 1) - a_i).
Scaled derivative(const Scaled &a) {
    const auto n = static_cast<double>(a.size() - 1);
    Scaled result;
    for (size_t i = 0; i + 1 < a.size(); ++i) {
        const auto at = static_cast<double>(i);
        result.push_back((at + 1) * a[i + 1] - (n - at) * a[i]);
    }
    return result;
}

} // namespace

Slopes::Slopes(const pieces::BezierPiece &piece) : dim_(static_cast<size_t>(piece.dim())) {
    const int p = piece.degree(0);
    bool even = true;
    double least = piece.weight(0), most = least;
    for (int i = 1; i <= p; ++i) {
        least = std::min(least, piece.weight(i));
        most = std::max(most, piece.weight(i));
        even = even && piece.weight(i) == piece.weight(0);
    }
    count_work(16 * (p + 1) * piece.dim());
    if (p == 0) {
        vectors_.assign(dim_, 0.0);
    } else if (even) {
        set_polynomial(piece);
    } else {
        set_rational(piece);
    }
    const size_t size = vectors_.size();
    vectors_.resize(size + dim_, 0.0);
    for (size_t i = 0; i < size; ++i) {
        vectors_[size + i % dim_] += vectors_[i] / static_cast<double>(count());
    }
    for (size_t i = 0; i < count(); ++i) {
        largest_ = std::max(largest_, norm(vector(i), piece.dim()));
    }
    // Coefficients are off by what points are; differences of p of them, in quotients of squares of weights.
    const double ratio = most / least;
    error_ = 4 * (p + 1) * ratio * ratio * (piece.moved() + 8 * (p + 2) * eps * piece.reach());
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

void Slopes::set_polynomial(const pieces::BezierPiece &piece) {
    const int p = piece.degree(0);
    vectors_.reserve((static_cast<size_t>(p) + 1) * dim_);
    for (int i = 0; i < p; ++i) {
        const double *a = piece.point(i), *b = piece.point(i + 1);
        for (size_t c = 0; c < dim_; ++c) {
            vectors_.push_back(p * (b[c] - a[c]));
        }
    }
}

void Slopes::set_rational(const pieces::BezierPiece &piece) {
    const Scaled w = component(piece, piece.dim()), slope_of_w = derivative(w), square = product(w, w);
    vectors_.resize(square.size() * dim_);
    for (size_t c = 0; c < dim_; ++c) {
        const Scaled a = component(piece, static_cast<int>(c));
        const Scaled first = product(derivative(a), w), second = product(a, slope_of_w);
        for (size_t i = 0; i < square.size(); ++i) { // of degree 2 p - 1, raised by one
            const double here = i < first.size() ? first[i] - second[i] : 0,
                         before = i > 0 ? first[i - 1] - second[i - 1] : 0;
            vectors_[i * dim_ + c] = (here + before) / square[i];
        }
    }
}

} // namespace nrb::intersect
