// SPDX-License-Identifier: MIT
#include "refine/algebra/quotient_rule.h"

#include "base/limits.h"
#include "refine/algebra/derivative.h"
#include "refine/algebra/polynomial.h"
#include "refine/algebra/product.h"
#include "refine/degree/elevate.h"
#include "spline/at_origin.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

void check_degrees(const Spline &spline, int order) {
    for (int k = 0; k < spline.axes(); ++k) {
        const int64_t degree = (int64_t{order} + 1) * spline.axis(k).degree();
        if (degree > max_degree) {
            fail(Status::degree,
                 "derivative %d has degree (order + 1) * %d = %lld on axis %d, which exceeds the limit of %d",
                 order, spline.axis(k).degree(), static_cast<long long>(degree), k, max_degree);
        }
    }
}

// Components first, ..., first + size - 1 of the records of a polynomial spline.
SplinePtr components(const Spline &spline, int first, int size) {
    std::vector<double> points;
    points.reserve(static_cast<size_t>(spline.point_count() * size));
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const auto from = spline.points().begin() + i * spline.dim() + first;
        points.insert(points.end(), from, from + size);
    }
    return polynomial_result(spline.knot_vectors(), size, std::move(points));
}

// The product with a spline of dimension 1. Knots of `axis` get `extra` more copies than they need.
SplinePtr scaled(const Spline &spline, const Spline &factor, int axis, int extra) {
    std::array<int, 3> copies{};
    copies[static_cast<size_t>(axis)] = extra;
    const std::vector<CommonKnots> joint = product_axes(spline.knot_vectors(), factor.knot_vectors(), copies);
    const int dim = spline.dim();
    Bilinear form;
    for (int c = 0; c < dim; ++c) {
        form.push_back({c, c, 0});
    }
    return polynomial_result(axes_of(joint), dim,
                             product_records({spline.knot_vectors(), spline.points(), dim},
                                             {factor.knot_vectors(), factor.points(), 1}, joint, dim, form));
}

void check_same_knots(const Spline &a, const Spline &b) {
    for (int k = 0; k < a.axes(); ++k) {
        if (!std::ranges::equal(a.axis(k).knots(), b.axis(k).knots())) {
            fail(Status::internal, "terms of the quotient rule differ in their knots on axis %d", k);
        }
    }
}

// N_(n+1) from N_n. A knot of multiplicity m in w has multiplicity p n + m in N_n. If n > 0, the first term
// needs one more copy of it than the second, which gets that copy as `extra`.
SplinePtr next_numerator(const SplinePtr &numerator, const SplinePtr &weight, int axis, int n) {
    const SplinePtr first = scaled(*polynomial_derivative(numerator, axis, 1), *weight, axis, 0);
    const SplinePtr second = scaled(*numerator, *polynomial_derivative(weight, axis, 1), axis, n > 0 ? 1 : 0);
    check_same_knots(*first, *second);
    std::vector<double> points(first->points().begin(), first->points().end());
    for (size_t i = 0; i < points.size(); ++i) {
        points[i] -= (n + 1) * second->points()[i];
    }
    return polynomial_result(first->knot_vectors(), first->dim(), std::move(points));
}

// w^(n+1). The last multiplication adds the n copies of each knot that the numerator has in addition.
SplinePtr power(const SplinePtr &weight, int axis, int n) {
    SplinePtr result = weight;
    for (int i = 1; i <= n; ++i) {
        result = scaled(*result, *weight, axis, i == n ? n : 0);
    }
    return result;
}

std::vector<double> side_by_side(const Spline &numerator, const Spline &denominator) {
    std::vector<double> records;
    const int dim = numerator.dim();
    records.reserve(static_cast<size_t>(numerator.point_count() * (dim + 1)));
    for (int64_t i = 0; i < numerator.point_count(); ++i) {
        const auto from = numerator.points().begin() + i * dim;
        records.insert(records.end(), from, from + dim);
        records.push_back(denominator.points()[static_cast<size_t>(i)]);
    }
    return records;
}

} // namespace

// The spline is moved to the origin first: otherwise the parts of N_n' w and N_n w' that are proportional to
// the distance from the origin would cancel.
SplinePtr rational_derivative(const Spline &given, int axis, int order) {
    const Spline &spline = at_origin(given);
    check_degrees(spline, order);
    const SplinePtr records = polynomial_result(spline.knot_vectors(), spline.width(),
                                                {spline.records().begin(), spline.records().end()});
    SplinePtr numerator = components(*records, 0, spline.dim());
    if (spline.axis(axis).degree() == 0) {
        return polynomial_derivative(numerator, axis, 1);
    }
    const SplinePtr weight = components(*records, spline.dim(), 1);
    for (int n = 0; n < order; ++n) {
        numerator = next_numerator(numerator, weight, axis, n);
    }
    numerator = elevate(numerator, axis, order);
    const SplinePtr denominator = power(weight, axis, order);
    check_same_knots(*numerator, *denominator);
    return from_records(numerator->knot_vectors(), spline.dim(), spline.form(),
                        side_by_side(*numerator, *denominator));
}

} // namespace nrb::refine
