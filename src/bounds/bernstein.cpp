#include "bounds/bernstein.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double tensor_binomial(const BernsteinShape &shape, int i, int j, int k) noexcept {
    const auto &[a, b, c] = shape.degrees;
    return binomial(a, i) * binomial(b, j) * binomial(c, k);
}

template <class Body>
void for_each_coefficient(const BernsteinShape &shape, Body &&body) {
    for (int i = 0; i <= shape.degrees[0]; ++i) {
        for (int j = 0; j <= shape.degrees[1]; ++j) {
            for (int k = 0; k <= shape.degrees[2]; ++k) {
                body(i, j, k);
            }
        }
    }
}

int64_t place(const BernsteinShape &shape, int i, int j, int k) noexcept {
    return (int64_t{i} * (shape.degrees[1] + 1) + j) * (shape.degrees[2] + 1) + k;
}

// Times (or divided by) the binomials, after which products are convolutions.
std::vector<double> weighted(const BernsteinShape &shape, const double *values) {
    std::vector<double> result(values, values + shape.values());
    double *at = result.data();
    for_each_coefficient(shape, [&](int i, int j, int k) {
        const double factor = tensor_binomial(shape, i, j, k);
        std::for_each_n(at, shape.width, [factor](double &x) { x *= factor; });
        at += shape.width;
    });
    return result;
}

void unweight(const BernsteinShape &shape, double *values) {
    for_each_coefficient(shape, [&](int i, int j, int k) {
        const double factor = tensor_binomial(shape, i, j, k);
        std::for_each_n(values, shape.width, [factor](double &x) { x /= factor; });
        values += shape.width;
    });
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
    const double *from = l.data();
    for_each_coefficient(a, [&](int i, int j, int k) {
        const double *factor = r.data();
        for_each_coefficient(b, [&](int x, int y, int z) {
            double *target = out + place(product, i + x, j + y, k + z) * a.width;
            std::transform(from, from + a.width, target, target,
                           [f = *factor](double value, double sum) { return sum + f * value; });
            ++factor;
        });
        from += a.width;
    });
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
