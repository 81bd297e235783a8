// SPDX-License-Identifier: MIT
#include "bernstein/products.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <vector>

namespace nrb::inline bernstein {

namespace {

// C(n, 0), ..., C(n, n) of any degree, each with a relative error within n eps.
class BinomialRow {
public:
    explicit BinomialRow(int n) {
        if (n <= max_product_degree) {
            row_ = binomials(n);
            return;
        }
        own_.assign(static_cast<size_t>(n) + 1, 1.0);
        for (int k = 1; 2 * k <= n; ++k) {
            const auto at = static_cast<size_t>(k);
            own_[at] = own_[static_cast<size_t>(n - k)] = own_[at - 1] * (n - k + 1) / k;
        }
        row_ = own_.data();
    }
    double operator[](int k) const noexcept { return row_[k]; }

private:
    std::vector<double> own_;
    const double *row_;
};

// Adds a, times one coefficient of the other factor, to a part of the product in which rows along the last
// axis are `row` apart and planes of the last two axes are `plane` apart.
void add_scaled(const BernsteinShape &a, const double *from, double factor, double *out, int64_t row,
                int64_t plane) noexcept {
    const int64_t length = int64_t{a.degrees[2] + 1} * a.width;
    for (int i = 0; i <= a.degrees[0]; ++i) {
        for (int j = 0; j <= a.degrees[1]; ++j, from += length) {
            double *target = out + i * plane + j * row;
            for (int64_t c = 0; c < length; ++c) {
                target[c] += factor * from[c];
            }
        }
    }
}

} // namespace

AxisLayers BernsteinShape::along(int axis) const noexcept {
    AxisLayers layers{1, degrees[static_cast<size_t>(axis)], width};
    for (int k = 0; k < max_axes; ++k) {
        (k < axis ? layers.outer : layers.inner) *= k == axis ? 1 : degrees[static_cast<size_t>(k)] + 1;
    }
    return layers;
}

double elevation_coefficient(int low, int high, int i, int j) noexcept {
    return binomial(low, j) * binomial(high - low, i - j) / binomial(high, i);
}

BernsteinShape product_shape(const BernsteinShape &a, const BernsteinShape &b) noexcept {
    BernsteinShape shape = a;
    for (size_t k = 0; k < shape.degrees.size(); ++k) {
        shape.degrees[k] += b.degrees[k];
    }
    return shape;
}

// Each factor and the quotient are rounded once for every binomial and once more, and as often for the
// binomials themselves; the sums have at most as many terms as the smaller factor has coefficients.
double product_error(const BernsteinShape &a, const BernsteinShape &b) noexcept {
    return eps / 2 * (static_cast<double>(std::min(a.coefficients(), b.coefficients())) + 18);
}

double binomial_steps(const BernsteinShape &shape) noexcept {
    double steps = 1;
    for (const int n : shape.degrees) {
        steps += n <= max_product_degree ? 0.5 : n;
    }
    return steps;
}

void fill_binomial_factors(const BernsteinShape &shape, double *out) {
    const BinomialRow first(shape.degrees[0]), second(shape.degrees[1]), third(shape.degrees[2]);
    for (int i = 0; i <= shape.degrees[0]; ++i) {
        for (int j = 0; j <= shape.degrees[1]; ++j) {
            for (int k = 0; k <= shape.degrees[2]; ++k) {
                out = std::fill_n(out, shape.width, first[i] * second[j] * third[k]);
            }
        }
    }
}

std::vector<double> binomial_factors(const BernsteinShape &shape) {
    std::vector<double> factors(static_cast<size_t>(shape.values()));
    fill_binomial_factors(shape, factors.data());
    return factors;
}

void add_convolution(const BernsteinShape &a, const double *left, const BernsteinShape &b,
                     const double *right, double *out) {
    const BernsteinShape product = product_shape(a, b);
    const int64_t row = int64_t{product.degrees[2] + 1} * a.width, plane = (product.degrees[1] + 1) * row;
    const int64_t work = a.values() * (b.degrees[1] + 1) * (b.degrees[2] + 1);
    for (int i = 0; i <= b.degrees[0]; ++i) {
        count_work(work);
        for (int j = 0; j <= b.degrees[1]; ++j) {
            double *target = out + i * plane + j * row;
            for (int k = 0; k <= b.degrees[2]; ++k, target += a.width) {
                add_scaled(a, left, *right++, target, row, plane);
            }
        }
    }
}

} // namespace nrb::inline bernstein
