// Gradients with respect to data: exact values, the identity of a transpose, and the same bits however a
// batch is cut.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cfloat>
#include <gtest/gtest.h>
#include <numeric>

namespace adjoint_test {

using namespace support;
using reference::eps;
using reference::exact;
using reference::Rational;

namespace {

struct Gradients {
    std::vector<double> points;
    std::vector<double> weights;
    std::vector<double> params;
};

Gradients zeros(const SplineData &data, size_t params) {
    return {std::vector<double>(data.points.size()),
            std::vector<double>(static_cast<size_t>(data.point_count())), std::vector<double>(params)};
}

void add_adjoint(const nurbs *g, int order, const std::vector<double> &params, size_t axes,
                 const std::vector<double> &cotangents, Gradients &out, size_t first, uint32_t flags) {
    const auto n = static_cast<int64_t>(params.size() / axes);
    require_ok(nurbs_eval_adjoint(g, order, n, params.data(), 0, 0, cotangents.data(), 0, 0,
                                  out.points.data(), 0, 0, out.weights.data(), 0,
                                  out.params.data() + first * axes, 0, 0, flags));
}

Gradients adjoint(const SplineData &data, int order, const std::vector<double> &params,
                  const std::vector<double> &cotangents) {
    Gradients out = zeros(data, params.size());
    const auto g = create(data);
    add_adjoint(g.get(), order, params, data.degrees.size(), cotangents, out, 0, 0);
    return out;
}

struct Case {
    SplineData data;
    int order;
    std::vector<MultiIndex> slots;
    size_t n;
    std::vector<double> params;
    std::vector<double> cotangents;

    [[nodiscard]] const double *param(size_t k) const { return params.data() + k * data.degrees.size(); }
    [[nodiscard]] size_t dim() const { return static_cast<size_t>(data.dim); }
    [[nodiscard]] double cotangent(size_t k, size_t s, size_t c) const {
        return cotangents[(k * slots.size() + s) * dim() + c];
    }
    // The bound of the derivative in a slot, in eps of its magnitude.
    [[nodiscard]] long double factor(size_t s) const {
        const int total = std::accumulate(slots[s].begin(), slots[s].end(), 0);
        return 2 * (reference::c_of(data) + 2 * total);
    }
};

Case random_case(Random &random, int axes, int max_degree, int order, size_t n) {
    Case it;
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = std::min(axis.spans, axes == 3 ? 2 : 3);
    }
    it.data = random_spline(random, recipe);
    it.order = order;
    it.slots = graded_indices(axes, order);
    it.n = n;
    it.params = away_from_underflow(random_params(random, it.data, static_cast<int>(n)));
    for (size_t i = 0; i < n * it.slots.size() * it.dim(); ++i) {
        it.cotangents.push_back(random.between(-1, 1));
    }
    return it;
}

Rational rational(const reference::Fraction &x) {
    return {x.numerator, x.denominator};
}

// What contributes to a gradient: the exact value, the sum of the magnitudes of its terms, and what the
// bounds of the derivatives allow.
struct Sum {
    Rational value = 0;
    long double bound = 0;
    long double size = 0;

    void add(const Rational &term, long double magnitude, long double factor) {
        value += term;
        bound += factor * magnitude;
        size += magnitude;
    }
    // Terms are added up with as many roundings at most.
    [[nodiscard]] long double ratio(double actual, size_t terms) const {
        return reference::error_ratio(actual, reference::fraction(value),
                                      eps * (bound + static_cast<long double>(terms) * size) + DBL_MIN);
    }
};

// All that one control point does at one parameter.
struct Influence {
    std::vector<std::vector<reference::Fraction>> function; // R_i^(s), [slot][0]
    std::vector<std::vector<long double>> function_size;
    std::vector<std::vector<reference::Fraction>> point; // C^(s)
    std::vector<std::vector<long double>> point_size;
};

Influence influence(const Case &it, size_t k, size_t i) {
    SplineData one = it.data;
    one.dim = 1;
    one.points.assign(static_cast<size_t>(it.data.point_count()), 0);
    one.points[i] = 1;
    return {reference::exact_derivatives(one, it.order, it.param(k)),
            reference::magnitudes(one, it.order, it.param(k)),
            reference::exact_derivatives(it.data, it.order, it.param(k)),
            reference::magnitudes(it.data, it.order, it.param(k))};
}

// dL/dP_i = sum of R_i^(s) G.
void add_point_terms(const Case &it, const Influence &on, size_t k, size_t c, Sum &sum) {
    for (size_t s = 0; s < it.slots.size(); ++s) {
        const double g = it.cotangent(k, s, c);
        sum.add(exact(g) * rational(on.function[s][0]), std::fabs(g) * on.function_size[s][0], it.factor(s));
    }
}

// w_i dL/dw_i = sum of <G, (R_i P_i - R_i C)^(s)>, the product by Leibniz' rule.
void add_weight_terms(const Case &it, const Influence &on, size_t k, size_t i, Sum &sum) {
    const Rational w = exact(it.data.weight(static_cast<int64_t>(i)));
    for (size_t s = 0; s < it.slots.size(); ++s) {
        auto terms = leibniz_terms(it.slots[s]);
        terms.push_back({MultiIndex(it.slots[s].size(), 0), it.slots[s], 1});
        for (size_t c = 0; c < it.dim(); ++c) {
            const double g = it.cotangent(k, s, c);
            const double p = it.data.coordinate(static_cast<int64_t>(i), static_cast<int>(c));
            const auto unit = std::fabs(g) / static_cast<long double>(w);
            sum.add(exact(g) * exact(p) * rational(on.function[s][0]) / w,
                    unit * std::fabs(p) * on.function_size[s][0], 2 * it.factor(s));
            for (const LeibnizTerm &term : terms) {
                const auto b = static_cast<size_t>(slot_of(term.b));
                const auto rest = static_cast<size_t>(slot_of(term.rest));
                sum.add(-exact(g) * term.factor * rational(on.function[b][0]) * rational(on.point[rest][c]) /
                            w,
                        unit * static_cast<long double>(term.factor) * on.function_size[b][0] *
                            on.point_size[rest][c],
                        2 * it.factor(s));
            }
        }
    }
}

void check_exact(const Case &it, uint64_t seed, WorstErrors &worst) {
    const Gradients got = adjoint(it.data, it.order, it.params, it.cotangents);
    for (size_t i = 0; i < got.weights.size(); ++i) {
        std::vector<Sum> points(it.dim());
        Sum weight;
        for (size_t k = 0; k < it.n; ++k) {
            const Influence on = influence(it, k, i);
            for (size_t c = 0; c < it.dim(); ++c) {
                add_point_terms(it, on, k, c, points[c]);
            }
            if (it.data.weight(static_cast<int64_t>(i)) > 0) {
                add_weight_terms(it, on, k, i, weight);
            }
        }
        for (size_t c = 0; c < it.dim(); ++c) {
            const long double ratio = points[c].ratio(got.points[i * it.dim() + c], it.n);
            worst.add(it.order, ratio, ratio);
            ASSERT_LE(ratio, 1) << where(seed, it.data) << "point " << i << " coordinate " << c;
        }
        if (it.data.weight(static_cast<int64_t>(i)) > 0) {
            const long double ratio = weight.ratio(got.weights[i], it.n + it.dim());
            worst.add(it.order, ratio, ratio);
            ASSERT_LE(ratio, 1) << where(seed, it.data) << "weight " << i;
        }
    }
}

TEST(Adjoint, points_and_weights_have_their_exact_gradients) {
    WorstErrors worst("gradients by order of the derivatives, error over bound");
    for_each_case(96000000, 240, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(10) ? 3 : random.whole(1, 2);
        const int order = axes == 3 ? random.whole(0, 1) : random.whole(0, 2);
        check_exact(random_case(random, axes, axes == 1 ? 5 : axes == 2 ? 3 : 2, order, 2), seed, worst);
    });
}

// <G, C^(s + e_a)>, summed slot by slot, from the derivatives of one order more.
double slope_of(const Case &it, const double *derivs, size_t k, size_t a) {
    double sum = 0;
    for (size_t s = 0; s < it.slots.size(); ++s) {
        MultiIndex next = it.slots[s];
        ++next[a];
        double product = 0;
        for (size_t c = 0; c < it.dim(); ++c) {
            product += it.cotangent(k, s, c) * derivs[static_cast<size_t>(slot_of(next)) * it.dim() + c];
        }
        sum += product;
    }
    return sum;
}

// The bound of the gradient of a parameter for cotangents of points, and of the product with derivatives.
long double slope_bound(const Case &it, size_t k, size_t a) {
    const auto sizes = reference::magnitudes(it.data, 1, it.param(k));
    long double size = 0;
    for (size_t c = 0; c < it.dim(); ++c) {
        size += std::fabs(it.cotangent(k, 0, c)) * sizes[1 + a][c];
    }
    const auto sums = static_cast<long double>(it.dim());
    return eps * (2 * (reference::c_of(it.data) + 2) + sums) * size + DBL_MIN;
}

void check_slopes(const Case &it, uint64_t seed, WorstErrors &worst) {
    const Gradients got = adjoint(it.data, 0, it.params, it.cotangents);
    const size_t all = it.data.degrees.size();
    for (size_t k = 0; k < it.n; ++k) {
        const auto derivs = reference::exact_derivatives(it.data, 1, it.param(k));
        for (size_t a = 0; a < all; ++a) {
            Rational expected = 0;
            for (size_t c = 0; c < it.dim(); ++c) {
                expected += exact(it.cotangent(k, 0, c)) * rational(derivs[1 + a][c]);
            }
            const long double ratio = reference::error_ratio(
                got.params[k * all + a], reference::fraction(expected), slope_bound(it, k, a));
            worst.add(it.data.axes(), ratio, ratio);
            ASSERT_LE(ratio, 1) << where(seed, it.data) << "parameter " << k;
        }
    }
}

TEST(Adjoint, parameters_have_their_exact_gradients) {
    WorstErrors worst("gradients of parameters by axes, error over bound");
    for_each_case(97500000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(10) ? 3 : random.whole(1, 2);
        check_slopes(random_case(random, axes, axes == 1 ? 5 : 3, 0, 4), seed, worst);
    });
}

// Control points of weight 0, or nearly, may lie far away. Nothing but their own gradients knows where.
TEST(Adjoint, far_points_of_little_weight_spoil_nothing) {
    WorstErrors worst("gradients beside far points of little weight, error over bound");
    for_each_case(97600000, 200, [&](Random &random, uint64_t seed) {
        Case it = random_case(random, random.whole(1, 2), 3, 0, 3);
        it.data.flags = 0;
        it.data.weights.assign(static_cast<size_t>(it.data.point_count()), 1);
        for (int64_t i = 0; i < it.data.point_count(); ++i) {
            if (random.chance(30)) {
                const bool none = random.chance(50);
                it.data.weights[static_cast<size_t>(i)] = none ? 0 : 1e-12;
                for (size_t c = 0; c < it.dim(); ++c) {
                    it.data.points[static_cast<size_t>(i) * it.dim() + c] = 1e12 * random.between(-1, 1);
                }
            }
        }
        if (Handle g; try_create(it.data, g) == NURBS_OK) {
            check_slopes(it, seed, worst);
            check_exact(it, seed, worst);
        }
    });
}

// The gradient of a parameter is the product with the derivatives of one order more: to rounding if they are
// those of points, bit for bit if they are of derivatives.
TEST(Adjoint, parameters_have_the_gradient_of_the_derivatives) {
    for_each_case(97000000, 400, [](Random &random, uint64_t seed) {
        const Case it = random_case(random, random.whole(1, 3), 4, random.whole(0, 2), 70);
        const Gradients got = adjoint(it.data, it.order, it.params, it.cotangents);
        const auto derivs = eval_derivs(create(it.data).get(), it.order + 1, it.params);
        const size_t axes = it.data.degrees.size();
        for (size_t k = 0; k < it.n; ++k) {
            for (size_t a = 0; a < axes; ++a) {
                const double expected = slope_of(it, derivs.data() + k * (derivs.size() / it.n), k, a);
                const double actual = got.params[k * axes + a];
                if (it.order > 0) {
                    ASSERT_EQ(actual, expected) << where(seed, it.data) << "parameter " << k;
                } else {
                    ASSERT_LE(std::fabs(static_cast<long double>(actual) - expected),
                              2 * slope_bound(it, k, a))
                        << where(seed, it.data) << "parameter " << k;
                }
            }
        }
    });
}

// <G, J V> = <J^T G, V> for a displacement V of the control points, many parameters at once.
TEST(Adjoint, is_the_transpose_of_evaluation) {
    for_each_case(98000000, 300, [](Random &random, uint64_t seed) {
        const Case it = random_case(random, random.whole(1, 3), 4, random.whole(0, 2), 25);
        SplineData moved = it.data;
        for (size_t i = 0; i < moved.points.size(); ++i) {
            moved.points[i] = random.between(-1, 1);
        }
        moved.flags = 0; // V need not wrap
        const Gradients got = adjoint(it.data, it.order, it.params, it.cotangents);
        const auto derivs = eval_derivs(create(moved).get(), it.order, it.params);
        long double left = 0;
        long double right = 0;
        long double bound = DBL_MIN;
        for (size_t k = 0; k < it.n; ++k) {
            const auto sizes = reference::magnitudes(moved, it.order, it.param(k));
            for (size_t s = 0; s < it.slots.size(); ++s) {
                for (size_t c = 0; c < it.dim(); ++c) {
                    const auto g = static_cast<long double>(it.cotangent(k, s, c));
                    left += g * derivs[(k * it.slots.size() + s) * it.dim() + c];
                    // Each side has the error of the derivative, and the right one those of n sums.
                    bound += std::fabs(g) * sizes[s][c] * eps *
                             (2 * it.factor(s) + static_cast<long double>(it.n));
                }
            }
        }
        for (size_t i = 0; i < moved.points.size(); ++i) {
            right += static_cast<long double>(got.points[i]) * moved.points[i];
        }
        ASSERT_LE(std::fabs(left - right), bound) << where(seed, it.data);
    });
}

TEST(Adjoint, pieces_of_a_batch_accumulate_to_the_same_bits) {
    for_each_case(99000000, 300, [](Random &random, uint64_t seed) {
        const Case it = random_case(random, random.whole(1, 3), 4, random.whole(0, 2), 90);
        const auto g = create(it.data);
        const size_t axes = it.data.degrees.size();
        const Gradients whole = adjoint(it.data, it.order, it.params, it.cotangents);
        Gradients pieces = zeros(it.data, it.params.size());
        const size_t record = it.slots.size() * it.dim();
        for (size_t first = 0; first < it.n;) {
            const size_t last = std::min(it.n, first + static_cast<size_t>(random.whole(1, 70)));
            const auto part = [&](const std::vector<double> &values, size_t width) {
                return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first * width),
                                           values.begin() + static_cast<std::ptrdiff_t>(last * width));
            };
            add_adjoint(g.get(), it.order, part(it.params, axes), axes, part(it.cotangents, record), pieces,
                        first, NURBS_ACCUMULATE);
            first = last;
        }
        ASSERT_TRUE(same_bits(pieces.points, whole.points)) << where(seed, it.data);
        ASSERT_TRUE(same_bits(pieces.weights, whole.weights)) << where(seed, it.data);
        ASSERT_TRUE(same_bits(pieces.params, whole.params)) << where(seed, it.data);
        // Without the others, each output is the same.
        Gradients alone = zeros(it.data, it.params.size());
        require_ok(nurbs_eval_adjoint(g.get(), it.order, static_cast<int64_t>(it.n), it.params.data(), 0, 0,
                                      it.cotangents.data(), 0, 0, alone.points.data(), 0, 0, nullptr, 0,
                                      nullptr, 0, 0, 0));
        ASSERT_TRUE(same_bits(alone.points, whole.points)) << where(seed, it.data);
    });
}

// Cubic curves in space, whose batches have a loop of their own, of so many control points that single parameters are
// added without it: sorted and unsorted parameters, some at knots, some outside.
TEST(Adjoint, single_parameters_of_long_curves_accumulate_to_the_same_bits) {
    for_each_case(99600000, 40, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes.push_back(AxisRecipe{3});
        recipe.axes[0].spans = 150;
        recipe.dim = 3;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        Case it;
        it.data = random_spline(random, recipe);
        it.order = 0;
        it.slots = graded_indices(1, 0);
        it.n = 200;
        it.params = random_params(random, it.data, static_cast<int>(it.n));
        if (random.chance(50)) {
            std::sort(it.params.begin(), it.params.end());
        }
        it.params[77] = it.data.knots[0].back() + 1;
        for (size_t i = 0; i < it.n * it.dim(); ++i) {
            it.cotangents.push_back(random.chance(90) ? random.between(-1, 1) : -0.0);
        }
        const auto g = create(it.data);
        Gradients whole = zeros(it.data, it.n), pieces = whole;
        add_adjoint(g.get(), 0, it.params, 1, it.cotangents, whole, 0, NURBS_NAN);
        for (size_t i = 0; i < it.n; ++i) {
            const auto own = it.cotangents.begin() + static_cast<std::ptrdiff_t>(3 * i);
            add_adjoint(g.get(), 0, {it.params[i]}, 1, {own, own + 3}, pieces, i,
                        NURBS_NAN | NURBS_ACCUMULATE);
        }
        ASSERT_TRUE(std::isnan(whole.params[77]));
        ASSERT_TRUE(same_bits(pieces.points, whole.points)) << where(seed, it.data);
        ASSERT_TRUE(same_bits(pieces.weights, whole.weights)) << where(seed, it.data);
        ASSERT_TRUE(same_bits(pieces.params, whole.params)) << where(seed, it.data);
        const std::vector<double> points = whole.points;
        require_ok(nurbs_eval_adjoint(g.get(), 0, static_cast<int64_t>(it.n), it.params.data(), 0, 0,
                                      it.cotangents.data(), 0, 0, whole.points.data(), 0, 0, nullptr, 0,
                                      nullptr, 0, 0, NURBS_NAN));
        ASSERT_TRUE(same_bits(whole.points, points)) << where(seed, it.data);
    });
}

// The shape does not change when all weights are multiplied by a number: sum of w_i dL/dw_i = 0.
TEST(Adjoint, weights_have_no_common_gradient) {
    for_each_case(99500000, 300, [](Random &random, uint64_t seed) {
        const Case it = random_case(random, random.whole(1, 2), 4, random.whole(0, 2), 1);
        const Gradients got = adjoint(it.data, it.order, it.params, it.cotangents);
        Sum all;
        for (const int64_t i :
             reference::active_points(it.data, reference::first_active(it.data, it.param(0)))) {
            const auto at = static_cast<size_t>(i);
            const double w = it.data.weight(i);
            if (w > 0) {
                Sum own;
                add_weight_terms(it, influence(it, 0, at), 0, at, own);
                all.add(exact(got.weights[at]) * exact(w), 0, 0);
                all.bound += w * (own.bound + (1 + static_cast<long double>(it.dim())) * own.size);
            }
        }
        ASSERT_LE(std::fabs(static_cast<long double>(all.value)), eps * all.bound + DBL_MIN)
            << where(seed, it.data);
    });
}

} // namespace

} // namespace adjoint_test
