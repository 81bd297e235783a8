/* SPDX-License-Identifier: MIT */
#include "recorded/subject.h"

#include "guarded/shape_terms.h"

#include <algorithm>
#include <cmath>

namespace recorded {

using support::Random;

namespace {

AxisFacts facts(const nurbs *g, int32_t k) {
    AxisFacts axis;
    double domain[2] = {};
    (void)nurbs_degree(g, k, &axis.degree);
    (void)nurbs_count(g, k, &axis.count);
    (void)nurbs_domain(g, k, domain);
    axis.knots.resize(static_cast<size_t>(axis.count + axis.degree + 1));
    (void)nurbs_knots(g, k, axis.count + axis.degree + 1, axis.knots.data());
    axis.lower = domain[0];
    axis.upper = domain[1];
    return axis;
}

// A rotation in the plane of the first two coordinates, or a reflection of the only one.
std::vector<double> turn(int32_t dim) {
    std::vector<double> matrix(static_cast<size_t>(dim * dim));
    for (int32_t i = 0; i < dim; ++i) {
        matrix[static_cast<size_t>(i * dim + i)] = i == 0 && dim == 1 ? -1 : i < 2 && dim > 1 ? 0.8 : 1;
    }
    if (dim > 1) {
        matrix[1] = -0.6;
        matrix[static_cast<size_t>(dim)] = 0.6;
    }
    return matrix;
}

} // namespace

Subject::Subject(const nurbs *spline, uint64_t seed) : g(spline), seed_(seed) {
    ask();
    measure();
    make_others();
}

void Subject::ask() {
    int32_t has_weights = 0;
    (void)nurbs_axes(g, &axes);
    (void)nurbs_dimension(g, &dim);
    (void)nurbs_point_count(g, &points);
    (void)nurbs_is_rational(g, &has_weights);
    large = points > 120;
    rational = has_weights != 0;
    for (int32_t k = 0; k < axes; ++k) {
        axis.push_back(facts(g, k));
    }
    control.resize(static_cast<size_t>(points * dim));
    (void)nurbs_points(g, points, control.data(), 0, 0);
    std::vector<double> weights(static_cast<size_t>(points));
    (void)nurbs_weights(g, points, weights.data(), 0);
    const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
    even = *least > 0 && *most <= 8 * *least;
}

// Points at infinity are none of the box.
void Subject::measure() {
    double longest = 0;
    for (int32_t c = 0; c < dim; ++c) {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (auto i = static_cast<size_t>(c); i < control.size(); i += static_cast<size_t>(dim)) {
            if (std::isfinite(control[i])) {
                least = std::min(least, control[i]);
                most = std::max(most, control[i]);
            }
        }
        center.push_back(least <= most ? least / 2 + most / 2 : 0);
        longest = std::max(longest, most - least);
    }
    size = longest > 0 && std::isfinite(longest) ? longest : 1;
}

void Subject::make_others() {
    std::vector<double> shift(static_cast<size_t>(dim), 0.15 * size);
    const std::vector<double> matrix = turn(dim), middle = range(0.25, 0.75);
    std::vector<double> lower, upper;
    for (size_t k = 0; k < middle.size(); k += 2) {
        lower.push_back(middle[k]);
        upper.push_back(middle[k + 1]);
    }
    Owned cut;
    (void)nurbs_transform(g, dim, matrix.data(), shift.data(), image.place());
    (void)nurbs_extract(g, lower.data(), upper.data(), cut.place());
    if (cut != nullptr) {
        (void)nurbs_transform(cut, dim, matrix.data(), shift.data(), part.place());
    }
}

double Subject::at(int32_t k, double fraction) const {
    const AxisFacts &a = axis[static_cast<size_t>(k)];
    return std::clamp(a.lower + fraction * (a.upper - a.lower), a.lower, a.upper);
}

std::vector<double> Subject::middle(double fraction) const {
    std::vector<double> params;
    for (int32_t k = 0; k < axes; ++k) {
        params.push_back(at(k, fraction));
    }
    return params;
}

std::vector<double> Subject::params(int n) const {
    Random random(seed_ + static_cast<uint64_t>(n));
    std::vector<double> all;
    for (int i = 0; i < n; ++i) {
        for (const AxisFacts &a : axis) {
            all.push_back(support::random_param(random, a.knots, a.degree));
        }
    }
    return all;
}

std::vector<double> Subject::outside(int n) const {
    Random random(seed_ + 1000 + static_cast<uint64_t>(n));
    std::vector<double> all = params(n);
    for (size_t i = 0; i < all.size(); i += 2) {
        const AxisFacts &a = axis[i % axis.size()];
        all[i] = a.lower + random.between(-0.7, 1.7) * (a.upper - a.lower);
    }
    return all;
}

std::vector<double> Subject::grid(const int64_t *counts) const {
    Random random(seed_ + 2000);
    std::vector<double> all;
    for (int32_t k = 0; k < axes; ++k) {
        const AxisFacts &a = axis[static_cast<size_t>(k)];
        for (int64_t i = 0; i < counts[k]; ++i) {
            all.push_back(support::random_param(random, a.knots, a.degree));
        }
    }
    return all;
}

std::vector<double> Subject::range(double from, double to) const {
    std::vector<double> all;
    for (int32_t k = 0; k < axes; ++k) {
        all.push_back(at(k, from));
        all.push_back(at(k, to));
    }
    return all;
}

std::vector<double> Subject::near(int n) const {
    Random random(seed_ + 3000);
    std::vector<double> all;
    for (int i = 0; i < n; ++i) {
        for (const double x : center) {
            all.push_back(x + random.between(-0.8, 0.8) * size);
        }
    }
    return all;
}

std::vector<double> Subject::numbers(int64_t n) const {
    Random random(seed_ + 4000);
    std::vector<double> all(static_cast<size_t>(n));
    std::generate(all.begin(), all.end(), [&] { return random.between(-1, 1); });
    return all;
}

std::vector<double> Subject::direction(int which, int32_t components) const {
    Random random(5000 + static_cast<uint64_t>(which));
    std::vector<double> all(static_cast<size_t>(components == 0 ? dim : components));
    std::generate(all.begin(), all.end(), [&] { return random.between(-1, 1); });
    return all;
}

} // namespace recorded
