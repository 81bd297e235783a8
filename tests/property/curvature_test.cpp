// Principal curvatures and directions of surfaces: closed forms, exact derivatives, invariance.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace curvature_test {

using namespace support;
using reference::eps;

namespace {

constexpr double tolerance = 1e-13;

// The normals of revolved() point outwards, away from which everything bends: curvatures are negative.
TEST(Curvature, spheres_are_umbilic_everywhere) {
    for (const double r : {1.0, 1e-6, 1e6, 3.7}) {
        for (const double speed : {1.0, 1e-9}) {
            const auto g = create(scaled(revolved(half_circle(r, 0)), 1, speed));
            Random random(800000);
            for (int i = 0; i < 300; ++i) {
                const std::vector<double> param{random.unit() * speed, random.between(0.05, 0.95) * speed};
                const auto c = surface_curvatures(g.get(), param);
                const auto f = surface_frames(g.get(), param);
                ASSERT_NEAR(c.principal[0] * r, -1, tolerance);
                ASSERT_NEAR(c.principal[1] * r, -1, tolerance);
                ASSERT_NEAR(c.mean[0] * r, -1, tolerance);
                ASSERT_NEAR(c.gaussian[0] * r * r, 1, 2 * tolerance);
                ASSERT_GE(c.principal[0], c.principal[1]);
                ASSERT_EQ(c.status[0], NURBS_FRAME_RULE) << hex(param);
                const Vector e1 = unit(vector_at(f.du, 0));
                ASSERT_LE(norm(minus(vector_at(c.directions, 0, 6), e1)), 8 * eps);
                ASSERT_LE(norm(minus(vector_at(c.directions, 0, 6, 3), cross(vector_at(f.normals, 0), e1))),
                          64 * eps);
            }
        }
    }
}

TEST(Curvature, cylinders_and_planes) {
    const auto g = create(revolved({{1}, {2}, {{0, 0, 1, 1}}, 2, {2, 0, 2, 5}, {}, 0}));
    Random random(801000);
    for (int i = 0; i < 300; ++i) {
        const std::vector<double> param{random.unit(), random.unit()};
        const auto c = surface_curvatures(g.get(), param);
        ASSERT_NEAR(c.principal[0], 0, tolerance);
        ASSERT_NEAR(c.principal[1], -0.5, tolerance);
        ASSERT_NEAR(c.gaussian[0], 0, tolerance);
        ASSERT_EQ(c.status[0], 0);
        ASSERT_NEAR(std::fabs(c.directions[2]), 1, tolerance); // k1 along the ruling
        ASSERT_NEAR(c.directions[5], 0, tolerance);
    }
    const SplineData plane = {
        {1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 1, 3, 1, 2, 0, 1, 4, 3, 2.5}, {}, 0};
    SplineData flat = plane;
    flat.points = {0, 0, 1, 0, 1, 1, 2, 0, 1, 3, 2, 1};
    const auto c = surface_curvatures(create(flat).get(), {0.3, 0.4});
    EXPECT_EQ(c.status[0], NURBS_FRAME_RULE);
    EXPECT_NEAR(c.principal[0], 0, tolerance);
    EXPECT_NEAR(c.principal[1], 0, tolerance);
}

// Around the tube -1/r, around the axis -cos v / (R + r cos v).
TEST(Curvature, tori) {
    for (const double size : {1.0, 1e-6, 1e6}) {
        const double big = 3 * size;
        const auto g = create(revolved(full_circle(size, big)));
        Random random(802000);
        for (int i = 0; i < 500; ++i) {
            const std::vector<double> param{random.unit(), random.unit()};
            const auto c = surface_curvatures(g.get(), param);
            const auto f = surface_frames(g.get(), param);
            const double r = std::hypot(f.points[0], f.points[1]);
            const double around = -(r - big) / size / r;
            ASSERT_NEAR(c.principal[0] * size, around * size, tolerance);
            ASSERT_NEAR(c.principal[1] * size, -1, tolerance);
            ASSERT_NEAR(c.gaussian[0] * size * size, -around * size, tolerance);
            ASSERT_NEAR(c.mean[0] * size, 0.5 * (around * size - 1), tolerance);
            ASSERT_EQ(c.status[0], 0);
            const Vector parallel = {-f.points[1] / r, f.points[0] / r, 0};
            ASSERT_LE(norm(minus(vector_at(c.directions, 0, 6), parallel)), 1e-12L);
        }
    }
}

// z = u v: at the origin +1 along the diagonal, -1 across it.
TEST(Curvature, the_saddle) {
    const SplineData saddle = {
        {1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1}, {}, 0};
    const auto c = surface_curvatures(create(saddle).get(), {0, 0});
    const double h = std::sqrt(0.5);
    EXPECT_NEAR(c.principal[0], 1, 4e-16);
    EXPECT_NEAR(c.principal[1], -1, 4e-16);
    EXPECT_NEAR(c.gaussian[0], -1, 4e-16);
    EXPECT_NEAR(c.mean[0], 0, 4e-16);
    EXPECT_LE(norm(minus(vector_at(c.directions, 0, 6), {h, h, 0})), 4 * eps);
    EXPECT_LE(norm(minus(vector_at(c.directions, 0, 6, 3), {-h, h, 0})), 4 * eps);
    EXPECT_EQ(c.status[0], 0);
}

// d1 is perpendicular to S_u: the larger curvature lies along axis 1. z = v^2 / 2 over [0, 1].
TEST(Curvature, directions_point_along_the_parameters) {
    const SplineData sheet = {{1, 2},
                              {2, 3},
                              {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}},
                              3,
                              {0, 0, 0, 0, 0.5, 0, 0, 1, 0.5, 1, 0, 0, 1, 0.5, 0, 1, 1, 0.5},
                              {},
                              0};
    const auto c = surface_curvatures(create(sheet).get(), {0.5, 0});
    EXPECT_EQ(c.principal, (std::vector<double>{1, 0}));
    EXPECT_EQ(c.directions, (std::vector<double>{0, 1, 0, -1, 0, 0}));
    const auto t = surface_curvatures(create(transposed(sheet)).get(), {0, 0.5}); // the normal turned over
    EXPECT_EQ(t.principal, (std::vector<double>{0, -1}));
    EXPECT_EQ(t.directions, (std::vector<double>{1, 0, 0, 0, -1, 0}));
}

TEST(Curvature, undefined_where_there_is_no_regular_normal) {
    const auto g = create(revolved(half_circle(1, 0)));
    const auto c = surface_curvatures(g.get(), {0.3, 0, 7, 0.5}, NURBS_ON_ALL_AXES(2, NURBS_NAN));
    for (const double value : c.principal) {
        EXPECT_TRUE(std::isnan(value));
    }
    for (const double value : c.directions) {
        EXPECT_TRUE(std::isnan(value));
    }
    EXPECT_TRUE(std::isnan(c.mean[0]) && std::isnan(c.gaussian[1]));
    EXPECT_EQ(c.status, (std::vector<int32_t>{NURBS_FRAME_UNDEFINED, NURBS_FRAME_UNDEFINED}));
}

struct Exact {
    std::array<Vector, 6> d{};
    std::array<long double, 6> error{};
};

Exact exact_at(const SplineData &data, const double *param) {
    const auto derivs = reference::exact_derivatives(data, 2, param);
    const auto sizes = reference::magnitudes(data, 2, param);
    Exact exact;
    for (size_t slot = 1; slot < 6; ++slot) {
        Vector size{};
        for (size_t c = 0; c < 3; ++c) {
            exact.d[slot][c] = reference::quotient(derivs[slot][c].numerator, derivs[slot][c].denominator);
            size[c] = sizes[slot][c];
        }
        exact.error[slot] = 2 * (reference::c_of(data) + (slot < 3 ? 2 : 4)) * eps * norm(size);
    }
    return exact;
}

// The textbook formulas in long double on exact derivatives.
TEST(Curvature, agrees_with_exact_derivatives) {
    int compared = 0;
    for_each_case(810000, 1500, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, random.chance(10) ? 7 : 4);
        recipe.dim = 3;
        const auto data = random_spline(random, recipe);
        const auto param = away_from_underflow(random_params(random, data, 1));
        const Exact x = exact_at(data, param.data());
        const Vector &u = x.d[1];
        const Vector &v = x.d[2];
        const Vector product = cross(u, v);
        const long double noise = norm(u) * x.error[2] + x.error[1] * norm(v);
        const auto c = surface_curvatures(create(data).get(), param);
        const std::string place = where(seed, data) + "at " + hex(param);
        if (c.status[0] == NURBS_FRAME_UNDEFINED) {
            ASSERT_LE(norm(product), 2.1L * (noise + x.error[1] * x.error[2])) << place;
            return;
        }
        const Vector n = unit(product);
        const long double e = dot(u, u);
        const long double f = dot(u, v);
        const long double g = dot(v, v);
        const long double l = dot(x.d[3], n);
        const long double m = dot(x.d[4], n);
        const long double k = dot(x.d[5], n);
        const long double det = dot(product, product);
        const long double mean = (l * g - 2 * m * f + k * e) / (2 * det);
        const long double gaussian = (l * k - m * m) / det;
        // Each term of the mean with the errors of its factors.
        const long double turn = noise / norm(product);
        const long double size = ((x.error[3] + norm(x.d[3]) * turn) * g +
                                  2 * (x.error[4] + norm(x.d[4]) * turn) * norm(u) * norm(v) +
                                  (x.error[5] + norm(x.d[5]) * turn) * e) /
                                 det;
        const long double terms =
            (norm(x.d[3]) * g + 2 * norm(x.d[4]) * norm(u) * norm(v) + norm(x.d[5]) * e) / det;
        const long double bound = 8 * (size + terms * (turn + 8 * eps));
        if (bound > 0.01L * terms) {
            return; // the bound is of first order only
        }
        ++compared;
        // Nothing that is clearly no umbilic is taken for one.
        ASSERT_TRUE(c.status[0] == 0 || c.principal[0] - c.principal[1] <= 8 * bound) << place;
        const long double spread = std::sqrt(std::max(0.0L, mean * mean - gaussian));
        ASSERT_LE(std::fabs(c.mean[0] - mean), bound) << place;
        ASSERT_LE(std::fabs(c.gaussian[0] - gaussian), 4 * bound * terms) << place;
        const long double root = std::sqrt(8 * bound * terms); // of mean^2 - gaussian near umbilics
        ASSERT_LE(std::fabs(c.principal[0] - (mean + spread)),
                  bound + std::min(root, 8 * bound * terms / spread))
            << place;
        ASSERT_LE(std::fabs(c.principal[1] - (mean - spread)),
                  bound + std::min(root, 8 * bound * terms / spread))
            << place;
        const Vector d1 = vector_at(c.directions, 0, 6);
        const Vector d2 = vector_at(c.directions, 0, 6, 3);
        ASSERT_LE(std::fabs(norm(d1) - 1) + std::fabs(norm(d2) - 1) + std::fabs(dot(d1, d2)), 32 * eps)
            << place;
        ASSERT_LE(std::fabs(dot(d1, n)) + std::fabs(dot(d2, n)), 4 * turn + 32 * eps) << place;
        ASSERT_GE(dot(d1, u), -x.error[1] - 8 * eps * norm(u)) << place;
    });
    EXPECT_GT(compared, support::of_whole_run(800));
}

// The curvature in the direction d1 of the surface is k1: the normal curvature, second form over first form.
TEST(Curvature, directions_have_their_curvature) {
    for_each_case(820000, 400, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {AxisRecipe{random.whole(2, 4)}, AxisRecipe{random.whole(2, 4)}};
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const std::vector<double> param{random.between(data.lower(0), data.upper(0)),
                                        random.between(data.lower(1), data.upper(1))};
        const auto c = surface_curvatures(create(data).get(), param);
        const Exact x = exact_at(data, param.data());
        const Vector product = cross(x.d[1], x.d[2]);
        if (norm(product) < 1e-2L * norm(x.d[1]) * norm(x.d[2]) || c.status[0] != 0) {
            return;
        }
        const double size = std::max(std::fabs(c.principal[0]), std::fabs(c.principal[1]));
        for (size_t j = 0; j < 2; ++j) {
            const Vector d = vector_at(c.directions, 0, 6, 3 * j);
            const Vector n = unit(product);
            // d = a S_u + b S_v
            const long double a = dot(cross(d, x.d[2]), n) / norm(product);
            const long double b = dot(cross(x.d[1], d), n) / norm(product);
            const long double curvature =
                a * a * dot(x.d[3], n) + 2 * a * b * dot(x.d[4], n) + b * b * dot(x.d[5], n);
            ASSERT_LE(std::fabs(curvature - c.principal[j]), 1e-8 * size)
                << where(seed, data) << "at " << hex(param);
        }
    });
}

TEST(Curvature, scales_change_nothing) {
    for_each_case(830000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, 4);
        recipe.dim = 3;
        const auto data = random_spline(random, recipe);
        const auto params = random_params(random, data, 6);
        const double speed = std::ldexp(1, random.whole(-20, 20));
        const double size = std::ldexp(1, random.whole(-20, 20));
        std::vector<double> other_params = params;
        for (double &t : other_params) {
            t *= speed;
        }
        const auto a = surface_curvatures(create(data).get(), params);
        const auto b = surface_curvatures(create(scaled(data, size, speed)).get(), other_params);
        ASSERT_EQ(a.status, b.status) << where(seed, data) << hex(params);
        ASSERT_TRUE(same_bits(a.directions, b.directions)) << where(seed, data) << hex(params);
        for (size_t i = 0; i < a.principal.size(); ++i) {
            ASSERT_TRUE(same_bits(a.principal[i], b.principal[i] * size)) << where(seed, data);
        }
        for (size_t i = 0; i < 6; ++i) {
            const auto alone = surface_curvatures(create(data).get(), {params[2 * i], params[2 * i + 1]});
            ASSERT_EQ(alone.status[0], a.status[i]) << where(seed, data);
            ASSERT_TRUE(same_bits(alone.principal[0], a.principal[2 * i])) << where(seed, data);
        }
    });
}

} // namespace

} // namespace curvature_test
