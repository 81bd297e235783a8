// SPDX-License-Identifier: MIT
#include "measure/element_shape.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

constexpr double most_ratio = 64, enough = 0.25;

} // namespace

ElementShape::ElementShape(const Elements &elements)
    : axes_(elements.axes()), dim_(elements.dim()), rational_(elements.rational()),
      coefficients_(elements.coefficients()) {
    for (int k = 0; k < axes_; ++k) {
        degrees_[static_cast<size_t>(k)] = elements.degree(k);
    }
    points_.resize(static_cast<size_t>(coefficients_ * dim_));
    sum_.resize(static_cast<size_t>(dim_));
}

// The cosine of the angle between two vectors given by their components; 1 if one of them is no more than
// rounding.
template <class A, class B>
double ElementShape::cosine(A &&a, B &&b) const noexcept {
    double product = 0, first = 0, second = 0;
    for (int c = 0; c < dim_; ++c) {
        product += a(c) * b(c);
        first += a(c) * a(c);
        second += b(c) * b(c);
    }
    return first > noise_ && second > noise_ ? product / std::sqrt(first * second) : 1;
}

bool ElementShape::even_weights(const double *weights) const noexcept {
    double least = std::abs(weights[0]), most = least;
    bool one_sign = true;
    for (int64_t i = 1; i < coefficients_; ++i) {
        one_sign = one_sign && weights[i] * weights[0] > 0;
        least = std::min(least, std::abs(weights[i]));
        most = std::max(most, std::abs(weights[i]));
    }
    return one_sign && most <= most_ratio * least;
}

void ElementShape::divide(const double *net) noexcept {
    for (int64_t i = 0; i < coefficients_; ++i) {
        const double factor = rational_ ? 1 / net[dim_ * coefficients_ + i] : 1;
        for (int c = 0; c < dim_; ++c) {
            points_[static_cast<size_t>(i * dim_ + c)] = net[c * coefficients_ + i] * factor;
        }
    }
}

int64_t ElementShape::step(int axis) const noexcept {
    int64_t step = 1;
    for (int k = axes_; k-- > axis + 1;) {
        step *= degrees_[static_cast<size_t>(k)] + 1;
    }
    return step;
}

int ElementShape::layer(int64_t i, int axis) const noexcept {
    return static_cast<int>(i / step(axis) % (degrees_[static_cast<size_t>(axis)] + 1));
}

// The smallest cosine of the angles between the legs along an axis and their sum; legs of length 0 do not
// count.
double ElementShape::least_cosine(int axis) noexcept {
    const int64_t size = step(axis) * dim_;
    std::fill(sum_.begin(), sum_.end(), 0.0);
    for (int64_t i = 0; i < coefficients_; ++i) {
        const double *p = points_.data() + i * dim_;
        for (int c = 0; c < dim_ && layer(i, axis) < degrees_[static_cast<size_t>(axis)]; ++c) {
            sum_[static_cast<size_t>(c)] += p[size + c] - p[c];
        }
    }
    double least = 1;
    for (int64_t i = 0; i < coefficients_; ++i) {
        if (layer(i, axis) < degrees_[static_cast<size_t>(axis)]) {
            const double *p = points_.data() + i * dim_;
            least = std::min(least, cosine([&](int c) { return p[size + c] - p[c]; },
                                           [&](int c) { return sum_[static_cast<size_t>(c)]; }));
        }
    }
    return least;
}

// The smallest cosine of the angles between legs along `axis` that are neighbours along `along`.
double ElementShape::turn(int axis, int along) const noexcept {
    const int64_t size = step(axis) * dim_, next = step(along);
    double least = 1;
    for (int64_t i = 0; i < coefficients_; ++i) {
        const int last = degrees_[static_cast<size_t>(along)] - (axis == along ? 2 : 1);
        if (layer(i, axis) < degrees_[static_cast<size_t>(axis)] && layer(i, along) <= last) {
            const double *p = points_.data() + i * dim_, *q = p + next * dim_;
            least = std::min(least, cosine([&](int c) { return p[size + c] - p[c]; },
                                           [&](int c) { return q[size + c] - q[c]; }));
        }
    }
    return least;
}

int ElementShape::uneven_axis(const double *net, double spread, bool legs) {
    constexpr double rounding = 256 * eps;
    noise_ = rounding * spread * (rounding * spread);
    if (rational_ && !even_weights(net + dim_ * coefficients_)) {
        for (int tried = 0; tried < axes_; ++tried) { // each axis in turn
            last_ = (last_ + 1) % axes_;
            if (degrees_[static_cast<size_t>(last_)] > 0) {
                return last_;
            }
        }
        return -1;
    }
    if (!legs) {
        return -1;
    }
    divide(net);
    bool even = true;
    for (int k = 0; k < axes_ && even; ++k) {
        even = degrees_[static_cast<size_t>(k)] == 0 || least_cosine(k) >= enough;
    }
    int worst = -1;
    double least = 2;
    for (int l = 0; l < axes_ && !even; ++l) {
        for (int k = 0; k < axes_ && degrees_[static_cast<size_t>(l)] > 0; ++k) {
            const double cosine = turn(k, l);
            if (cosine < least) {
                least = cosine;
                worst = l;
            }
        }
    }
    return worst;
}

} // namespace nrb::measure
