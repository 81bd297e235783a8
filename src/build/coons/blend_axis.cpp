// SPDX-License-Identifier: MIT
#include "build/coons/blend_axis.h"

#include "base/representable.h"
#include "reduce/compatible.h"
#include "refine/algebra/polynomial.h"
#include "refine/forms/weights.h"

#include <algorithm>
#include <array>

namespace nrb::build {

Quotient as_quotient(const SplinePtr &curve) {
    if (curve->form() == Form::polynomial) {
        return {curve, nullptr};
    }
    const bool equal = refine::equal_weights(*curve), records = curve->form() == Form::homogeneous;
    const double first = curve->weight(0);
    std::vector<double> points, weights;
    for (int64_t i = 0; i < curve->point_count(); ++i) {
        const double weight = curve->weight(i) / first;
        const double *stored = curve->points().data() + i * curve->stored_width();
        for (int c = 0; c < curve->dim(); ++c) {
            points.push_back(records ? stored[c] / first : equal ? stored[c] : weight * stored[c]);
        }
        weights.push_back(weight);
    }
    require_representable(points, "numerators");
    require_representable(weights, "denominators");
    return {refine::polynomial_spline(curve->knot_vectors(), curve->dim(), std::move(points)),
            equal ? nullptr : refine::polynomial_spline(curve->knot_vectors(), 1, std::move(weights))};
}

namespace {

// The distinct denominators of some functions, and which of them each function has.
class Denominators {
public:
    explicit Denominators(std::span<const Quotient> functions) {
        for (const Quotient &function : functions) {
            owner_.push_back(function.denominator == nullptr ? none : place(function.denominator));
        }
    }
    // The product of all denominators, or of all except that of a function; null: 1.
    [[nodiscard]] SplinePtr product_of_all() const { return product_without(none); }
    [[nodiscard]] SplinePtr product_of_others(size_t function) const {
        return product_without(owner_[function]);
    }

private:
    static constexpr size_t none = static_cast<size_t>(-1);

    size_t place(const SplinePtr &denominator) {
        const auto found = std::ranges::find_if(
            distinct_, [&](const SplinePtr &d) { return same_function(d, denominator); });
        const auto at = static_cast<size_t>(found - distinct_.begin());
        if (found == distinct_.end()) {
            distinct_.push_back(denominator);
        }
        return at;
    }
    [[nodiscard]] SplinePtr product_without(size_t left_out) const {
        SplinePtr result;
        for (size_t i = 0; i < distinct_.size(); ++i) {
            result = i == left_out ? result : refine::times(distinct_[i], result);
        }
        return result;
    }

    std::vector<SplinePtr> distinct_;
    std::vector<size_t> owner_;
};

// The blending functions as one Bezier curve.
SplinePtr blending_functions(Interval domain, int degree) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, domain.lower);
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, domain.upper);
    const double third = (domain.upper - domain.lower) / 3;
    const std::vector<double> linear = {1, 0, 0, 1};
    const std::vector<double> cubic = {1, 0, 0, 0, 1, 0, third, 0, 0, 1, 0, -third, 0, 1, 0, 0};
    return refine::polynomial_spline({std::make_shared<const KnotVector>(degree, std::move(knots))},
                                     degree + 1, degree == 1 ? linear : cubic);
}

// By how much control point 1 differs from control point 0 for a unit of derivative at the start; then the
// same for the other end.
double first_step(const KnotVector &axis) noexcept {
    const int r = axis.degree();
    return (axis[r + 1] - axis[1]) / r;
}

double last_step(const KnotVector &axis) noexcept {
    const int r = axis.degree();
    const int64_t n = axis.count();
    return (axis[n + r - 1] - axis[n - 1]) / r;
}

// Sets the control points of the blending functions in the margins, which give the values at the ends and,
// for Hermite functions, the derivatives. They depend on the weights of D.
void set_ends(BlendAxis &made) {
    const auto n = static_cast<size_t>(made.count());
    std::vector<std::vector<double>> &f = made.blends;
    for (size_t i = 0; i < made.margin(); ++i) {
        const size_t end = n - 1 - i;
        for (std::vector<double> &blend : f) {
            blend[i] = blend[end] = 0;
        }
        f[0][i] = made.weight(i) / made.divisor(i);
        f[1][end] = made.weight(end) / made.divisor(end);
    }
    if (made.margin() == 2) {
        f[2][1] = first_step(*made.axis) * (made.weight(0) / made.divisor(1));
        f[3][n - 2] = -last_step(*made.axis) * (made.weight(n - 1) / made.divisor(n - 2));
    }
}

std::vector<double> divided(const BlendAxis &made, std::span<const double> numerators) {
    std::vector<double> points(numerators.begin(), numerators.end());
    const size_t width = points.size() / static_cast<size_t>(made.count());
    for (size_t i = 0; i < points.size() && !made.weights.empty(); ++i) {
        points[i] /= made.divisor(i / width);
    }
    require_representable(points, "control points");
    return points;
}

// The components of the curve of blending functions, each by itself.
std::vector<std::vector<double>> parted(const std::vector<double> &points, size_t size) {
    std::vector<std::vector<double>> parts(size);
    for (size_t i = 0; i < points.size(); ++i) {
        parts[i % size].push_back(points[i]);
    }
    return parts;
}

bool have_one_axis(const std::vector<SplinePtr> &functions) {
    const KnotVector &first = functions[0]->axis(0);
    return std::ranges::all_of(functions, [&](const SplinePtr &function) {
        const KnotVector &axis = function->axis(0);
        return &axis == &first ||
               (axis.degree() == first.degree() && std::ranges::equal(axis.knots(), first.knots()));
    });
}

std::vector<SplinePtr> over_common_axis(std::vector<SplinePtr> functions) {
    return have_one_axis(functions) ? std::move(functions)
                                    : reduce::make_compatible(functions, 0, false).splines;
}

// 1 - t and t: their control points are their values at the Greville abscissae. Precondition: the degree is
// not 0.
std::vector<std::vector<double>> linear_blends(const KnotVector &axis) {
    const auto [lower, upper] = axis.domain();
    const int64_t count = axis.count();
    std::vector<std::vector<double>> blends(2, std::vector<double>(static_cast<size_t>(count)));
    for (int64_t i = 0; i < count; ++i) {
        const double t = greville(axis, i);
        blends[0][static_cast<size_t>(i)] = (upper - t) / (upper - lower);
        blends[1][static_cast<size_t>(i)] = (t - lower) / (upper - lower);
    }
    return blends;
}

std::vector<std::vector<double>> control_points(const BlendAxis &made, std::span<const SplinePtr> functions) {
    std::vector<std::vector<double>> points;
    points.reserve(functions.size());
    for (const SplinePtr &function : functions) {
        points.push_back(divided(made, function->points()));
    }
    return points;
}

// Polynomial functions and the linear blending functions over their knots.
BlendAxis linear_blend(std::vector<SplinePtr> functions) {
    const std::vector<SplinePtr> all = over_common_axis(std::move(functions));
    BlendAxis made{all[0]->knot_vectors()[0], {}, {}, {}};
    made.functions = control_points(made, all);
    made.blends = linear_blends(*made.axis);
    return made;
}

// Any functions, over the common denominator, which also multiplies the blending functions.
BlendAxis general_blend(std::vector<SplinePtr> functions, const SplinePtr &common, int degree) {
    const size_t count = functions.size();
    functions.push_back(refine::times(blending_functions(functions[0]->axis(0).domain(), degree), common));
    if (common != nullptr) {
        functions.push_back(common);
    }
    const std::vector<SplinePtr> all = over_common_axis(std::move(functions));
    BlendAxis made{all[0]->knot_vectors()[0], {}, {}, {}};
    if (common != nullptr) {
        made.weights.assign(all.back()->points().begin(), all.back()->points().end());
    }
    made.functions = control_points(made, std::span(all).first(count));
    made.blends = parted(divided(made, all[count]->points()), static_cast<size_t>(degree) + 1);
    return made;
}

} // namespace

bool same_function(const SplinePtr &a, const SplinePtr &b) {
    const std::array<SplinePtr, 2> both = {a, b};
    const reduce::Compatible made = reduce::make_compatible(both, 0, false);
    return std::ranges::equal(made.splines[0]->points(), made.splines[1]->points());
}

BlendAxis make_blend_axis(std::span<const Quotient> functions, int degree) {
    const Denominators denominators(functions);
    const SplinePtr common = denominators.product_of_all();
    std::vector<SplinePtr> numerators;
    int largest = 0;
    for (size_t i = 0; i < functions.size(); ++i) {
        numerators.push_back(refine::times(functions[i].numerators, denominators.product_of_others(i)));
        largest = std::max(largest, numerators.back()->axis(0).degree());
    }
    BlendAxis made = common == nullptr && degree == 1 && largest > 0
                         ? linear_blend(std::move(numerators))
                         : general_blend(std::move(numerators), common, degree);
    set_ends(made);
    return made;
}

} // namespace nrb::build
