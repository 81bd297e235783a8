// SPDX-License-Identifier: MIT
#include "numeric/exact_products.h"

#include <array>
#include <cmath>

namespace nrb::inline numeric {

namespace {

int sign(double x) noexcept {
    return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0);
}

// The exact product of two numbers as (high + low) 2^exponent; |high| is in [1/4, 1).
struct Product {
    double high = 0;
    double low = 0;
    int exponent = 0;

    Product(double a, double b) noexcept {
        int first = 0, second = 0;
        const double x = std::frexp(a, &first), y = std::frexp(b, &second);
        high = x * y;
        low = std::fma(x, y, -high);
        exponent = first + second;
    }
};

// The sign of (high + low) - (other_high + other_low), where each low part is at most half an ulp of its high
// part.
int compare(double high, double low, double other_high, double other_low) noexcept {
    const double difference = high - other_high; // exact where the magnitudes are within a factor of 2
    if (difference == 0) {
        return sign(low - other_low);
    }
    const double rest = low - other_low;
    const double sum = difference + rest;
    if (sum != 0) { // rounding is monotone: the sum has the sign of the exact one
        return sign(sum);
    }
    const double part = rest - low; // Knuth's two-sum: the error of rest
    return sign((low - (rest - part)) - (other_low + part));
}

} // namespace

int compare_products(double a, double b, double c, double d) noexcept {
    const Product left(a, b), right(c, d);
    const int one = sign(left.high), other = sign(right.high);
    if (one != other || one == 0) {
        return sign(one - other);
    }
    const int apart = left.exponent - right.exponent;
    if (apart > 2 || apart < -2) {
        return apart > 0 ? one : -one;
    }
    return compare(std::ldexp(left.high, apart), std::ldexp(left.low, apart), right.high, right.low);
}

double difference_of_products(double a, double b, double c, double d) noexcept {
    const double product = c * d;
    return std::fma(a, b, -product) + std::fma(-c, d, product);
}

namespace {

// An exact sum of numbers, as an expansion in Shewchuk's sense: nonoverlapping components of increasing
// magnitude.
class Expansion {
public:
    void add(double x) noexcept {
        for (int i = 0; i < size_; ++i) {
            double &component = components_[static_cast<size_t>(i)];
            const double sum = x + component, part = sum - x; // Knuth's two-sum
            component = (x - (sum - part)) + (component - part);
            x = sum;
        }
        components_[static_cast<size_t>(size_++)] = x;
    }
    void add_product(double a, double b) noexcept {
        const double high = a * b;
        add(std::fma(a, b, -high));
        add(high);
    }
    [[nodiscard]] int sign_of_sum() const noexcept {
        for (int i = size_; i-- > 0;) {
            if (components_[static_cast<size_t>(i)] != 0) {
                return sign(components_[static_cast<size_t>(i)]);
            }
        }
        return 0;
    }

private:
    std::array<double, 12> components_{};
    int size_ = 0;
};

} // namespace

int side_of_line(const double *a, const double *b, const double *c) noexcept {
    const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
    constexpr double unit = 0x1p-53;
    const double value = left - right, bound = (3 + 16 * unit) * unit * (std::fabs(left) + std::fabs(right));
    if (std::fabs(value) > bound && bound > 0x1p-960) {
        return sign(value);
    }
    double largest = 0;
    for (const double *const x : {a, b, c}) {
        largest = std::fmax(largest, std::fmax(std::fabs(x[0]), std::fabs(x[1])));
    }
    const double scale =
        largest > 0 ? std::ldexp(1.0, -std::ilogb(largest) / 2) : 1; // its square might overflow
    const auto at = [scale](const double *x, int k) { return x[k] * scale * scale; };
    Expansion sum;
    const double *const points[] = {a, b, c, a};
    for (int i = 0; i < 3; ++i) {
        sum.add_product(at(points[i], 0), at(points[i + 1], 1));
        sum.add_product(-at(points[i], 1), at(points[i + 1], 0));
    }
    return sum.sign_of_sum();
}

} // namespace nrb::inline numeric
