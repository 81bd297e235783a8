// SPDX-License-Identifier: MIT
#include "bernstein/coarse_products.h"

#include "base/numbers.h"
#include "base/scratch.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline bernstein {

namespace {

constexpr int64_t work_of_a_coarse_product = 100; // for its memory

struct Largest {
    double value = 0, error = 0;
};

// The largest coefficient and the largest error of component c.
Largest largest_of(const RoundedPolynomial &a, int c) noexcept {
    Largest found;
    for (size_t i = static_cast<size_t>(c); i < a.values.size(); i += static_cast<size_t>(a.shape.width)) {
        found.value = std::max(found.value, std::abs(a.values[i]));
        found.error = std::max(found.error, a.error(i));
    }
    return found;
}

// Each coefficient has as many rounding errors (`steps`) as in the products of RoundedPolynomial, for sums
// over `sums` products.
double error_of(const Largest &a, const Largest &b, double steps) noexcept {
    return a.value * b.error + a.error * (b.value + b.error) + steps * eps * a.value * b.value;
}

double steps_of(const BernsteinShape &a, const BernsteinShape &b, const BernsteinShape &product, int sums) {
    const double terms = static_cast<double>(std::min(a.coefficients(), b.coefficients())) * sums;
    return 2 + terms / 2 + binomial_steps(a) + binomial_steps(b) + binomial_steps(product);
}

BernsteinShape as_wide(BernsteinShape shape, int width) noexcept {
    shape.width = width;
    return shape;
}

// Component c times the binomial factors.
void take_scaled(const RoundedPolynomial &a, int c, double sign, const double *binomials, size_t count,
                 double *out) noexcept {
    for (size_t i = 0; i < count; ++i) {
        out[i] =
            sign * a.values[i * static_cast<size_t>(a.shape.width) + static_cast<size_t>(c)] * binomials[i];
    }
}

} // namespace

RoundedPolynomial coarse_times(const RoundedPolynomial &a, const RoundedPolynomial &factor) {
    const BernsteinShape product = product_shape(a.shape, factor.shape);
    const auto count = static_cast<size_t>(a.shape.values()), wide = static_cast<size_t>(a.shape.width);
    const auto factors = static_cast<size_t>(factor.shape.values()),
               made = static_cast<size_t>(product.values());
    count_work(work_of_a_coarse_product + static_cast<int64_t>(count + factors + made));
    Scratch scratch(count + 2 * factors + made);
    double *left = scratch.take(count), *binomials = scratch.take(factors), *right = scratch.take(factors),
           *over = scratch.take(made);
    fill_binomial_factors(a.shape, left);
    fill_binomial_factors(factor.shape, binomials);
    fill_binomial_factors(product, over);
    std::transform(left, left + count, a.values.begin(), left, [](double x, double y) { return x * y; });
    take_scaled(factor, 0, 1, binomials, factors, right);
    RoundedPolynomial result{product, std::vector<double>(made, 0.0), std::vector<double>(made)};
    add_convolution(a.shape, left, factor.shape, right, result.values.data());
    const double steps = steps_of(a.shape, factor.shape, product, 1);
    const Largest of_factor = largest_of(factor, 0);
    for (size_t c = 0; c < wide; ++c) {
        const double error = error_of(largest_of(a, static_cast<int>(c)), of_factor, steps);
        for (size_t i = c; i < made; i += wide) {
            result.values[i] /= over[i];
            result.errors[i] = error;
        }
    }
    return result;
}

RoundedPolynomial coarse_dot(const RoundedPolynomial &a, const RoundedPolynomial &b, double last_sign) {
    const BernsteinShape of_a = as_wide(a.shape, 1), of_b = as_wide(b.shape, 1);
    const BernsteinShape product = product_shape(of_a, of_b);
    const auto count = static_cast<size_t>(of_a.values()), others = static_cast<size_t>(of_b.values()),
               made = static_cast<size_t>(product.values());
    const int width = a.shape.width;
    count_work(work_of_a_coarse_product + width * static_cast<int64_t>(count + others) +
               static_cast<int64_t>(made));
    Scratch scratch(2 * count + 2 * others + made);
    double *left_binomials = scratch.take(count), *right_binomials = scratch.take(others),
           *left = scratch.take(count), *right = scratch.take(others), *over = scratch.take(made);
    fill_binomial_factors(of_a, left_binomials);
    fill_binomial_factors(of_b, right_binomials);
    fill_binomial_factors(product, over);
    RoundedPolynomial result{product, std::vector<double>(made, 0.0), {}};
    const double steps = steps_of(of_a, of_b, product, width);
    double error = 0;
    for (int c = 0; c < width; ++c) {
        take_scaled(a, c, c + 1 == width ? last_sign : 1, left_binomials, count, left);
        take_scaled(b, c, 1, right_binomials, others, right);
        add_convolution(of_a, left, of_b, right, result.values.data());
        error += error_of(largest_of(a, c), largest_of(b, c), steps);
    }
    std::transform(result.values.begin(), result.values.end(), over, result.values.begin(),
                   [](double sum, double binomial) { return sum / binomial; });
    result.errors.assign(made, error);
    return result;
}

RoundedPolynomial coarse_raised(const RoundedPolynomial &a, const BernsteinShape &shape) {
    BernsteinShape rest;
    for (size_t k = 0; k < rest.degrees.size(); ++k) {
        rest.degrees[k] = shape.degrees[k] - a.shape.degrees[k];
    }
    if (rest.coefficients() == 1) {
        return a;
    }
    const auto count = static_cast<size_t>(rest.coefficients());
    return coarse_times(a, {rest, std::vector<double>(count, 1.0), std::vector<double>(count, 0.0)});
}

} // namespace nrb::inline bernstein
