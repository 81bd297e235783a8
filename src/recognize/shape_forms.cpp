// SPDX-License-Identifier: MIT
#include "recognize/shape_forms.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

// The range of quotients of coefficients; infinite unless the denominators are >= 0, and 0 only with the
// numerator. A relative error of the denominators changes a weighted mean of the quotients by twice that
// error, and the quotients themselves are rounded once.
FormRange range_of(const std::vector<double> &numerators, const std::vector<double> &denominators,
                   double error, double relative) noexcept {
    double least = infinity, most = -infinity;
    for (size_t i = 0; i < numerators.size(); ++i) {
        if (denominators[i] > 0) {
            const double quotient = numerators[i] / denominators[i];
            least = std::min(least, quotient);
            most = std::max(most, quotient);
        } else if (numerators[i] != 0 || denominators[i] < 0) {
            return {-infinity, infinity, error};
        }
    }
    const double lost = error + (2 * relative + eps) * std::max(std::abs(least), std::abs(most));
    return {least - lost, most + lost, lost};
}

double largest_quotient(const std::vector<double> &numerators,
                        const std::vector<double> &denominators) noexcept {
    const FormRange range = range_of(numerators, denominators, 0, 0);
    return std::max(std::abs(range.least), std::abs(range.most));
}

} // namespace

ShapeForms::ShapeForms(const pieces::BezierPiece &piece) : piece_(piece), single_(piece.shape()) {
    single_.width = 1;
    double_ = product_shape(single_, single_);
    product_error_ = product_error(single_, single_);
    const std::vector<double> factors = binomial_factors(single_);
    for (Values *values : {&x_, &y_, &z_, &w_}) {
        values->reserve(factors.size());
    }
    for (size_t i = 0; i < factors.size(); ++i) {
        const double *p = piece.record(static_cast<int64_t>(i));
        x_.push_back(p[0] * factors[i]);
        y_.push_back(p[1] * factors[i]);
        z_.push_back(p[2] * factors[i]);
        w_.push_back(p[3] * factors[i]);
    }
    squares_.assign(static_cast<size_t>(double_.coefficients()), 0);
    add_product(squares_, 1, w_, w_);
}

void ShapeForms::add_product(Values &sum, double factor, const Values &a, const Values &b) const {
    if (factor == 0) {
        return;
    }
    Values product(sum.size(), 0.0);
    add_convolution(single_, a.data(), single_, b.data(), product.data());
    std::transform(sum.begin(), sum.end(), product.begin(), sum.begin(),
                   [factor](double s, double p) { return s + factor * p; });
}

// The maximum of |k.x| x^2 + |k.y| y^2 + |k.z| z^2 + 2 |linear x| + |c| over the control points; it bounds
// the sum of the magnitudes of all terms, by the Cauchy-Schwarz inequality.
double ShapeForms::largest(const Quadric &squares, double linear) const noexcept {
    double quadratic = 0, reach = 0;
    for (int64_t i = 0; i < piece_.coefficients(); ++i) {
        if (piece_.has_point(i)) {
            const Vector3 p = point_of(piece_, i);
            quadratic =
                std::max(quadratic, std::abs(squares.k.x) * p.x * p.x + std::abs(squares.k.y) * p.y * p.y +
                                        std::abs(squares.k.z) * p.z * p.z);
            reach = std::max(reach, std::abs(p.x));
        }
    }
    return quadratic + 2 * std::abs(linear) * reach + std::abs(squares.c);
}

FormRange ShapeForms::range(const Values &numerators, double error) const noexcept {
    return range_of(numerators, squares_, error, product_error_);
}

ShapeForms::Values ShapeForms::numerators(const Quadric &quadric) const {
    Values sum(squares_.size(), 0.0);
    add_product(sum, quadric.k.x, x_, x_);
    add_product(sum, quadric.k.y, y_, y_);
    add_product(sum, quadric.k.z, z_, z_);
    add_product(sum, 2 * quadric.l, x_, w_);
    add_product(sum, quadric.c, w_, w_);
    return sum;
}

// Each product has its own rounding error, one of the multiplication by its coefficient, which itself is
// accurate to 3 eps, and at most 4 of the sum.
FormRange ShapeForms::quadratic(const Quadric &quadric) const {
    return range(numerators(quadric), 1.01 * (product_error_ + 6 * eps) * largest(quadric, quadric.l));
}

// (k.x x + l w)^2 + (k.y y)^2 + (k.z z)^2.
FormRange ShapeForms::squared_gradient(const Quadric &quadric) const {
    const Vector3 &k = quadric.k;
    const Quadric squares{{k.x * k.x, k.y * k.y, k.z * k.z}, k.x * quadric.l, quadric.l * quadric.l};
    return range(numerators(squares), 1.01 * (product_error_ + 10 * eps) * largest(squares, squares.l));
}

// The product is G^2 - 4 R^2 S or, with K = G - 2 R^2 and V = z^2 - r^2, equivalently K^2 + 4 R^2 V. Near the
// axis, G and S are small; on a slender torus, K and V are. The form with the smaller rounding error is used.
TorusForms ShapeForms::torus(double major, double minor) const {
    const double apart = (major - minor) * (major + minor), four = 4 * major * major;
    Values radius(squares_.size(), 0.0), height = radius;
    add_product(radius, 1, x_, x_);
    add_product(radius, 1, y_, y_);
    add_product(height, 1, z_, z_);
    Values sum = radius, other = radius;
    for (size_t i = 0; i < sum.size(); ++i) {
        const double both = radius[i] + height[i];
        sum[i] = both + apart * squares_[i];
        other[i] = both - (major * major + minor * minor) * squares_[i];
        height[i] -= minor * minor * squares_[i];
    }
    const double error = 1.01 * (product_error_ + 6 * eps);
    const double sum_error = error * largest({{1, 1, 1}, 0, apart}, 0);
    const double radius_error = error * largest({{1, 1, 0}, 0, 0}, 0);
    const Fourth near_axis = fourth(sum, sum_error, radius, radius_error, -four);
    const Fourth slender = fourth(other, error * largest({{1, 1, 1}, 0, major * major + minor * minor}, 0),
                                  height, error * largest({{0, 0, 1}, 0, minor * minor}, 0), four);
    return {range(sum, sum_error), range(radius, radius_error),
            product(near_axis.error < slender.error ? near_axis : slender)};
}

ShapeForms::Fourth ShapeForms::fourth(const Values &a, double a_error, const Values &b, double b_error,
                                      double factor) const {
    const double most = largest_quotient(a, squares_) + a_error;
    const double other = largest_quotient(b, squares_) + b_error;
    const double again = product_error(double_, double_);
    const double square_error = 2 * most * a_error + (again + 2 * eps) * most * most;
    const double rest_error = b_error + (product_error_ + again + 4 * eps) * other;
    return {a, b, factor, 1.01 * (square_error + std::abs(factor) * rest_error)};
}

FormRange ShapeForms::product(const Fourth &form) const {
    const BernsteinShape shape = product_shape(double_, double_);
    Values square(static_cast<size_t>(shape.coefficients()), 0.0), rest = square, powers = square;
    add_convolution(double_, form.a.data(), double_, form.a.data(), square.data());
    add_convolution(double_, form.b.data(), double_, squares_.data(), rest.data());
    add_convolution(double_, squares_.data(), double_, squares_.data(), powers.data());
    for (size_t i = 0; i < square.size(); ++i) {
        square[i] += form.factor * rest[i];
    }
    return range_of(square, powers, form.error, product_error(double_, double_) + 2 * product_error_);
}

} // namespace nrb::recognize
