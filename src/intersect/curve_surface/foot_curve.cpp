// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/foot_curve.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/products.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr int most_degree = 5;
constexpr double far_out = 1.25; // how far beyond a piece foot points are looked for

BernsteinShape shape_of(int degree, int width) noexcept {
    return {{0, 0, degree}, width};
}

// Interpolation nodes with little oscillation (Chebyshev-Lobatto), the ends first.
double node(int degree, int i) noexcept {
    static constexpr double nodes[most_degree][most_degree + 1] = {
        {0, 1},
        {0, 1, 0.5},
        {0, 1, 0.25, 0.75},
        {0, 1, 0.14644660940672624, 0.5, 0.85355339059327376},
        {0, 1, 0.09549150281252629, 0.34549150281252629, 0.65450849718747371, 0.90450849718747371}};
    return nodes[degree - 1][i];
}

// Newton's divided differences, then Horner's rule for that polynomial in the Bernstein basis.
std::vector<double> interpolated(int degree, std::vector<double> values) {
    for (int level = 1; level <= degree; ++level) {
        for (int i = degree; i >= level; --i) {
            const auto at = static_cast<size_t>(i);
            values[at] = (values[at] - values[at - 1]) / (node(degree, i) - node(degree, i - level));
        }
    }
    std::vector<double> result{values.back()};
    for (int k = degree; k-- > 0;) {
        const double x = node(degree, k);
        const auto n = static_cast<double>(result.size());
        std::vector<double> next(result.size() + 1, values[static_cast<size_t>(k)]);
        for (size_t i = 0; i < result.size(); ++i) {
            const auto at = static_cast<double>(i);
            next[i] -= (n - at) / n * x * result[i];
            next[i + 1] += (at + 1) / n * (1 - x) * result[i];
        }
        result = std::move(next);
    }
    return result;
}

// out = a b, where coefficients include the binomials; a has `width` components.
void multiply(const std::vector<double> &a, int width, const std::vector<double> &b,
              std::vector<double> &out) {
    const BernsteinShape left = shape_of(static_cast<int>(a.size()) / width - 1, width),
                         right = shape_of(static_cast<int>(b.size()) - 1, 1);
    out.assign(static_cast<size_t>(product_shape(left, right).values()), 0.0);
    add_convolution(left, a.data(), right, b.data(), out.data());
}

double largest_sum(const std::vector<double> &places) noexcept {
    double most = 1;
    for (const double x : places) {
        most = std::max(most, std::abs(x) + std::abs(1 - x));
    }
    return most;
}

double weight_ratio(const pieces::BezierPiece &piece) noexcept {
    double least = infinity, most = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        least = std::min(least, piece.weight(i));
        most = std::max(most, piece.weight(i));
    }
    return most / least;
}

// The largest distance of a control point from the centre.
double farthest(const pieces::BezierPiece &piece, const std::array<double, 3> &centre) noexcept {
    double most = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        most = std::max(most, distance(piece.point(i), centre.data(), 3));
    }
    return most;
}

} // namespace

// Newton's method for the two components of point - S along the mean derivatives of S.
bool FootCurve::find_foot(const SlopedPatch &patch, const double *point, Place<2> &foot) {
    constexpr int most_steps = 12;
    const double *u = patch.mean(0), *v = patch.mean(1);
    const double length = norm(u, 3) + norm(v, 3);
    for (int i = 0; i < most_steps; ++i) {
        patch_point_.evaluate(*patch.piece, foot);
        std::transform(point, point + 3, patch_point_.value(), offset_.begin(), std::minus<>());
        const double *by_u = patch_point_.derivative(0), *by_v = patch_point_.derivative(1);
        const double a = dot(u, by_u, 3), b = dot(u, by_v, 3), c = dot(v, by_u, 3), d = dot(v, by_v, 3);
        const double e = dot(u, offset_.data(), 3), f = dot(v, offset_.data(), 3),
                     determinant = a * d - b * c;
        const Place<2> step{(e * d - b * f) / determinant, (a * f - e * c) / determinant};
        foot = {foot[0] + step[0], foot[1] + step[1]};
        if (!(largest(Place<2>{foot[0] - 0.5, foot[1] - 0.5}) <= 4)) {
            return false;
        }
        const double size = largest(step);
        if (size <= 1e-9 ||
            size * length <= 16 * eps) { // the next step would be about its square, or lost in rounding
            return largest(Place<2>{foot[0] - 0.5, foot[1] - 0.5}) <= 0.5 + far_out;
        }
    }
    return false;
}

// The signed length of the last offset, which is across the mean tangent plane up to rounding.
double FootCurve::height_of(const SlopedPatch &patch) const noexcept {
    const double *u = patch.mean(0), *v = patch.mean(1);
    const Vector3 offset{offset_[0], offset_[1], offset_[2]};
    return std::copysign(length(offset), dot(cross({u[0], u[1], u[2]}, {v[0], v[1], v[2]}), offset));
}

bool FootCurve::interpolate(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near,
                            double far) {
    const int degrees = patch.piece->degree(0) + patch.piece->degree(1);
    degree_ = std::min(most_degree, (max_product_degree - arc.piece->degree(0)) / std::max(degrees, 1));
    if (degree_ < 1) {
        return false;
    }
    std::array<std::vector<double>, 2> values;
    Place<2> foot{0.5, 0.5};
    Interval heights{infinity, -infinity};
    for (int i = 0; i <= degree_; ++i) {
        arc_point_.evaluate(*arc.piece, node(degree_, i));
        count_work(60 * patch.piece->coefficients());
        if (!find_foot(patch, arc_point_.value(), foot)) {
            return false;
        }
        const double height = height_of(patch);
        heights = {std::min(heights.lower, height), std::max(heights.upper, height)};
        const bool some_far = heights.lower < -far || heights.upper > far;
        if (some_far && heights.lower <= near && heights.upper >= -near) {
            return false;
        }
        for (size_t k = 0; k < 2; ++k) {
            values[k].push_back(foot[k]);
        }
    }
    for (size_t k = 0; k < 2; ++k) {
        places_[k] = interpolated(degree_, std::move(values[k]));
    }
    arc_point_.evaluate(*arc.piece, 0.5);
    std::copy_n(arc_point_.value(), 3, centre_.begin());
    return true;
}

Interval FootCurve::hull(int axis) const noexcept {
    const auto [low, high] = std::ranges::minmax_element(coefficients(axis));
    return {*low, *high};
}

Place<2> FootCurve::at(double t) const {
    Place<2> place{};
    for (size_t k = 0; k < 2; ++k) {
        std::vector<double> values = places_[k];
        nrb::evaluate(degree_, 1, t, values.data());
        place[k] = values.front();
    }
    return place;
}

// The Bernstein functions (n choose i) (1 - p)^(n - i) p^i, with coefficients times binomials.
void FootCurve::set_powers(size_t axis, int degree) {
    std::vector<double> high = places_[axis], low = high;
    const double *factors = binomials(degree_);
    for (size_t i = 0; i < high.size(); ++i) {
        low[i] = factors[i] * (1 - high[i]);
        high[i] *= factors[i];
    }
    std::vector<std::vector<double>> &powers = powers_[axis];
    powers.assign(static_cast<size_t>(degree) + 1, {1.0});
    std::vector<double> power{1}, next;
    for (int i = 1; i <= degree; ++i) {
        multiply(power, 1, high, next);
        power = next;
        powers[static_cast<size_t>(i)] = power;
    }
    power = {1};
    for (int i = degree; i-- > 0;) {
        multiply(power, 1, low, next);
        power = next;
        multiply(powers[static_cast<size_t>(i)], 1, power, next);
        powers[static_cast<size_t>(i)] = next;
    }
    for (int i = 0; i <= degree; ++i) {
        const double factor = binomial(degree, i);
        std::ranges::for_each(powers[static_cast<size_t>(i)], [factor](double &x) { x *= factor; });
    }
}

// (S(p) w, w) about the centre, with coefficients times binomials.
void FootCurve::compose(const pieces::BezierPiece &patch) {
    const int p = patch.degree(0), q = patch.degree(1);
    set_powers(0, p);
    set_powers(1, q);
    const BernsteinShape row_shape = shape_of(q * degree_, 4), whole = shape_of((p + q) * degree_, 4);
    image_.assign(static_cast<size_t>(whole.values()), 0.0);
    std::vector<double> row;
    for (int i = 0; i <= p; ++i) {
        row.assign(static_cast<size_t>(row_shape.values()), 0.0);
        for (int j = 0; j <= q; ++j) {
            const int64_t at = int64_t{i} * (q + 1) + j;
            const double *x = patch.point(at), w = patch.weight(at);
            const double record[] = {w * (x[0] - centre_[0]), w * (x[1] - centre_[1]),
                                     w * (x[2] - centre_[2]), w};
            const std::vector<double> &power = powers_[1][static_cast<size_t>(j)];
            add_convolution(shape_of(0, 4), record, shape_of(q * degree_, 1), power.data(), row.data());
        }
        const std::vector<double> &power = powers_[0][static_cast<size_t>(i)];
        add_convolution(row_shape, row.data(), shape_of(p * degree_, 1), power.data(), image_.data());
    }
}

// Returns whether the weights are positive.
bool FootCurve::set_differences(const pieces::BezierPiece &arc) {
    std::vector<double> points, weights, image_weights, of_arc, of_image;
    for (int i = 0; i <= arc.degree(0); ++i) {
        const double w = binomial(arc.degree(0), i) * arc.weight(i);
        weights.push_back(w);
        for (size_t k = 0; k < 3; ++k) {
            points.push_back(w * (arc.point(i)[k] - centre_[k]));
        }
    }
    for (size_t i = 3; i < image_.size(); i += 4) {
        image_weights.push_back(image_[i]);
    }
    multiply(points, 3, image_weights, of_arc);
    multiply(image_, 4, weights, of_image);
    differences_.resize(of_arc.size());
    bool positive = true;
    for (size_t i = 0; i < of_arc.size() / 3; ++i) {
        const double w = of_image[4 * i + 3];
        positive = positive && w > 0;
        for (size_t k = 0; k < 3; ++k) {
            differences_[3 * i + k] = (of_arc[3 * i + k] - of_image[4 * i + k]) / w;
        }
    }
    return positive;
}

// Each coefficient is a sum of products with a factor for each power, and the factors are sums of some terms.
// The magnitudes of the products add up to at most `spread` times what they would be with no place outside of
// [0, 1].
double FootCurve::compare(const pieces::SlopedPiece &arc, const SlopedPatch &patch) {
    const pieces::BezierPiece &c = *arc.piece, &s = *patch.piece;
    compose(s);
    const bool positive = set_differences(c);
    double spread =
        std::pow(largest_sum(places_[0]), s.degree(0)) * std::pow(largest_sum(places_[1]), s.degree(1));
    if (spread > 1) {
        spread *= spread * weight_ratio(s); // of the weights too
    }
    const int degrees = s.degree(0) + s.degree(1);
    const double steps = degrees * (degree_ + 4) + degrees * degree_ + c.degree(0) + 16,
                 local = std::max(farthest(c, centre_), farthest(s, centre_));
    const double rounding =
        eps * (2 * (c.reach() + s.reach()) + steps * spread * local) + c.moved() + spread * s.moved();
    return positive && spread < 1e9 ? rounding : infinity;
}

} // namespace nrb::intersect
