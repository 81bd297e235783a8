// Points, weights and gradients for integrands of others: what rules are exact for, and the patch test.
#include "property/measures.h"
#include "property/solids.h"
#include "support/cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace quadrature_test {

using namespace support;
using measures::double_eps;
using measures::pi;
using Vec = std::vector<double>;

namespace {

struct Rule {
    Vec params, weights, measures;
    [[nodiscard]] size_t size() const { return weights.size(); }
};

Rule rule_of(const nurbs *g, int32_t nodes) {
    int64_t count = -1;
    int32_t axes = 0;
    require_ok(nurbs_axes(g, &axes));
    require_ok(nurbs_quadrature(g, nodes, 0, nullptr, nullptr, nullptr, &count));
    Rule rule{Vec(static_cast<size_t>(count * axes)), Vec(static_cast<size_t>(count)),
              Vec(static_cast<size_t>(count))};
    require_ok(nurbs_quadrature(g, nodes, count, rule.params.data(), rule.weights.data(),
                                rule.measures.data(), nullptr));
    return rule;
}

double sum_of(const Vec &values) {
    double sum = 0;
    for (const double x : values) {
        sum += x;
    }
    return sum;
}

struct Gradients {
    std::vector<int64_t> spans;
    Vec all; // [n][active points][dim]
};

Gradients gradients_of(const nurbs *g, const Vec &params, size_t active, size_t axes, size_t dim) {
    const size_t n = params.size() / axes;
    Gradients found{std::vector<int64_t>(n * axes), Vec(n * active * dim)};
    require_ok(nurbs_basis_gradients(g, static_cast<int64_t>(n), params.data(), 0, 0, found.spans.data(),
                                     found.all.data(), 0, 0, 0));
    return found;
}

// The numbers of the active control points, in the order of their functions.
std::vector<int64_t> active_points(const SplineData &data, const int64_t *spans) {
    std::vector<int64_t> found{0};
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        std::vector<int64_t> more;
        for (const int64_t before : found) {
            for (int64_t i = spans[k] - data.degrees[k]; i <= spans[k]; ++i) {
                more.push_back(before * data.counts[k] + i);
            }
        }
        found = more;
    }
    return found;
}

double dot(const double *a, const double *b, size_t n) {
    double sum = 0;
    for (size_t c = 0; c < n; ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

double length(const double *a, size_t n) {
    return std::sqrt(dot(a, a, n));
}

// The smallest |sum of x_k S_k / |S_k|| for |x| = 1, about: that of all vectors but one from each of them.
double independence(const Vec &tangents, size_t axes, size_t dim) {
    double least = 1;
    Vec own = tangents;
    for (size_t k = 0; k < axes; ++k) {
        double *x = own.data() + k * dim;
        const double size = length(x, dim);
        for (size_t j = 0; j < k; ++j) {
            const double part = dot(x, own.data() + j * dim, dim);
            for (size_t c = 0; c < dim; ++c) {
                x[c] -= part * own[j * dim + c];
            }
        }
        const double rest = length(x, dim);
        least = std::min(least, size > 0 ? rest / size : 0);
        for (size_t c = 0; c < dim; ++c) {
            x[c] /= rest > 0 ? rest : 1;
        }
    }
    return std::isfinite(least) ? least : 0;
}

// By the span of each axis that a parameter is in: |S_k| times its length, of the size of the spline.
double least_size(const SplineData &data, const Vec &tangents, const int64_t *spans) {
    const auto dim = static_cast<size_t>(data.dim);
    double least = 1;
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        const auto at = static_cast<size_t>(spans[k]);
        const double span = data.knots[k][at + 1] - data.knots[k][at];
        least = std::min(least, length(tangents.data() + k * dim, dim) * span / extent(data));
    }
    return least;
}

Recipe any_recipe(Random &random, int most_degree) {
    Recipe recipe = random_recipe(random, random.whole(1, 3), most_degree);
    recipe.dim = static_cast<int>(recipe.axes.size()) + random.whole(0, 2);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = random.whole(1, 3);
        axis.spacing =
            axis.spacing == Spacing::tiny || axis.spacing == Spacing::ratio ? Spacing::full : axis.spacing;
    }
    return recipe;
}

} // namespace

TEST(Quadrature, points_lie_in_the_spans_one_after_the_other) {
    for_each_case(4210000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spans = random.whole(1, 3);
        }
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const auto nodes = static_cast<int32_t>(random.whole(0, 4));
        const Rule rule = rule_of(g.get(), nodes);
        const auto axes = static_cast<size_t>(data.axes());
        size_t active = 1, per = 1;
        double domain = 1;
        for (size_t k = 0; k < axes; ++k) {
            active *= static_cast<size_t>(data.degrees[k]) + 1;
            per *= nodes == 0 ? static_cast<size_t>(data.degrees[k]) + 1 : static_cast<size_t>(nodes);
            domain *= data.upper(static_cast<int>(k)) - data.lower(static_cast<int>(k));
        }
        const auto n = static_cast<int64_t>(rule.size());
        std::vector<int64_t> spans(rule.size() * axes);
        Vec values(rule.size() * active);
        require_ok(
            nurbs_rational_basis(g.get(), n, rule.params.data(), 0, 0, spans.data(), values.data(), 0, 0, 0));
        ASSERT_EQ(rule.size() % per, 0U) << seed;
        for (size_t i = 0; i < rule.size(); ++i) {
            const auto own = spans.begin() + static_cast<std::ptrdiff_t>(i * axes),
                       first = spans.begin() + static_cast<std::ptrdiff_t>(i / per * per * axes);
            const auto size = static_cast<std::ptrdiff_t>(axes);
            ASSERT_TRUE(std::equal(own, own + size, first)) << seed << ' ' << describe(data);
            ASSERT_TRUE(i % per != 0 || i == 0 ||
                        std::lexicographical_compare(own - size, own, own, own + size))
                << seed;
            ASSERT_GT(rule.weights[i], 0) << seed;
            ASSERT_GE(rule.measures[i], 0) << seed;
        }
        ASSERT_NEAR(sum_of(rule.weights), domain, 1e-12 * domain) << seed;
    });
}

// More nodes than a polynomial needs change nothing: its coordinates, and the content of bodies that are not folded.
TEST(Quadrature, is_exact_for_polynomials) {
    for_each_case(4220000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe = any_recipe(random, 4);
        recipe.weights = Weights::none;
        for (AxisRecipe &axis : recipe.axes) {
            axis.placement = Placement::origin; // far off, parameters are rounded by more
        }
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const auto dim = static_cast<size_t>(data.dim);
        std::array<Vec, 2> sums{Vec(dim), Vec(dim)};
        double size = 0;
        for (size_t pass = 0; pass < 2; ++pass) {
            const Rule rule = rule_of(g.get(), pass == 0 ? 0 : 9); // 0: degree 2 p + 1, more than p
            const Vec points = eval(g.get(), rule.params);
            for (size_t i = 0; i < rule.size(); ++i) {
                for (size_t c = 0; c < dim; ++c) {
                    sums[pass][c] += rule.weights[i] * points[i * dim + c];
                }
                size += rule.weights[i] * extent(data);
            }
        }
        for (size_t c = 0; c < dim; ++c) {
            ASSERT_NEAR(sums[0][c], sums[1][c], 1e-12 * size) << seed << ' ' << describe(data);
        }
    });
}

TEST(Quadrature, of_shapes_converges_to_their_moments) {
    const double centre[] = {1, 2, 3};
    const Handle shapes[] = {
        made([&](nurbs **out) { return nurbs_surface_sphere(centre, nullptr, nullptr, 2, 0, out); }),
        made([&](nurbs **out) {
            return nurbs_surface_torus(centre, nullptr, nullptr, 3, 1, 0, 2 * pi, 0, 2 * pi, 0, out);
        }),
        made([&](nurbs **out) { return nurbs_curve_circle(2, centre, nullptr, nullptr, 2, 0, out); })};
    const double contents[] = {16 * pi, 12 * pi * pi, 4 * pi};
    for (size_t i = 0; i < 3; ++i) {
        const Rule rule = rule_of(shapes[i].get(), 40);
        const size_t dim = i == 2 ? 2 : 3;
        ASSERT_NEAR(sum_of(rule.measures), contents[i], 1e-11 * contents[i]) << i;
        const Vec points = eval(shapes[i].get(), rule.params);
        for (size_t c = 0; c < dim; ++c) {
            double sum = 0;
            for (size_t j = 0; j < rule.size(); ++j) {
                sum += rule.measures[j] * points[dim * j + c];
            }
            EXPECT_NEAR(sum / contents[i], centre[c], 1e-11) << i;
        }
    }
}

// Gram's determinant, whatever the dimension: a body in space is as large in a space of more dimensions.
TEST(Quadrature, measures_of_bodies_do_not_know_the_space_around) {
    for_each_case(4230000, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = any_recipe(random, 3);
        recipe.dim = static_cast<int>(recipe.axes.size());
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        SplineData wide = data;
        wide.dim = data.dim + 1;
        wide.points.clear();
        for (int64_t i = 0; i < data.point_count(); ++i) {
            for (int c = 0; c <= data.dim; ++c) { // (x, ..., z) becomes (x, ..., 0.6 z, 0.8 z)
                const double last = data.coordinate(i, data.dim - 1);
                wide.points.push_back(c < data.dim - 1 ? data.coordinate(i, c)
                                                       : (c == data.dim ? 0.8 : 0.6) * last);
            }
        }
        const Rule own = rule_of(create(data).get(), 3), other = rule_of(create(wide).get(), 3);
        for (size_t i = 0; i < own.size(); ++i) {
            ASSERT_NEAR(own.measures[i], other.measures[i],
                        1e-9 * own.measures[i] + 1e-10 * std::pow(extent(data), data.axes()))
                << seed << ' ' << describe(data);
        }
    });
}

// To rounding: what far larger numbers are evaluated by may be other sums.
TEST(Quadrature, is_scale_free) {
    for_each_case(4240000, 40, [](Random &random, uint64_t seed) {
        Recipe recipe = any_recipe(random, 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const Rule own = rule_of(create(data).get(), 2);
        const double room = 1e-11 * std::pow(extent(data), data.axes());
        for (const int e : {-90, 90}) {
            const Rule other = rule_of(create(scaled(data, std::ldexp(1, e), std::ldexp(1, -e))).get(), 2);
            for (size_t i = 0; i < own.size(); ++i) {
                ASSERT_NEAR(std::ldexp(other.measures[i], -e * data.axes()), own.measures[i], room)
                    << seed << ' ' << e;
                ASSERT_EQ(other.weights[i], std::ldexp(own.weights[i], -e * data.axes())) << seed << ' ' << e;
            }
        }
    });
}

// They sum to 0, those of the coordinates are the unit vectors along the tangents, and nothing of them is across these.
TEST(BasisGradients, pass_the_patch_test) {
    int64_t compared = 0, none = 0;
    for_each_case(4250000, 600, [&](Random &random, uint64_t seed) {
        Recipe recipe = any_recipe(random, 4);
        recipe.weights = recipe.weights == Weights::extreme ? Weights::moderate : recipe.weights;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const Vec params = random_params(random, data, 6);
        const auto axes = static_cast<size_t>(data.axes()), dim = static_cast<size_t>(data.dim);
        size_t active = 1;
        for (const int32_t degree : data.degrees) {
            active *= static_cast<size_t>(degree) + 1;
        }
        const Gradients found = gradients_of(g.get(), params, active, axes, dim);
        const Vec jets = eval_derivs(g.get(), 1, params);
        for (size_t i = 0; i < params.size() / axes; ++i) {
            const double *grads = found.all.data() + i * active * dim;
            const Vec tangents(jets.begin() + static_cast<std::ptrdiff_t>((i * (axes + 1) + 1) * dim),
                               jets.begin() + static_cast<std::ptrdiff_t>((i + 1) * (axes + 1) * dim));
            const double sine = independence(tangents, axes, dim),
                         size = least_size(data, tangents, found.spans.data() + i * axes);
            if (std::isnan(grads[0])) {
                ++none;
                ASSERT_LE(sine * size, 1e-9) << seed << ' ' << describe(data);
                continue;
            }
            if (sine * size < 1e-4) {
                continue;
            }
            ++compared;
            const std::vector<int64_t> points = active_points(data, found.spans.data() + i * axes);
            Vec sum(dim), coordinates(dim * dim), sizes(dim);
            double total = 0, reach = 0;
            for (size_t j = 0; j < active; ++j) {
                total += length(grads + j * dim, dim);
                for (size_t c = 0; c < dim; ++c) {
                    const double x = data.coordinate(points[j], static_cast<int>(c)) -
                                     data.coordinate(points[0], static_cast<int>(c));
                    reach = std::max(reach, std::abs(x));
                    sum[c] += grads[j * dim + c];
                    for (size_t d = 0; d < dim; ++d) {
                        coordinates[c * dim + d] += x * grads[j * dim + d];
                    }
                }
            }
            const double room = 1e-11 / (sine * sine * size);
            ASSERT_LE(length(sum.data(), dim), room * total) << seed << ' ' << describe(data);
            for (size_t k = 0; k < axes; ++k) { // grad x . S_k = x_k
                const double *s = tangents.data() + k * dim;
                for (size_t c = 0; c < dim; ++c) {
                    ASSERT_NEAR(dot(coordinates.data() + c * dim, s, dim), s[c],
                                room * (total * reach + extent(data) * total) * length(s, dim))
                        << seed << ' ' << describe(data);
                }
            }
            double trace = 0; // of the projection: as many as there are axes
            for (size_t c = 0; c < dim; ++c) {
                trace += coordinates[c * dim + c];
            }
            ASSERT_NEAR(trace, static_cast<double>(axes), room * (1 + total * (reach + extent(data))))
                << seed;
        }
    });
    EXPECT_GE(compared, of_whole_run(1000));
    EXPECT_GE(none, of_whole_run(100));
}

// Along a derivative of the spline they are the derivatives of the functions, by differences of their values.
TEST(BasisGradients, are_those_of_the_rational_functions) {
    for_each_case(4260000, 100, [](Random &random, uint64_t seed) {
        Recipe recipe = any_recipe(random, 3);
        recipe.weights = Weights::moderate;
        for (AxisRecipe &axis : recipe.axes) {
            axis.degree = std::max(axis.degree, 1);
            axis.spacing = Spacing::integers;
            axis.placement = Placement::origin;
        }
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const Rule rule = rule_of(g.get(), 1); // middles of spans
        const auto axes = static_cast<size_t>(data.axes()), dim = static_cast<size_t>(data.dim);
        const Vec at(rule.params.begin(), rule.params.begin() + static_cast<std::ptrdiff_t>(axes));
        size_t active = rational_basis(g.get(), at).size();
        const Gradients found = gradients_of(g.get(), at, active, axes, dim);
        const Vec jets = eval_derivs(g.get(), 1, at);
        const Vec tangents(jets.begin() + static_cast<std::ptrdiff_t>(dim), jets.end());
        const double sine =
            independence(tangents, axes, dim) * least_size(data, tangents, found.spans.data());
        for (size_t k = 0; k < axes && sine > 1e-4; ++k) {
            Vec before = at, after = at;
            const double step = 0x1p-14;
            before[k] -= step;
            after[k] += step;
            const Vec low = rational_basis(g.get(), before), high = rational_basis(g.get(), after);
            for (size_t j = 0; j < active; ++j) {
                const double *s = jets.data() + (k + 1) * dim, *own = found.all.data() + j * dim;
                ASSERT_NEAR(dot(own, s, dim), (high[j] - low[j]) / (2 * step),
                            1e-5 + 1e-9 * length(own, dim) * length(s, dim))
                    << seed << ' ' << describe(data);
            }
        }
    });
}

// Where a shape lies moves no bit, if its coordinates can be told.
TEST(BasisGradients, do_not_know_where_the_shape_lies) {
    for_each_case(4270000, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = any_recipe(random, 3);
        recipe.weights = Weights::none;
        recipe.short_numbers = true;
        SplineData data = random_spline(random, recipe);
        const double size = std::max(extent(data), 1e-300);
        for (double &x : data.points) {
            x = std::nearbyint(std::ldexp(x, 8) / size) + 0x1p40;
        }
        SplineData other = data;
        for (double &x : other.points) {
            x -= 0x1p40;
        }
        const Vec params = random_params(random, data, 4);
        const auto axes = static_cast<size_t>(data.axes()), dim = static_cast<size_t>(data.dim);
        size_t active = 1;
        for (const int32_t degree : data.degrees) {
            active *= static_cast<size_t>(degree) + 1;
        }
        ASSERT_TRUE(same_bits(gradients_of(create(data).get(), params, active, axes, dim).all,
                              gradients_of(create(other).get(), params, active, axes, dim).all))
            << seed;
    });
}

// As element matrices sum it up: the integral of |grad x|^2 over a ring is its area.
TEST(BasisGradients, give_the_energy_of_a_coordinate) {
    const double centre[] = {0, 0};
    std::vector<Handle> circles;
    for (const double radius : {1.0, 2.0}) {
        circles.push_back(made([&](nurbs **out) {
            return nurbs_curve_circle(2, centre, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
        }));
    }
    const Handle ring =
        made([&](nurbs **out) { return nurbs_ruled(circles[0].get(), circles[1].get(), 0, out); });
    const SplineData data = read_back(ring.get());
    const Rule rule = rule_of(ring.get(), 12);
    const size_t active = static_cast<size_t>((data.degrees[0] + 1) * (data.degrees[1] + 1));
    const Gradients found = gradients_of(ring.get(), rule.params, active, 2, 2);
    double energy = 0;
    for (size_t i = 0; i < rule.size(); ++i) {
        const std::vector<int64_t> points = active_points(data, found.spans.data() + 2 * i);
        double gradient[2] = {0, 0};
        for (size_t j = 0; j < active; ++j) {
            for (size_t c = 0; c < 2; ++c) {
                gradient[c] += data.coordinate(points[j], 0) * found.all[(i * active + j) * 2 + c];
            }
        }
        energy += rule.measures[i] * dot(gradient, gradient, 2);
    }
    EXPECT_NEAR(energy, 3 * pi, 1e-10);
}

} // namespace quadrature_test
