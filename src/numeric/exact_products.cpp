// SPDX-License-Identifier: MIT
#include "numeric/exact_products.h"

#include <cmath>

namespace nrb::inline numeric {

namespace {

int sign(double x) noexcept {
    return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0);
}

// A product of two numbers as (high + low) 2^exponent, without rounding; |high| is in [1/4, 1).
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

// Of sums of two numbers each of which is at most half a unit of the first one.
int compare(double high, double low, double other_high, double other_low) noexcept {
    const double difference = high - other_high; // exact where the magnitudes are within a factor of 2
    if (difference == 0) {
        return sign(low - other_low);
    }
    const double rest = low - other_low;
    const double sum = difference + rest;
    if (sum != 0) { // rounding keeps the order of rest and -difference
        return sign(sum);
    }
    const double part = rest - low; // the error of rest, by Knuth's two-sum
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

} // namespace nrb::inline numeric
