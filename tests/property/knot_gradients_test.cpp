// Derivatives with respect to knots: exact values, one knot and all copies of a period, and the laws of moving
// and stretching all knots.
#include "dual.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cfloat>
#include <cmath>
#include <gtest/gtest.h>

namespace knot_gradients_test {

using namespace support;
using dual_numbers::Dual;
using reference::eps;
using reference::Rational;

namespace {

Handle knot_derivative(const nurbs *g, int axis, size_t knot) {
    return made(
        [&](nurbs **out) { return nurbs_eval_knot_derivative(g, axis, static_cast<int64_t>(knot), out); });
}

std::vector<double> adjoint_knots(const SplineData &data, int axis, int order,
                                  const std::vector<double> &params, const std::vector<double> &cotangents) {
    std::vector<double> out(data.knots[static_cast<size_t>(axis)].size());
    const auto g = create(data);
    const auto n = static_cast<int64_t>(params.size() / data.degrees.size());
    require_ok(nurbs_eval_adjoint_knots(g.get(), axis, order, n, params.data(), 0, 0, cotangents.data(), 0, 0,
                                        out.data(), 0));
    return out;
}

struct Case {
    SplineData data;
    int axis;
    std::vector<double> params;

    [[nodiscard]] size_t at() const { return static_cast<size_t>(axis); }
    [[nodiscard]] size_t degree() const { return static_cast<size_t>(data.degrees[at()]); }
    [[nodiscard]] size_t knots() const { return data.knots[at()].size(); }
    [[nodiscard]] size_t dim() const { return static_cast<size_t>(data.dim); }
    [[nodiscard]] const double *param(size_t k) const { return params.data() + k * data.degrees.size(); }
};

Case random_case(Random &random, int axes, int max_degree, int n) {
    Case it;
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = std::min(axis.spans, axes == 3 ? 2 : 4);
    }
    it.data = random_spline(random, recipe);
    it.axis = random.whole(0, axes - 1);
    it.params = away_from_underflow(random_params(random, it.data, n));
    return it;
}

// What a derivative by a knot is made from: the largest distance of a control point from O over the shortest
// t_(i+p) - t_i, times the square of the largest weight over w(t). About the parameter, but for control points
// of products, that are made from neighbours, too: then over the whole spline.
long double unit(const Case &it, size_t k) {
    const SplineData &data = it.data;
    const std::vector<double> origin = reference::origin_of(data);
    long double distance = 0, most = 0, shortest = HUGE_VALL;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (int c = 0; c < data.dim; ++c) {
            distance = std::max(distance, std::fabs(static_cast<long double>(data.coordinate(i, c)) -
                                                    origin[static_cast<size_t>(c)]));
        }
        most = std::max(most, static_cast<long double>(data.weight(i)));
    }
    const std::vector<double> &knots = data.knots[it.at()];
    for (size_t i = 0; i + it.degree() < knots.size(); ++i) {
        const long double length = static_cast<long double>(knots[i + it.degree()]) - knots[i];
        shortest = length > 0 ? std::min(shortest, length) : shortest;
    }
    SplineData weights = data;
    weights.dim = 1;
    weights.points.assign(static_cast<size_t>(data.point_count()), 0);
    for (int64_t i = 0; i < data.point_count(); ++i) {
        weights.points[static_cast<size_t>(i)] = data.weight(i);
    }
    weights.weights.clear();
    const reference::Fraction w = reference::exact_point(weights, it.param(k))[0];
    const long double ratio = data.rational() ? most / reference::quotient(w.numerator, w.denominator) : 1;
    return distance / shortest * ratio * ratio;
}

Rational slope(const Case &it, size_t k, size_t c, const std::function<bool(size_t)> &moves) {
    return dual_numbers::point(it.data, it.param(k),
                               [&](int axis, size_t knot) { return axis == it.axis && moves(knot); })[c]
        .slope;
}

// Whether knots i and j of the axis move together.
bool together(const Case &it, size_t i, size_t j) {
    const size_t period = it.knots() - 2 * it.degree() - 1;
    return it.data.periodic(it.axis) ? i % period == j % period : i == j;
}

// Copies of knots are rounded, which is a move of theirs relative to the shortest length.
long double rounding_of_copies(const Case &it) {
    const std::vector<double> &knots = it.data.knots[it.at()];
    long double shortest = HUGE_VALL;
    for (size_t i = 0; i + 1 < knots.size(); ++i) {
        const long double length = static_cast<long double>(knots[i + 1]) - knots[i];
        shortest = length > 0 ? std::min(shortest, length) : shortest;
    }
    const double largest = std::max(std::fabs(knots.front()), std::fabs(knots.back()));
    return it.data.periodic(it.axis) ? largest / shortest : 0;
}

TEST(KnotGradients, derivative_is_exact) {
    WorstErrors worst("derivatives by a knot, error over bound");
    for_each_case(101000000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(10) ? 3 : random.whole(1, 2);
        const Case it = random_case(random, axes, axes == 1 ? 5 : axes == 2 ? 3 : 2, 3);
        const auto knot = static_cast<size_t>(random.whole(0, static_cast<int>(it.knots()) - 1));
        const auto h = knot_derivative(create(it.data).get(), it.axis, knot);
        const std::vector<double> got = eval(h.get(), it.params);
        const long double factor = 8 * (reference::c_of(it.data) + 16) + rounding_of_copies(it);
        for (size_t k = 0; k < 3; ++k) {
            for (size_t c = 0; c < it.dim(); ++c) {
                const Rational expected = slope(it, k, c, [&](size_t j) { return together(it, j, knot); });
                const long double ratio =
                    reference::error_ratio(got[k * it.dim() + c], reference::fraction(expected),
                                           eps * factor * unit(it, k) + DBL_MIN);
                worst.add(it.data.degrees[it.at()], ratio, ratio);
                ASSERT_LE(ratio, 1) << where(seed, it.data) << "axis " << it.axis << " knot " << knot
                                    << " parameter " << it.param(k)[it.at()];
            }
        }
    });
}

TEST(KnotGradients, periodic_axes_stay_periodic) {
    for_each_case(102000000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 4);
        recipe.axes[0].form = KnotForm::periodic;
        const Case it{random_spline(random, recipe), 0, {}};
        const auto knot = static_cast<size_t>(random.whole(0, static_cast<int>(it.knots()) - 1));
        const SplineData made = read_back(knot_derivative(create(it.data).get(), 0, knot).get());
        ASSERT_TRUE(made.periodic(0)) << where(seed, it.data);
        ASSERT_EQ(made.lower(0), it.data.lower(0));
        ASSERT_EQ(made.upper(0), it.data.upper(0));
    });
}

TEST(KnotGradients, adjoint_is_exact) {
    WorstErrors worst("gradients of knots, error over bound");
    for_each_case(103000000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(10) ? 3 : random.whole(1, 2);
        const Case it = random_case(random, axes, axes == 1 ? 5 : axes == 2 ? 3 : 2, 2);
        std::vector<double> g(2 * it.dim());
        std::generate(g.begin(), g.end(), [&] { return random.between(-1, 1); });
        const std::vector<double> got = adjoint_knots(it.data, it.axis, 0, it.params, g);
        for (size_t j = 0; j < it.knots(); ++j) {
            Rational expected = 0;
            long double bound = DBL_MIN;
            for (size_t k = 0; k < 2; ++k) {
                long double size = 0;
                for (size_t c = 0; c < it.dim(); ++c) {
                    const double own = g[k * it.dim() + c];
                    expected += reference::exact(own) * slope(it, k, c, [&](size_t i) { return i == j; });
                    size += std::fabs(own);
                }
                bound += eps * static_cast<long double>(16 * it.degree() + 8) * size * unit(it, k);
            }
            const long double ratio = reference::error_ratio(got[j], reference::fraction(expected), bound);
            worst.add(it.data.degrees[it.at()], ratio, ratio);
            ASSERT_LE(ratio, 1) << where(seed, it.data) << "axis " << it.axis << " knot " << j;
        }
    });
}

// Splines of which derivatives are of moderate size.
SplineData tame_spline(Random &random, int axes) {
    Recipe recipe;
    for (int k = 0; k < axes; ++k) {
        AxisRecipe axis{random.whole(2, 4)};
        axis.form = random.chance(50) ? KnotForm::clamped : KnotForm::unclamped;
        axis.spacing = Spacing::integers;
        recipe.axes.push_back(axis);
    }
    recipe.weights = random.chance(50) ? Weights::moderate : Weights::none;
    recipe.dim = random.whole(1, 3);
    return random_spline(random, recipe);
}

// <G, D^s of the derivative by the knot> for derivatives of any order.
TEST(KnotGradients, adjoint_of_derivatives_is_that_of_the_derivative) {
    for_each_case(104000000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2), order = random.whole(1, 2);
        Case it{tame_spline(random, axes), random.whole(0, axes - 1), {}};
        it.params = random_params(random, it.data, 5);
        const size_t width = graded_indices(axes, order).size() * it.dim();
        std::vector<double> g(5 * width);
        std::generate(g.begin(), g.end(), [&] { return random.between(-1, 1); });
        const std::vector<double> got = adjoint_knots(it.data, it.axis, order, it.params, g);
        for (size_t j = 0; j < it.knots(); ++j) {
            const auto h = knot_derivative(create(it.data).get(), it.axis, j);
            const std::vector<double> derivs = eval_derivs(h.get(), order, it.params);
            long double expected = 0, size = 0;
            for (size_t i = 0; i < derivs.size(); ++i) {
                expected += static_cast<long double>(g[i]) * derivs[i];
            }
            for (size_t k = 0; k < 5; ++k) {
                size += static_cast<long double>(width) * unit(it, k);
            }
            ASSERT_NEAR(got[j], static_cast<double>(expected), static_cast<double>(1e-9L * size))
                << where(seed, it.data) << "axis " << it.axis << " knot " << j << " order " << order;
        }
    });
}

// If all knots move by h, the point at t becomes the one at t - h; if they move by h times themselves, the one
// at t - h t.
TEST(KnotGradients, moving_and_stretching_all_knots_moves_the_parameter) {
    for_each_case(105000000, 300, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Case it{tame_spline(random, axes), random.whole(0, axes - 1), {}};
        it.params = random_params(random, it.data, 1);
        std::vector<double> g(it.dim());
        std::generate(g.begin(), g.end(), [&] { return random.between(-1, 1); });
        const std::vector<double> got = adjoint_knots(it.data, it.axis, 0, it.params, g);
        const std::vector<double> derivs = eval_derivs(create(it.data).get(), 1, it.params);
        long double moved = 0, stretched = 0, slope = 0, size = 0;
        for (size_t j = 0; j < it.knots(); ++j) {
            moved += got[j];
            stretched += static_cast<long double>(got[j]) * it.data.knots[it.at()][j];
            size = std::max(size, std::fabs(static_cast<long double>(it.data.knots[it.at()][j])));
        }
        for (size_t c = 0; c < it.dim(); ++c) {
            slope += static_cast<long double>(g[c]) * derivs[(1 + it.at()) * it.dim() + c];
        }
        const long double bound = 1e-12L * unit(it, 0) * (1 + size);
        ASSERT_NEAR(static_cast<double>(moved), static_cast<double>(-slope), static_cast<double>(bound))
            << where(seed, it.data);
        ASSERT_NEAR(static_cast<double>(stretched), static_cast<double>(-slope * it.param(0)[it.at()]),
                    static_cast<double>(bound))
            << where(seed, it.data);
    });
}

// Batches that are cut have the bits of whole ones.
TEST(KnotGradients, pieces_of_a_batch_accumulate_to_the_same_bits) {
    for_each_case(106000000, 100, [](Random &random, uint64_t seed) {
        const Case it = random_case(random, 1, 4, 20);
        std::vector<double> g(20 * it.dim());
        std::generate(g.begin(), g.end(), [&] { return random.between(-1, 1); });
        const std::vector<double> whole = adjoint_knots(it.data, 0, 0, it.params, g);
        std::vector<double> pieces(whole.size());
        const auto spline = create(it.data);
        for (size_t k = 0; k < 20; k += 5) {
            require_ok(nurbs_eval_adjoint_knots(spline.get(), 0, 0, 5, it.param(k), 0, 0,
                                                g.data() + k * it.dim(), 0, 0, pieces.data(),
                                                NURBS_ACCUMULATE));
        }
        ASSERT_TRUE(same_bits(pieces, whole)) << where(seed, it.data);
    });
}

} // namespace

} // namespace knot_gradients_test
