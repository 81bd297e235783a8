// Polar forms, derivatives and integrals: control points against their exact values, derivatives as splines
// against exact derivatives at points.
#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "same_shape.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace calculus_test {

using namespace support;
using reference::eps;
using reference::Fraction;
using reference::Rational;

namespace {

Handle derivative(const nurbs *g, int axis, int order) {
    nurbs *out = nullptr;
    require_ok(nurbs_derivative(g, axis, order, &out));
    return Handle(out);
}

Handle antiderivative(const nurbs *g, int axis) {
    nurbs *out = nullptr;
    require_ok(nurbs_antiderivative(g, axis, &out));
    return Handle(out);
}

std::vector<double> blossom(const nurbs *g, const SplineData &data, const std::vector<double> &params,
                            const std::vector<double> &args, uint32_t flags) {
    std::vector<double> values(static_cast<size_t>(data.dim + (data.rational() ? 1 : 0)));
    require_ok(nurbs_blossom(g, params.data(), std::ssize(args), args.data(), values.data(), flags));
    return values;
}

Rational rational(const Fraction &x) {
    return Rational(x.numerator, x.denominator);
}

long double size_of(const Rational &x) {
    return std::fabs(reference::quotient(numerator(x), denominator(x)));
}

// The polar form of several axes by contracting one axis after the other, the last one first.
std::vector<Rational> defined_value(const SplineData &data, const std::vector<int64_t> &spans,
                                    const std::vector<std::vector<double>> &args) {
    using Point = std::vector<Rational>;
    const auto recurse = [&](const auto &self, size_t k, int64_t base) -> Point {
        if (k == data.degrees.size()) {
            Point point;
            for (int c = 0; c < data.dim; ++c) {
                point.push_back(reference::exact(data.weight(base)) *
                                reference::exact(data.coordinate(base, c)));
            }
            point.push_back(reference::exact(data.weight(base)));
            return point;
        }
        std::vector<Point> active;
        for (int64_t i = spans[k] - data.degrees[k]; i <= spans[k]; ++i) {
            active.push_back(self(self, k + 1, base * data.counts[k] + i));
        }
        return reference::defined_blossom(data.knots[k], data.degrees[k], spans[k], active, args[k]);
    };
    return recurse(recurse, 0, 0);
}

struct PolarCase {
    std::vector<double> params;
    uint32_t flags = 0;
    std::vector<int64_t> spans;
    std::vector<std::vector<double>> args;
    std::vector<double> flat;
};

// Arguments in the closed spans of a random parameter; every third one at a knot.
PolarCase polar_case(Random &random, const SplineData &data) {
    PolarCase polar;
    reference::Sides sides{};
    polar.params = random_params(random, data, 1);
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        const bool left = random.chance(30);
        polar.flags |= left ? NURBS_ON_AXIS(k, NURBS_LEFT) : 0;
        sides[k] = left;
        const int64_t span = reference::first_active(data, polar.params.data(), sides)[k] + data.degrees[k];
        polar.spans.push_back(span);
        const double low = data.knots[k][static_cast<size_t>(span)];
        const double high = data.knots[k][static_cast<size_t>(span) + 1];
        polar.args.emplace_back();
        for (int i = 0; i < data.degrees[k]; ++i) {
            const double inside = std::clamp(random.between(low, high), low, high);
            polar.args.back().push_back(random.chance(67) ? inside : random.chance(50) ? low : high);
        }
        polar.flat.insert(polar.flat.end(), polar.args.back().begin(), polar.args.back().end());
    }
    return polar;
}

int degrees_and_one(const SplineData &data) {
    int total = 0;
    for (const int32_t p : data.degrees) {
        total += p + 1;
    }
    return total;
}

// The largest magnitude of each homogeneous component among the active control points.
std::vector<long double> component_hulls(const SplineData &data, const std::vector<int64_t> &spans) {
    std::vector<long double> hulls(static_cast<size_t>(data.dim) + 1, 0);
    std::vector<int64_t> first;
    for (size_t k = 0; k < spans.size(); ++k) {
        first.push_back(spans[k] - data.degrees[k]);
    }
    for (const int64_t i : reference::active_points(data, first)) {
        for (int c = 0; c <= data.dim; ++c) {
            const long double x =
                data.weight(i) *
                (c < data.dim ? std::fabs(static_cast<long double>(data.coordinate(i, c))) : 1);
            hulls[static_cast<size_t>(c)] = std::max(hulls[static_cast<size_t>(c)], x);
        }
    }
    return hulls;
}

TEST(Blossom, values_are_exact_to_the_bound_and_symmetric) {
    WorstErrors worst("polar forms by degree of axis 0, unit eps * hull");
    for_each_case(610000, 2000, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const auto data = random_spline(random, random_recipe(random, axes, axes == 1 ? 12 : 3));
        const auto g = create(data);
        PolarCase polar = polar_case(random, data);
        const auto got = blossom(g.get(), data, polar.params, polar.flat, polar.flags);
        const auto want = defined_value(data, polar.spans, polar.args);
        const auto hulls = component_hulls(data, polar.spans);
        const long double bound = 4 * degrees_and_one(data);
        for (size_t c = 0; c < got.size(); ++c) {
            const long double error =
                reference::error_ratio(got[c], reference::fraction(want[c]), eps * hulls[c]);
            worst.add(data.degrees[0], error / bound, error);
            ASSERT_LE(error, bound) << where(seed, data) << hex(polar.flat);
        }
        std::reverse(polar.flat.begin(), polar.flat.begin() + data.degrees[0]);
        const auto turned = blossom(g.get(), data, polar.params, polar.flat, polar.flags);
        for (size_t c = 0; c < got.size(); ++c) {
            ASSERT_LE(std::fabs(turned[c] - static_cast<long double>(got[c])), 2 * bound * eps * hulls[c]);
        }
    });
}

// At consecutive knots it is a control point, bit for bit; outside the span it is still the polynomial's.
TEST(Blossom, gives_control_points_and_continues) {
    for_each_case(620000, 1000, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 9);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const PolarCase polar = polar_case(random, data);
        const int p = data.degrees[0];
        const int64_t i = polar.spans[0] - p + random.whole(0, p);
        const auto from = data.knots[0].begin() + i + 1;
        const auto point = blossom(g.get(), data, polar.params, {from, from + p}, polar.flags);
        for (int c = 0; c < data.dim; ++c) {
            ASSERT_EQ(point[static_cast<size_t>(c)], data.coordinate(i, c)) << where(seed, data);
        }
        const double t = data.lower(0) + (data.upper(0) - data.lower(0)) * random.between(-1, 2);
        const auto far =
            blossom(g.get(), data, polar.params, std::vector<double>(static_cast<size_t>(p), t), polar.flags);
        // de Boor's coefficients in magnitudes.
        std::vector<long double> row{1};
        for (int d = 1; d <= p; ++d) {
            std::vector<long double> next(row.size() + 1, 0);
            for (int r = 0; r < d; ++r) {
                const long double low = data.knots[0][static_cast<size_t>(polar.spans[0] + 1 - d + r)];
                const long double high = data.knots[0][static_cast<size_t>(polar.spans[0] + 1 + r)];
                next[static_cast<size_t>(r)] +=
                    row[static_cast<size_t>(r)] * std::fabs((high - t) / (high - low));
                next[static_cast<size_t>(r) + 1] +=
                    row[static_cast<size_t>(r)] * std::fabs((t - low) / (high - low));
            }
            row = next;
        }
        const auto want = defined_value(data, polar.spans, {std::vector<double>(static_cast<size_t>(p), t)});
        for (int c = 0; c < data.dim; ++c) {
            long double size = 0;
            for (int j = 0; j <= p; ++j) {
                size += row[static_cast<size_t>(j)] *
                        std::fabs(static_cast<long double>(data.coordinate(polar.spans[0] - p + j, c)));
            }
            ASSERT_LE(reference::error_ratio(far[static_cast<size_t>(c)],
                                             reference::fraction(want[static_cast<size_t>(c)]), eps * size),
                      4 * (p + 1))
                << where(seed, data) << hex(t);
        }
    });
}

// The sides that a spline of derivatives is looked at from.
reference::Sides random_sides(Random &random, const SplineData &data, const std::vector<double> &param) {
    reference::Sides left{};
    for (int k = 0; k < data.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        left[at] = param[at] == data.upper(k) || (param[at] != data.lower(k) && random.chance(30));
    }
    return left;
}

MultiIndex pure(int axes, int axis, int order) {
    MultiIndex index(static_cast<size_t>(axes), 0);
    index[static_cast<size_t>(axis)] = order;
    return index;
}

TEST(Derivative, polynomial_derivatives_are_exact_to_two_eps_an_order) {
    WorstErrors worst("derivatives as splines by degree, unit eps * H * order");
    for_each_case(630000, 1500, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 3);
        recipe.weights = Weights::none;
        const int axis = random.whole(0, axes - 1), order = random.whole(1, 3);
        AxisRecipe &along = recipe.axes[static_cast<size_t>(axis)];
        if (along.form == KnotForm::periodic) { // whose knots repeat exactly
            along.spacing = Spacing::few_bits;
            along.placement = Placement::origin;
        }
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const auto made = derivative(g.get(), axis, order);
        const auto got = read_back(made.get());
        const int p = data.degrees[static_cast<size_t>(axis)];
        ASSERT_EQ(got.degrees[static_cast<size_t>(axis)], std::max(p - order, 0)) << where(seed, data);
        ASSERT_EQ(got.flags, data.flags) << where(seed, data);
        ASSERT_EQ(got.lower(axis), data.lower(axis));
        ASSERT_EQ(got.upper(axis), data.upper(axis));
        const auto slot = static_cast<size_t>(slot_of(pure(axes, axis, order)));
        for (int n = 0; n < 3; ++n) {
            const auto param = random_params(random, data, 1);
            const auto left = random_sides(random, data, param);
            const auto want = reference::exact_derivatives(data, order, param.data(), left)[slot];
            const auto point = reference::exact_point(got, param.data(), left);
            const auto sizes = reference::magnitudes(data, order, param.data(), left)[slot];
            for (size_t c = 0; c < point.size(); ++c) {
                const long double error = size_of(rational(point[c]) - rational(want[c]));
                const long double unit = eps * sizes[c] * order;
                if (error != 0) {
                    worst.add(p, error / unit / 2, error / unit);
                    ASSERT_LE(error, 2 * unit) << where(seed, data) << hex(param) << axis << " " << order;
                }
            }
        }
    });
}

// The first derivative's control points, each relative to itself.
TEST(Derivative, differences_are_accurate_relative_to_themselves) {
    for_each_case(640000, 1000, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 9);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        if (data.degrees[0] == 0 || data.periodic(0)) {
            return;
        }
        const auto got = read_back(derivative(create(data).get(), 0, 1).get());
        int64_t layer = 0;
        const int p = data.degrees[0];
        for (int64_t i = 0; i + 1 < data.counts[0]; ++i) {
            const double low = data.knots[0][static_cast<size_t>(i + 1)];
            const double high = data.knots[0][static_cast<size_t>(i + p + 1)];
            for (int c = 0; low < high && c < data.dim; ++c) {
                const Rational want =
                    p *
                    (reference::exact(data.coordinate(i + 1, c)) - reference::exact(data.coordinate(i, c))) /
                    (reference::exact(high) - reference::exact(low));
                ASSERT_LE(reference::error_ratio(got.coordinate(layer, c), reference::fraction(want),
                                                 eps * size_of(want)),
                          2)
                    << where(seed, data);
            }
            layer += low < high ? 1 : 0;
        }
        ASSERT_EQ(layer, got.counts[0]) << where(seed, data);
    });
}

// The integral's control points are sums of S_i, from the start of the domain on.
TEST(Antiderivative, control_points_are_exact_to_two_eps_of_the_sum) {
    WorstErrors worst("integrals by degree, unit eps * sum of |S_i|");
    for_each_case(650000, 250, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 9);
        recipe.weights = Weights::none;
        recipe.axes[0].spans = random.whole(1, 30);
        const auto data = random_spline(random, recipe);
        const auto got = read_back(antiderivative(create(data).get(), 0).get());
        const int p = data.degrees[0];
        const bool clamped = data.knots[0].front() == data.lower(0);
        ASSERT_EQ(got.degrees[0], p + 1);
        ASSERT_EQ(got.flags, 0U);
        const int64_t span = reference::first_active(got, &data.knots[0][static_cast<size_t>(p)])[0] + p + 1;
        for (int c = 0; c < data.dim; ++c) {
            std::vector<Rational> sums{0};
            std::vector<long double> sizes{0};
            for (int64_t i = 0; i < data.counts[0]; ++i) {
                const Rational step = reference::exact(data.coordinate(i, c)) *
                                      (reference::exact(data.knots[0][static_cast<size_t>(i + p + 1)]) -
                                       reference::exact(data.knots[0][static_cast<size_t>(i)])) /
                                      (p + 1);
                sums.push_back(sums.back() + step);
                sizes.push_back(sizes.back() + size_of(step));
            }
            Rational start = 0;
            for (int64_t j = span - p - 1; j <= span; ++j) {
                start +=
                    sums[static_cast<size_t>(j)] *
                    reference::defined_basis(got.knots[0], span, j, p + 1, reference::exact(data.lower(0)));
            }
            const long double base = clamped ? 0 : 6 * (p + 2) * sizes[static_cast<size_t>(span)];
            for (int64_t j = 0; j < got.counts[0]; ++j) {
                const long double bound = eps * (2 * sizes[static_cast<size_t>(j)] + base);
                const Rational want = sums[static_cast<size_t>(j)] - start;
                const long double error =
                    reference::error_ratio(got.coordinate(j, c), reference::fraction(want), bound);
                worst.add(p, error, error * bound / eps / sizes.back());
                ASSERT_LE(error, 1) << where(seed, data) << " layer " << j;
            }
        }
    });
}

// Differentiation undoes integration: the same knots and, up to rounding, control points.
TEST(Antiderivative, derivative_gives_the_spline_back) {
    for_each_case(660000, 600, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, 4);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, axes - 1);
        const auto integral = antiderivative(create(data).get(), axis);
        const auto got = read_back(derivative(integral.get(), axis, 1).get());
        ASSERT_TRUE(same_bits(got.all_knots(), data.all_knots())) << where(seed, data);
        const auto sums = read_back(integral.get());
        const Layers layers(data, axis), summed(sums, axis);
        const auto k = static_cast<size_t>(axis);
        for (int64_t o = 0; o < layers.outer; ++o) {
            for (int64_t layer = 0; layer < layers.count; ++layer) {
                const double length = data.knots[k][static_cast<size_t>(layer + data.degrees[k] + 1)] -
                                      data.knots[k][static_cast<size_t>(layer)];
                for (int64_t i = 0; i < layers.inner; ++i) {
                    for (int c = 0; c < data.dim; ++c) {
                        // Each of the two neighbours is rounded once, relative to itself; the differences
                        // then are, and errors that the layers have in common cancel.
                        const long double size = std::fabs(sums.coordinate(summed.place(o, layer, i), c)) +
                                                 std::fabs(sums.coordinate(summed.place(o, layer + 1, i), c));
                        const double want = data.coordinate(layers.place(o, layer, i), c);
                        ASSERT_LE(std::fabs(got.coordinate(layers.place(o, layer, i), c) -
                                            static_cast<long double>(want)),
                                  eps * (4 * std::fabs(want) + (data.degrees[k] + 1) * size / length))
                            << where(seed, data);
                    }
                }
            }
        }
    });
}

TEST(Derivative, rational_derivatives_are_exact_to_rounding) {
    WorstErrors worst("rational derivatives by degree, unit eps * size");
    for_each_case(670000, 500, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 7 : axes == 2 ? 3 : 1);
        recipe.weights = random.chance(50) ? Weights::moderate : Weights::ones;
        recipe.dim = random.whole(1, 3);
        const int axis = random.whole(0, axes - 1);
        for (AxisRecipe &k : recipe.axes) {
            k.spans = random.whole(1, 3);
            if (k.form == KnotForm::periodic) {
                k.spacing = Spacing::few_bits;
                k.placement = Placement::origin;
            }
        }
        auto data = random_spline(random, recipe);
        for (double &x : data.points) {
            x += seed % 2 == 0 ? 0 : 1e6; // errors do not grow with the distance from 0
        }
        const int p = data.degrees[static_cast<size_t>(axis)];
        const int order = p > 0 && p <= 3 && axes == 1 ? random.whole(1, 3) : 1;
        const auto g = create(data);
        const auto made = derivative(g.get(), axis, order);
        const auto got = read_back(made.get());
        for (int k = 0; k < axes; ++k) {
            ASSERT_EQ(got.degrees[static_cast<size_t>(k)],
                      p == 0 ? data.degrees[static_cast<size_t>(k)] * (k != axis)
                             : (order + 1) * data.degrees[static_cast<size_t>(k)])
                << where(seed, data);
            ASSERT_EQ(got.lower(k), data.lower(k));
            ASSERT_EQ(got.upper(k), data.upper(k));
        }
        ASSERT_EQ(got.flags, data.flags) << where(seed, data);
        const auto slot = static_cast<size_t>(slot_of(pure(axes, axis, order)));
        for (int n = 0; n < 2; ++n) {
            const auto param = random_params(random, data, 1);
            const auto left = random_sides(random, data, param);
            const auto want = reference::exact_derivatives(data, order, param.data(), left)[slot];
            const auto point = reference::exact_point(got, param.data(), left);
            // Weights lie in [0.2, 5]; the differences of step j are over p + 1 - j spans.
            const auto &knots = data.knots[static_cast<size_t>(axis)];
            const long double spread = recipe.weights == Weights::ones ? 1 : 25;
            long double growth = 1;
            for (int step = 1; step <= order; ++step) {
                const auto over = static_cast<size_t>(std::max(p + 1 - step, 1));
                long double shortest = knots.back() - knots.front();
                for (size_t i = 0; i + over < knots.size(); ++i) {
                    const long double length = knots[i + over] - knots[i];
                    shortest = length > 0 ? std::min(shortest, length) : shortest;
                }
                growth *= step * 4 * p * spread / shortest;
            }
            const auto origin = reference::origin_of(data);
            double scale = 0;
            for (size_t i = 0; i < data.points.size(); ++i) {
                scale = std::max(scale, std::fabs(data.points[i] - origin[i % origin.size()]));
            }
            const long double unit = eps * scale * growth;
            for (size_t c = 0; c < point.size(); ++c) {
                const long double error = size_of(rational(point[c]) - rational(want[c]));
                if (error != 0) {
                    worst.add(p, error / unit / (8 * order), error / unit);
                    ASSERT_LE(error, 8 * order * unit)
                        << where(seed, data) << hex(param) << axis << " " << order;
                }
            }
        }
    });
}

} // namespace

} // namespace calculus_test
