#include "bounds/bernstein.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Calls body with the product of the binomials that belong to a coefficient.
template <class Body>
void for_each_binomial(const BernsteinShape &shape, Body &&body) {
    const auto &[a, b, c] = shape.degrees;
    const double *first = binomials(a), *second = binomials(b), *third = binomials(c);
    for (int i = 0; i <= a; ++i) {
        for (int j = 0; j <= b; ++j) {
            for (int k = 0; k <= c; ++k) {
                body(first[i] * second[j] * third[k]);
            }
        }
    }
}

// Times (or divided by) the binomials, after which products are convolutions.
std::vector<double> weighted(const BernsteinShape &shape, const double *values) {
    std::vector<double> result(values, values + shape.values());
    double *at = result.data();
    for_each_binomial(shape, [&](double factor) {
        std::for_each_n(at, shape.width, [factor](double &x) { x *= factor; });
        at += shape.width;
    });
    return result;
}

void unweight(const BernsteinShape &shape, double *values) {
    for_each_binomial(shape, [&](double factor) {
        std::for_each_n(values, shape.width, [factor](double &x) { x /= factor; });
        values += shape.width;
    });
}

// Adds a, times one coefficient of the other factor, to a part of the product, in which rows along the last
// axis and planes of the last two lie so far apart.
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

// Each factor and the quotient take a rounding for every binomial and one more, and as many for the binomials
// themselves; the sums have at most as many terms as the smaller factor has coefficients.
double product_error(const BernsteinShape &a, const BernsteinShape &b) noexcept {
    return eps / 2 * (static_cast<double>(std::min(a.coefficients(), b.coefficients())) + 18);
}

void multiply(const BernsteinShape &a, const double *left, const BernsteinShape &b, const double *right,
              double *out) {
    const BernsteinShape product = product_shape(a, b);
    const std::vector<double> l = weighted(a, left), r = weighted(b, right);
    std::fill_n(out, product.values(), 0.0);
    const int64_t row = int64_t{product.degrees[2] + 1} * a.width, plane = (product.degrees[1] + 1) * row;
    const double *factor = r.data();
    for (int i = 0; i <= b.degrees[0]; ++i) {
        for (int j = 0; j <= b.degrees[1]; ++j) {
            for (int k = 0; k <= b.degrees[2]; ++k) {
                add_scaled(a, l.data(), *factor++, out + i * plane + j * row + k * a.width, row, plane);
            }
        }
    }
    unweight(product, out);
}

void halve(const BernsteinShape &shape, int axis, double *values, double *lower) noexcept {
    int64_t outer = 1, inner = shape.width;
    for (int k = 0; k < max_axes; ++k) {
        (k < axis ? outer : inner) *= k == axis ? 1 : shape.degrees[static_cast<size_t>(k)] + 1;
    }
    const int n = shape.degrees[static_cast<size_t>(axis)];
    for (int64_t o = 0; o < outer; ++o, values += (n + 1) * inner, lower += (n + 1) * inner) {
        for (int r = 0; r <= n; ++r) {
            std::copy_n(values, inner, lower + r * inner);
            std::transform(values, values + (n - r) * inner, values + inner, values,
                           [](double x, double y) { return x / 2 + y / 2; });
        }
    }
}

} // namespace nrb
