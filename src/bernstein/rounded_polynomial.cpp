// SPDX-License-Identifier: MIT
#include "bernstein/rounded_polynomial.h"

#include "base/numbers.h"
#include "base/scratch.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::inline bernstein {

namespace {

constexpr int64_t work_of_a_product = 400; // for its memory

// Products of pairs of polynomials of two fixed shapes.
class Convolution {
public:
    Convolution(const BernsteinShape &a, const BernsteinShape &b)
        : a_(a), b_(b), product_(product_shape(a, b)),
          scratch_(2 * size(a) + 2 * size(b) + 3 * size(product_)), left_(scratch_.take(size(a))),
          right_(scratch_.take(size(b))), over_(scratch_.take(size(product_))), x_(scratch_.take(size(a))),
          y_(scratch_.take(size(b))), sum_(scratch_.take(size(product_))) {
        fill_binomial_factors(a, left_);
        fill_binomial_factors(b, right_);
        fill_binomial_factors(product_, over_);
    }

    // Multiplies the coefficients x(i) and y(i); the result is valid until the next call.
    template <class Left, class Right>
    const double *operator()(Left &&x, Right &&y) {
        for (size_t i = 0; i < size(a_); ++i) {
            x_[i] = x(i) * left_[i];
        }
        for (size_t i = 0; i < size(b_); ++i) {
            y_[i] = y(i) * right_[i];
        }
        std::fill_n(sum_, size(product_), 0.0);
        add_convolution(a_, x_, b_, y_, sum_);
        for (size_t i = 0; i < size(product_); ++i) {
            sum_[i] /= over_[i];
        }
        return sum_;
    }

private:
    static size_t size(const BernsteinShape &shape) noexcept { return static_cast<size_t>(shape.values()); }

    const BernsteinShape &a_, &b_;
    BernsteinShape product_;
    Scratch scratch_;
    double *left_, *right_, *over_; // binomial factors
    double *x_, *y_, *sum_;
};

RoundedPolynomial raised_to(const RoundedPolynomial &a, const BernsteinShape &shape) {
    BernsteinShape rest;
    for (size_t k = 0; k < rest.degrees.size(); ++k) {
        rest.degrees[k] = shape.degrees[k] - a.shape.degrees[k];
    }
    if (rest.coefficients() == 1) {
        return a;
    }
    const std::vector<double> ones(static_cast<size_t>(rest.coefficients()), 1.0);
    return a * RoundedPolynomial{rest, ones, std::vector<double>(ones.size(), 0.0)};
}

// Each step of taking means has a rounding error of 3 / 2 eps.
void add_rounding_of_means(RoundedPolynomial &a, int degree) noexcept {
    for (size_t i = 0; i < a.values.size(); ++i) {
        a.errors[i] += 1.5 * degree * eps * std::abs(a.values[i]);
    }
}

} // namespace

RoundedPolynomial constant(double value) {
    return {{}, {value}, {0}};
}

RoundedPolynomial component(const RoundedPolynomial &a, int c) {
    RoundedPolynomial result{a.shape, {}, {}};
    result.shape.width = 1;
    for (size_t i = static_cast<size_t>(c); i < a.values.size(); i += static_cast<size_t>(a.shape.width)) {
        result.values.push_back(a.values[i]);
        result.errors.push_back(a.errors[i]);
    }
    return result;
}

RoundedPolynomial side_by_side(const std::vector<RoundedPolynomial> &components) {
    RoundedPolynomial result{components.front().shape, {}, {}};
    result.shape.width = static_cast<int>(components.size());
    for (size_t i = 0; i < components.front().values.size(); ++i) {
        for (const RoundedPolynomial &c : components) {
            result.values.push_back(c.values[i]);
            result.errors.push_back(c.errors[i]);
        }
    }
    return result;
}

// (a + e)(b + f) = a b + a f + e (b + f), plus the rounding of a b: binomials of both factors and of the
// product, three multiplications, and sums of as many terms as the smaller factor has coefficients; half an
// eps each.
RoundedPolynomial operator*(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    count_work(work_of_a_product + 4 * (a.shape.values() + b.shape.values()));
    RoundedPolynomial result{product_shape(a.shape, b.shape), {}, {}};
    Convolution convolution(a.shape, b.shape);
    const auto of = [](const std::vector<double> &values) { return [&](size_t i) { return values[i]; }; };
    const auto size_of = [](const std::vector<double> &values) {
        return [&](size_t i) { return std::abs(values[i]); };
    };
    const auto count = static_cast<size_t>(result.shape.values());
    const double *found = convolution(of(a.values), of(b.values));
    result.values.assign(found, found + count);
    found = convolution(of(a.errors), [&](size_t i) { return std::abs(b.values[i]) + b.errors[i]; });
    result.errors.assign(found, found + count);
    found = convolution(size_of(a.values), of(b.errors));
    std::transform(found, found + count, result.errors.begin(), result.errors.begin(), std::plus<>());
    const double terms = static_cast<double>(std::min(a.shape.coefficients(), b.shape.coefficients()));
    const double steps =
        2 + terms / 2 + binomial_steps(a.shape) + binomial_steps(b.shape) + binomial_steps(result.shape);
    found = convolution(size_of(a.values), size_of(b.values));
    std::transform(found, found + count, result.errors.begin(), result.errors.begin(),
                   [steps](double size, double error) { return error + steps * eps * size; });
    return result;
}

RoundedPolynomial sum(const RoundedPolynomial &a, double factor, const RoundedPolynomial &b) {
    BernsteinShape shape = a.shape;
    for (size_t k = 0; k < shape.degrees.size(); ++k) {
        shape.degrees[k] = std::max(a.shape.degrees[k], b.shape.degrees[k]);
    }
    RoundedPolynomial result = raised_to(a, shape);
    const RoundedPolynomial other = raised_to(b, shape);
    for (size_t i = 0; i < result.values.size(); ++i) {
        const double term = factor * other.values[i];
        result.values[i] += term;
        result.errors[i] +=
            std::abs(factor) * other.errors[i] + eps * (std::abs(term) + std::abs(result.values[i]));
    }
    return result;
}

RoundedPolynomial scaled(RoundedPolynomial a, double factor) {
    for (size_t i = 0; i < a.values.size(); ++i) {
        a.values[i] *= factor;
        a.errors[i] = a.errors[i] * std::abs(factor) + eps * std::abs(a.values[i]);
    }
    return a;
}

RoundedPolynomial dot(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    RoundedPolynomial result = component(a, 0) * component(b, 0);
    for (int c = 1; c < a.shape.width; ++c) {
        result = result + component(a, c) * component(b, c);
    }
    return result;
}

RoundedPolynomial cross(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    const auto minor = [&](int i, int j) {
        return component(a, i) * component(b, j) - component(a, j) * component(b, i);
    };
    return a.shape.width == 2 ? minor(0, 1) : side_by_side({minor(1, 2), minor(2, 0), minor(0, 1)});
}

RoundedPolynomial derivative(const RoundedPolynomial &a, int axis) {
    const AxisLayers from = a.shape.along(axis);
    RoundedPolynomial result{a.shape, {}, {}};
    int &degree = result.shape.degrees[static_cast<size_t>(axis)];
    degree = std::max(0, degree - 1);
    result.values.assign(static_cast<size_t>(result.shape.values()), 0.0);
    result.errors = result.values;
    const AxisLayers to = result.shape.along(axis);
    for (int64_t o = 0; from.degree > 0 && o < to.outer; ++o) {
        for (int j = 0; j < from.degree; ++j) {
            for (int64_t i = 0; i < to.inner; ++i) {
                const auto low = static_cast<size_t>(from.at(o, j, i)),
                           high = static_cast<size_t>(from.at(o, j + 1, i)),
                           out = static_cast<size_t>(to.at(o, j, i));
                result.values[out] = from.degree * (a.values[high] - a.values[low]);
                result.errors[out] =
                    from.degree * (a.errors[high] + a.errors[low]) + eps * std::abs(result.values[out]);
            }
        }
    }
    return result;
}

RoundedPolynomial end_value(const RoundedPolynomial &a, int axis, bool upper) {
    const AxisLayers from = a.shape.along(axis);
    RoundedPolynomial result{a.shape, {}, {}};
    result.shape.degrees[static_cast<size_t>(axis)] = 0;
    for (int64_t o = 0; o < from.outer; ++o) {
        for (int64_t i = 0; i < from.inner; ++i) {
            const auto at = static_cast<size_t>(from.at(o, upper ? from.degree : 0, i));
            result.values.push_back(a.values[at]);
            result.errors.push_back(a.errors[at]);
        }
    }
    return result;
}

RoundedPolynomial split(RoundedPolynomial &a, int axis, double place) {
    const AxisLayers layers = a.shape.along(axis);
    count_work(a.shape.values() * layers.degree);
    add_rounding_of_means(a, layers.degree);
    RoundedPolynomial lower = a;
    subdivide(layers, place, a.values.data(), lower.values.data());
    subdivide(layers, place, a.errors.data(), lower.errors.data());
    return lower;
}

RoundedPolynomial value_at(RoundedPolynomial a, int axis, double place) {
    const AxisLayers layers = a.shape.along(axis);
    add_rounding_of_means(a, layers.degree);
    for (int64_t o = 0; o < layers.outer; ++o) {
        evaluate(layers.degree, layers.inner, place, a.values.data() + layers.at(o, 0, 0));
        evaluate(layers.degree, layers.inner, place, a.errors.data() + layers.at(o, 0, 0));
    }
    return end_value(a, axis, false);
}

// If a_0 = 0, then a = x sum_j a_(j+1) n / (j+1) B_j with B_j of degree n - 1.
int divide_end(RoundedPolynomial &a, int axis, bool upper, int most) {
    int times = 0;
    while (true) {
        const AxisLayers from = a.shape.along(axis);
        if (times >= most || !vanishes(end_value(a, axis, upper))) {
            return times;
        }
        if (from.degree == 0) {
            return -1;
        }
        RoundedPolynomial quotient{a.shape, {}, {}};
        --quotient.shape.degrees[static_cast<size_t>(axis)];
        const AxisLayers to = quotient.shape.along(axis);
        for (int64_t o = 0; o < to.outer; ++o) {
            for (int j = 0; j <= to.degree; ++j) {
                const double factor = static_cast<double>(from.degree) / (upper ? from.degree - j : j + 1);
                for (int64_t i = 0; i < to.inner; ++i) {
                    const auto at = static_cast<size_t>(from.at(o, upper ? j : j + 1, i));
                    quotient.values.push_back(a.values[at] * factor);
                    quotient.errors.push_back(a.errors[at] * factor + eps * std::abs(quotient.values.back()));
                }
            }
        }
        a = std::move(quotient);
        ++times;
    }
}

bool vanishes(const RoundedPolynomial &a) noexcept {
    for (size_t i = 0; i < a.values.size(); ++i) {
        if (!(std::abs(a.values[i]) <= a.error(i))) {
            return false;
        }
    }
    return true;
}

int certain_sign(const RoundedPolynomial &a) noexcept {
    const int first = a.sign(0);
    for (size_t i = 1; i < a.values.size(); ++i) {
        if (a.sign(i) != first) {
            return 0;
        }
    }
    return first;
}

} // namespace nrb::inline bernstein
