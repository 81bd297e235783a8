// SPDX-License-Identifier: MIT
#include "refine/algebra/knot_derivative.h"

#include "base/limits.h"
#include "base/representable.h"
#include "refine/algebra/polynomial.h"
#include "refine/algebra/product.h"
#include "refine/knots/axis_table.h"
#include "refine/periodic/period.h"
#include "spline/at_origin.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <functional>

namespace nrb::refine {

namespace {

SplinePtr zeros(const Spline &spline) {
    return polynomial_result(spline.knot_vectors(), spline.dim(),
                             std::vector<double>(spline.points().size()));
}

// The knot vector with t_k doubled, and the layers over it that are kept.
struct DoubledKnots {
    std::vector<double> knots;
    std::vector<int64_t> layers;
};

DoubledKnots doubled(const KnotVector &axis, int64_t k) {
    const int64_t p = axis.degree(), count = axis.count();
    std::vector<double> knots(axis.knots().begin(), axis.knots().end());
    knots.insert(knots.begin() + k, knots[static_cast<size_t>(k)]);
    int64_t left_out = k <= p ? 0 : k >= count ? count : -1;
    for (int64_t i = std::max(k - p - 1, int64_t{0}); i <= std::min(k, count); ++i) {
        const bool empty = knots[static_cast<size_t>(i)] == knots[static_cast<size_t>(i + p + 1)];
        left_out = empty ? i : left_out;
    }
    if (left_out >= 0) {
        knots.erase(left_out == count ? knots.end() - 1 : knots.begin() + left_out);
    }
    std::vector<int64_t> layers;
    for (int64_t i = 0; i <= count; ++i) {
        if (i != left_out) {
            layers.push_back(i);
        }
    }
    return {std::move(knots), std::move(layers)};
}

// Appends (layer `layer` - 1 minus layer `layer`) / length of one outer index, or zeros if length is 0.
void append_difference(const double *own, int64_t layer, int64_t inner, double length,
                       std::vector<double> &out) {
    for (int64_t i = 0; i < inner; ++i) {
        const double *value = own + layer * inner + i;
        out.push_back(length > 0 ? (value[-inner] - value[0]) / length : 0);
    }
}

// The derivative with respect to one knot of an axis that is not periodic.
SplinePtr open_derivative(const Spline &spline, int axis, int64_t k) {
    const KnotVector &old = spline.axis(axis);
    DoubledKnots made = doubled(old, k);
    const AxisView view = axis_view(spline, axis, spline.dim());
    std::vector<double> points;
    points.reserve(static_cast<size_t>(view.outer * view.inner) * made.layers.size());
    for (int64_t o = 0; o < view.outer; ++o) {
        const double *own = spline.points().data() + o * view.count * view.inner;
        for (const int64_t i : made.layers) {
            const bool changes =
                i >= std::max(k - old.degree(), int64_t{1}) && i <= std::min(k, old.count() - 1);
            append_difference(own, changes ? i : 0, view.inner, changes ? old[i + old.degree()] - old[i] : 0,
                              points);
        }
    }
    require_representable(points, "control points of the derivative");
    auto knots = std::make_shared<const KnotVector>(old.degree(), std::move(made.knots));
    return polynomial_result(with_axis(spline, axis, std::move(knots)), spline.dim(), std::move(points));
}

// The spline whose layer i is layer from[i] of another, over the given knots.
SplinePtr chosen_layers(const Spline &spline, int axis, KnotVectorPtr knots,
                        const std::vector<int64_t> &from) {
    const AxisView view = axis_view(spline, axis, spline.dim());
    std::vector<double> points;
    points.reserve(static_cast<size_t>(view.outer * view.inner) * from.size());
    for (int64_t o = 0; o < view.outer; ++o) {
        for (const int64_t layer : from) {
            const double *own = spline.points().data() + (o * view.count + layer) * view.inner;
            points.insert(points.end(), own, own + view.inner);
        }
    }
    return polynomial_result(with_axis(spline, axis, std::move(knots)), spline.dim(), std::move(points));
}

// A periodic axis unrolled: extended beyond both ends by enough knots that the outermost ones, for which the
// formula does not hold, have no influence on the domain.
class Unrolled {
public:
    Unrolled(const Spline &spline, int axis, int64_t k)
        : axis_(axis), old_(spline.axis(axis)), lead_(2 * int64_t{old_.degree()} + 2),
          period_(old_.distinct_layers()) {
        auto knots = std::make_shared<const KnotVector>(old_.degree(), extended_knots(old_, lead_));
        std::vector<int64_t> layers;
        for (int64_t i = 0; i < knots->count(); ++i) {
            layers.push_back(((i - lead_) % period_ + period_) % period_);
        }
        open_ = chosen_layers(spline, axis, std::move(knots), layers);
        const int64_t outer = int64_t{old_.degree()} + 1;
        const int64_t first = outer + ((k + lead_ - outer) % period_);
        for (int64_t copy = first; copy < open_->axis(axis).count(); copy += period_) {
            copies_.push_back(copy);
        }
    }

    // The sum of the derivatives with respect to all copies of the knot, over the knots in which each copy is
    // doubled.
    [[nodiscard]] SplinePtr derivative() const {
        const std::vector<double> fine = finer_knots();
        std::vector<double> points;
        for (const int64_t copy : copies_) {
            const SplinePtr one = open_derivative(*open_, axis_, copy);
            const LayerTable table = rows_over(one->axis(axis_), fine);
            const Net net = apply_along(*one, axis_, table);
            points.resize(net.points.size());
            std::transform(points.begin(), points.end(), net.points.begin(), points.begin(), std::plus<>());
        }
        return rolled(fine, std::move(points));
    }

private:
    // The knots with every copy doubled, except that a knot of multiplicity p + 1 is left as it is.
    [[nodiscard]] std::vector<double> finer_knots() const {
        const std::span<const double> knots = open_->axis(axis_).knots();
        std::vector<double> more;
        for (const int64_t copy : copies_) {
            const double knot = knots[static_cast<size_t>(copy)];
            if (multiplicity(knots, knot) <= old_.degree()) {
                more.push_back(knot);
            }
        }
        return merged(knots, more);
    }

    // One period of the unrolled result, beginning at the last copy of the start of the domain.
    [[nodiscard]] SplinePtr rolled(const std::vector<double> &fine, std::vector<double> points) const {
        const int64_t p = old_.degree();
        const auto [lower, upper] = old_.domain();
        const auto last = [&](double knot) {
            return std::upper_bound(fine.begin(), fine.end(), knot) - fine.begin() - 1;
        };
        const int64_t first = last(lower) - p, distinct = last(upper) - last(lower);
        std::vector<int64_t> layers;
        for (int64_t i = 0; i < distinct + p; ++i) {
            layers.push_back(first + i % distinct);
        }
        const SplinePtr open = polynomial_result(
            with_axis(*open_, axis_, std::make_shared<const KnotVector>(old_.degree(), fine)), open_->dim(),
            std::move(points));
        std::vector<double> knots(fine.begin() + first, fine.begin() + first + distinct + 2 * p + 1);
        return chosen_layers(*open, axis_, make_knot_vector(old_.degree(), std::move(knots), true), layers);
    }

    int axis_;
    const KnotVector &old_;
    int64_t lead_;
    int64_t period_;
    SplinePtr open_;
    std::vector<int64_t> copies_;
};

void check_degrees(const Spline &spline) {
    for (int k = 0; k < spline.axes(); ++k) {
        if (2 * spline.axis(k).degree() > max_degree) {
            fail(Status::degree,
                 "the derivative has degree 2 * %d = %d on axis %d, which exceeds the limit of %d",
                 spline.axis(k).degree(), 2 * spline.axis(k).degree(), k, max_degree);
        }
    }
}

// The records B(a, b) of two splines over the axes `joint`.
std::vector<double> product_of(const Spline &a, const Spline &b, const std::vector<CommonKnots> &joint,
                               int width, const Bilinear &form) {
    return product_records({a.knot_vectors(), a.points(), a.dim()}, {b.knot_vectors(), b.points(), b.dim()},
                           joint, width, form);
}

} // namespace

SplinePtr polynomial_knot_derivative(const SplinePtr &spline, int axis, int64_t k) {
    if (spline->axis(axis).degree() == 0) {
        return zeros(*spline);
    }
    return spline->axis(axis).periodic() ? Unrolled(*spline, axis, k).derivative()
                                         : open_derivative(*spline, axis, k);
}

// Both factors are first written over the common knots of the derivative and the spline, so that all products
// have the same knots. The spline is moved to the origin first: otherwise the parts of A_k w and A w_k that
// are proportional to the distance from the origin would cancel.
SplinePtr rational_knot_derivative(const Spline &given, int axis, int64_t k) {
    const Spline &spline = at_origin(given);
    check_degrees(spline);
    const int dim = spline.dim();
    const SplinePtr records =
        polynomial_result(spline.knot_vectors(), dim + 1, {spline.records().begin(), spline.records().end()});
    const SplinePtr moved = polynomial_knot_derivative(records, axis, k);
    const CommonKnots both(spline.axis(axis).degree(), {&moved->axis(axis), &spline.axis(axis)}, 0);
    const SplinePtr a = with_axis(*moved, axis, AxisTable{both.axis(), both.raising(0)});
    const SplinePtr b = with_axis(*records, axis, AxisTable{both.axis(), both.raising(1)});
    const std::vector<CommonKnots> joint = product_axes(a->knot_vectors(), b->knot_vectors());
    Bilinear quotient;
    for (int c = 0; c < dim; ++c) {
        quotient.push_back({c, c, dim});
        quotient.push_back({c, dim, c, -1});
    }
    std::vector<double> numerator = product_of(*a, *b, joint, dim + 1, quotient);
    const std::vector<double> denominator = product_of(*b, *b, joint, 1, {{0, dim, dim}});
    for (size_t i = 0; i < denominator.size(); ++i) {
        numerator[i * static_cast<size_t>(dim + 1) + static_cast<size_t>(dim)] = denominator[i];
    }
    return from_records(axes_of(joint), dim, spline.form(), std::move(numerator));
}

} // namespace nrb::refine
