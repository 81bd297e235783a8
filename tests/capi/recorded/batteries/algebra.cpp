/* SPDX-License-Identifier: MIT */
// Splines that are derivatives, sums, products and compositions.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

void calculus(const Subject &s, int32_t k) {
    for (const int32_t order : {0, 1, 2, 3}) {
        nurbs_derivative(s.g, k, order, unread);
    }
    nurbs_antiderivative(s.g, k, unread);
}

// With itself, with what has the same weights and knots, and with another parameter and degree.
void sums_and_products(const Subject &s, const nurbs *other) {
    if (other == nullptr) {
        return;
    }
    nurbs_sum(s.g, 1, other, -0.5, unread);
    nurbs_sum(other, 0.3, s.g, 2, unread);
    for (const uint32_t flags : {0u, NURBS_PRODUCT_DOT, NURBS_PRODUCT_CROSS}) {
        nurbs_product(s.g, other, flags, unread);
    }
}

// A spline of as many axes with the first coordinate alone, of another degree, over the same domain.
Owned scalar(const Subject &s) {
    std::vector<double> row(static_cast<size_t>(s.dim));
    row[0] = 1;
    Owned first, made;
    nurbs_transform(s.g, 1, row.data(), nullptr, first.place());
    if (first != nullptr) {
        nurbs_elevate(first, 0, 1, made.place());
    }
    return made;
}

// Over the domain from one fraction to another, by a polynomial curve in the space of the parameters.
void compositions(const Subject &s, std::initializer_list<double> fractions) {
    const auto degree = static_cast<int32_t>(fractions.size()) - 1;
    std::vector<double> line, points;
    for (const double fraction : fractions) {
        const std::vector<double> place = s.middle(fraction);
        points.insert(points.end(), place.begin(), place.end());
    }
    Owned inner;
    nurbs_create_bezier(1, &degree, s.axes, points.data(), 0, 0, nullptr, 0, inner.place());
    if (inner != nullptr) {
        nurbs_compose(s.g, inner, unread);
    }
}

void tensors(const Subject &s, const nurbs *one) {
    Owned line;
    const std::vector<double> a = s.direction(5), b = s.direction(6);
    nurbs_curve_line(s.dim, a.data(), b.data(), line.place());
    nurbs_tensor_sum(s.g, 1, line, 0.5, unread);
    nurbs_tensor_sum(line, 2, s.g, -1, unread);
    if (one != nullptr) {
        nurbs_tensor_product(line, one, unread);
        nurbs_tensor_product(one, s.g, unread);
    }
}

} // namespace

void call_algebra(const Subject &s) {
    for (int32_t k = 0; k < s.axes; ++k) {
        calculus(s, k);
    }
    const Owned one = scalar(s);
    Owned faster;
    nurbs_reparametrize_moebius(s.g, 0, 2, faster.place());
    sums_and_products(s, one);
    if (!s.large) {
        sums_and_products(s, s.g);
        sums_and_products(s, s.image);
        sums_and_products(s, faster);
    }
    compositions(s, {0, 1});
    if (!s.large) {
        compositions(s, {0.9, 0.3, 0.1});
        compositions(s, {0.2, 0.2, 0.5, 1});
        compositions(s, {0.3, 0.8, 0.4}); // turns back
    }
    tensors(s, one);
}

} // namespace recorded
