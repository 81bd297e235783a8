// SPDX-License-Identifier: MIT
// The conjugate gradient method for linear equations with a symmetric positive definite matrix that is known
// only through products (M. Hestenes, E. Stiefel, J. Res. NBS 49 (1952)).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace nrb::inline numeric {

// Returns z with A z = b to 1e-6 of |b|, or what `most` products with A yield; in exact arithmetic as many
// products as A has distinct eigenvalues are enough. Returns 0 if a search direction p has p.A p <= least
// p.p. `precondition` approximates the product of a vector with the inverse of A: the better, the fewer
// products.
template <class Product, class Precondition>
std::vector<double> conjugate_gradients(Product &&product, std::vector<double> b, double least, int most,
                                        Precondition &&precondition) {
    const auto dot = [](const std::vector<double> &x, const std::vector<double> &y) {
        return std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
    };
    const auto sum = [](const std::vector<double> &x, double factor, const std::vector<double> &y) {
        std::vector<double> result(x);
        std::transform(x.begin(), x.end(), y.begin(), result.begin(),
                       [factor](double u, double v) { return u + factor * v; });
        return result;
    };
    std::vector<double> z(b.size(), 0.0), rest = std::move(b), p = precondition(rest);
    double square = dot(rest, p);
    const double enough = 1e-12 * dot(rest, rest);
    for (int i = 0; i < most && dot(rest, rest) > enough; ++i) {
        const std::vector<double> image = product(p);
        const double curvature = dot(p, image);
        if (!(curvature > least * dot(p, p))) {
            return std::vector<double>(z.size(), 0.0);
        }
        z = sum(z, square / curvature, p);
        rest = sum(rest, -square / curvature, image);
        const double before = square;
        const std::vector<double> conditioned = precondition(rest);
        square = dot(rest, conditioned);
        p = sum(conditioned, square / before, p);
    }
    return z;
}

template <class Product>
std::vector<double> conjugate_gradients(Product &&product, std::vector<double> b, double least, int most) {
    return conjugate_gradients(std::forward<Product>(product), std::move(b), least, most,
                               [](const std::vector<double> &x) { return x; });
}

} // namespace nrb::inline numeric
