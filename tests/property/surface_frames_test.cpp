// Unit normals of surfaces against exact derivatives: regular ones to their bound, limits at poles, collapsed
// edges and corners by the exact expansion of S_u x S_v.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace support;
using reference::eps;
using reference::Rational;

namespace {

using ExactVector = std::array<Rational, 3>;

Rational rational(const reference::Fraction &x) {
    return Rational(x.numerator, x.denominator);
}

ExactVector exact_vector(const std::vector<reference::Fraction> &x) {
    return {rational(x[0]), rational(x[1]), rational(x[2])};
}

ExactVector exact_cross(const ExactVector &a, const ExactVector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const ExactVector &a) {
    return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

long double approximate(const Rational &x) {
    return x == 0 ? 0.0L : reference::quotient(numerator(x), denominator(x));
}

Vector approximate(const ExactVector &x) {
    return {approximate(x[0]), approximate(x[1]), approximate(x[2])};
}

// The quotients by the largest coordinate, so that no size leaves the range.
Vector direction(const ExactVector &x) {
    const Rational size = std::max({Rational(abs(x[0])), Rational(abs(x[1])), Rational(abs(x[2]))});
    return unit(approximate({x[0] / size, x[1] / size, x[2] / size}));
}

Vector magnitude(const std::vector<long double> &x) {
    return {x[0], x[1], x[2]};
}

struct Exact {
    ExactVector product; // S_u x S_v
    Vector du;
    Vector dv;
    long double error_u; // the header's bounds of the rounding errors
    long double error_v;
    [[nodiscard]] long double noise() const { return norm(du) * error_v + error_u * (norm(dv) + error_v); }
};

Exact exact_at(const SplineData &data, const double *param, reference::Sides left = {}) {
    const auto derivs = reference::exact_derivatives(data, 1, param, left);
    const auto sizes = reference::magnitudes(data, 1, param, left);
    const long double factor = 2 * (reference::c_of(data) + 2) * eps;
    const ExactVector du = exact_vector(derivs[1]);
    const ExactVector dv = exact_vector(derivs[2]);
    return {exact_cross(du, dv), approximate(du), approximate(dv), factor * norm(magnitude(sizes[1])),
            factor * norm(magnitude(sizes[2]))};
}

Recipe surface_recipe(Random &random, int max_degree) {
    Recipe recipe = random_recipe(random, 2, max_degree);
    recipe.dim = 3;
    return recipe;
}

TEST(SurfaceFrames, regular_normals_keep_their_bound) {
    long double worst = 0;
    for_each_case(600000, 1500, [&](Random &random, uint64_t seed) {
        const auto data = random_spline(random, surface_recipe(random, random.chance(10) ? 9 : 4));
        const auto g = create(data);
        const auto params = away_from_underflow(random_params(random, data, 4));
        const auto frames = surface_frames(g.get(), params);
        for (size_t i = 0; i < 4; ++i) {
            const Exact exact = exact_at(data, params.data() + 2 * i);
            const long double size = norm(approximate(exact.product));
            const std::string place = where(seed, data) + "at " + hex({params[2 * i], params[2 * i + 1]});
            if (frames.status[i] != 0) {
                // Nothing that is clearly regular is taken for degenerate.
                ASSERT_LE(size, 2.1L * exact.noise()) << place;
                continue;
            }
            ASSERT_FALSE(is_zero(exact.product)) << place;
            const long double bound = exact.noise() / size + 4 * eps;
            const long double error = norm(minus(vector_at(frames.normals, i), direction(exact.product)));
            worst = std::max(worst, error / bound);
            ASSERT_LE(error, 2 * bound) << place;
        }
    });
    std::printf("regular normals: largest error %.3Lf of the bound\n", worst);
}

// The bound of the error of N_10 (axis 0) or N_01: two products of a first and a second derivative.
long double term_noise(const SplineData &data, const double *param, int axis, reference::Sides left) {
    const auto derivs = reference::exact_derivatives(data, 2, param, left);
    const auto sizes = reference::magnitudes(data, 2, param, left);
    const auto product = [&](size_t first, size_t second) {
        const long double c = reference::c_of(data);
        const long double e1 = 2 * (c + 2) * eps * norm(magnitude(sizes[first]));
        const long double e2 = 2 * (c + 4) * eps * norm(magnitude(sizes[second]));
        return norm(approximate(exact_vector(derivs[first]))) * e2 +
               e1 * (norm(approximate(exact_vector(derivs[second]))) + e2);
    };
    return axis == 0 ? product(2, 3) + product(1, 4) : product(2, 4) + product(1, 5);
}

// Exact expansion: N_ij for i + j = d, in s, t that run along the given sides.
std::vector<ExactVector> exact_terms(const SplineData &data, const double *param, int d, int side_u,
                                     int side_v) {
    const auto derivs = reference::exact_derivatives(data, d + 1, param, {side_u < 0, side_v < 0});
    const auto taylor = [&](int i, int j) {
        ExactVector x = exact_vector(derivs[static_cast<size_t>(slot_of({i, j}))]);
        Rational factor = ((side_u < 0 ? i : 0) + (side_v < 0 ? j : 0)) % 2 == 0 ? 1 : -1;
        for (int k = 2; k <= std::max(i, j); ++k) {
            factor /= (k <= i ? k : 1) * (k <= j ? k : 1);
        }
        return ExactVector{factor * x[0], factor * x[1], factor * x[2]};
    };
    std::vector<ExactVector> terms;
    for (int j = 0; j <= d; ++j) {
        ExactVector sum{};
        for (int a = 0; a <= d - j; ++a) {
            for (int b = 0; b <= j; ++b) {
                const ExactVector product = exact_cross(taylor(a + 1, b), taylor(d - j - a, j - b + 1));
                for (size_t c = 0; c < 3; ++c) {
                    sum[c] += (a + 1) * (j - b + 1) * side_u * side_v * product[c];
                }
            }
        }
        terms.push_back(sum);
    }
    return terms;
}

// All layers of points at one end of an axis become one point, so that the edge collapses.
void collapse(SplineData &data, int axis, bool at_end) {
    const int64_t m = data.counts[0];
    const int64_t n = data.counts[1];
    for (int64_t i = 0; i < (axis == 0 ? n : m); ++i) {
        const int64_t layer = at_end ? (axis == 0 ? m : n) - 1 : 0;
        const int64_t at = axis == 0 ? layer * n + i : i * n + layer;
        for (int c = 0; c < 3; ++c) {
            data.points[static_cast<size_t>(3 * at + c)] = 0.125 * (c + 1);
        }
    }
}

// Whichever edge collapses: the limit is the exact lowest term, across the edge.
TEST(SurfaceFrames, collapsed_edges_have_the_exact_limit) {
    long double worst = 0;
    int limits = 0;
    for_each_case(610000, 1000, [&](Random &random, uint64_t seed) {
        Recipe recipe = surface_recipe(random, 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.degree = std::max(axis.degree, 1);
            axis.form = KnotForm::clamped;
            axis.placement = random.chance(50) ? Placement::origin : Placement::small;
            axis.spacing = random.chance(50) ? Spacing::full : Spacing::few_bits;
        }
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        auto data = random_spline(random, recipe);
        const int axis = random.whole(0, 1);
        const bool at_end = random.chance(50);
        collapse(data, axis, at_end);
        std::vector<double> param = random_params(random, data, 1);
        const auto k = static_cast<size_t>(axis);
        param[k] = at_end ? data.upper(axis) : data.lower(axis);
        const std::string place = where(seed, data) + "at " + hex(param);
        const auto frames = surface_frames(create(data).get(), param);
        ASSERT_TRUE(is_zero(exact_at(data, param.data()).product)) << place;
        ASSERT_NE(frames.status[0], 0) << place;
        const int other_side = param[1 - k] < data.upper(1 - axis) ? 1 : -1;
        const int side = at_end ? -1 : 1;
        const auto terms =
            exact_terms(data, param.data(), 1, axis == 0 ? side : other_side, axis == 0 ? other_side : side);
        const ExactVector &lowest = terms[axis == 0 ? 0 : 1];
        if (frames.status[0] == NURBS_FRAME_LIMIT && !is_zero(lowest)) {
            const long double error = norm(minus(vector_at(frames.normals, 0), direction(lowest)));
            const reference::Sides left{axis == 0 && at_end, axis == 1 && at_end};
            const long double bound =
                term_noise(data, param.data(), axis, left) / norm(approximate(lowest)) + 4 * eps;
            worst = std::max(worst, error / bound);
            ++limits;
            ASSERT_LE(error, bound) << place;
        }
    });
    std::printf("collapsed edges: %d limits, largest error %.3Lf of the bound\n", limits, worst);
    EXPECT_GT(limits, 900);
}

// Poles of spheres made by revolving, at every longitude, from every side, at several sizes and speeds.
TEST(SurfaceFrames, poles_of_a_sphere_are_exact_to_rounding) {
    long double worst = 0;
    for (const double size : {1.0, 1e-6, 1e6, 3.7}) {
        for (const double speed : {1.0, 1e-9, 1e9}) {
            const auto sphere = scaled(revolved(half_circle(1, 0)), size, speed);
            const auto g = create(sphere);
            Random random(620000);
            for (int i = 0; i < 400; ++i) {
                const double u = i < 9 ? i / 8.0 : random.unit();
                const double v = i % 2;
                for (const uint32_t flags : {0U, NURBS_ON_ALL_AXES(2, NURBS_LEFT)}) {
                    const auto frames = surface_frames(g.get(), {u * speed, v * speed}, flags);
                    ASSERT_EQ(frames.status[0], NURBS_FRAME_LIMIT) << u << " " << v;
                    const Vector pole = {0, 0, v > 0.5 ? 1.0L : -1.0L};
                    const long double error = norm(minus(vector_at(frames.normals, 0), pole));
                    worst = std::max(worst, error);
                    ASSERT_LE(error, 4 * eps) << "size " << size << " speed " << speed << " at " << u;
                }
            }
        }
    }
    std::printf("poles: largest error %.3Lf eps\n", worst / eps);
}

// Away from the pole by a whole range of distances; the error is the rounding of S_u over its length.
TEST(SurfaceFrames, normals_near_a_pole_approach_it) {
    const auto g = create(revolved(half_circle(1, 0)));
    for (double distance = 0.1; distance > 1e-17; distance /= 3) {
        for (const double u : {0.0, 0.1, 0.25, 0.6, 0.99}) {
            const auto frames = surface_frames(g.get(), {u, distance});
            const Vector point = vector_at(frames.points, 0);
            ASSERT_LE(norm(minus(vector_at(frames.normals, 0), point)), 1e-13L / distance + 8 * eps)
                << u << " " << distance;
            ASSERT_LE(norm(minus(vector_at(frames.normals, 0), point)), 0.5L) << u << " " << distance;
        }
    }
}

TEST(SurfaceFrames, a_sphere_away_from_the_origin) {
    const auto g = create(moved(revolved(half_circle(1, 0)), {1000, -2000, 500}));
    for (const double u : {0.0, 0.1, 0.25, 0.6}) {
        const auto frames = surface_frames(g.get(), {u, 0, u, 1, u, 0.3});
        EXPECT_EQ(frames.status, (std::vector<int32_t>{NURBS_FRAME_LIMIT, NURBS_FRAME_LIMIT, 0}));
        EXPECT_LE(norm(minus(vector_at(frames.normals, 0), {0, 0, -1})), 1e-11L);
        EXPECT_LE(norm(minus(vector_at(frames.normals, 1), {0, 0, 1})), 1e-11L);
    }
}

TEST(SurfaceFrames, sphere_torus_and_cylinder) {
    const auto sphere = create(revolved(half_circle(2, 0)));
    const auto torus = create(revolved(full_circle(1, 3)));
    const auto cylinder = create(revolved({{1}, {2}, {{0, 0, 1, 1}}, 2, {2, 0, 2, 5}, {}, 0}));
    Random random(630000);
    for (int i = 0; i < 2000; ++i) {
        const std::vector<double> param{random.unit(), random.between(0.01, 0.99)};
        const auto s = surface_frames(sphere.get(), param);
        EXPECT_LE(norm(minus(vector_at(s.normals, 0), times(0.5L, vector_at(s.points, 0)))), 1e-13L);
        const auto t = surface_frames(torus.get(), param);
        const Vector p = vector_at(t.points, 0);
        const long double r = std::hypot(p[0], p[1]);
        EXPECT_LE(norm(minus(vector_at(t.normals, 0), {p[0] - 3 * p[0] / r, p[1] - 3 * p[1] / r, p[2]})),
                  1e-14L);
        const auto c = surface_frames(cylinder.get(), param);
        const Vector q = vector_at(c.points, 0);
        EXPECT_LE(norm(minus(vector_at(c.normals, 0), {q[0] / 2, q[1] / 2, 0})), 8 * eps);
        EXPECT_EQ(s.status[0] | t.status[0] | c.status[0], 0);
    }
}

// The normal of a cone at its apex is that of the ruling through the same u.
TEST(SurfaceFrames, a_cone_has_the_normal_of_the_ruling) {
    const auto g = create(revolved({{1}, {2}, {{0, 0, 1, 1}}, 2, {0, 0, 3, 4}, {}, 0}));
    for (const double u : {0.0, 0.1, 0.2, 0.25, 0.5, 0.77, 1.0}) {
        const auto frames = surface_frames(g.get(), {u, 0, u, 0.5});
        EXPECT_EQ(frames.status, (std::vector<int32_t>{NURBS_FRAME_LIMIT, 0}));
        EXPECT_LE(norm(minus(vector_at(frames.normals, 0), vector_at(frames.normals, 1))), 8 * eps);
        EXPECT_NEAR(frames.normals[2], -0.6, 8 * static_cast<double>(eps));
    }
}

// Bilinear patches S = u a + v b + u v (0, 1, 0) with parallel S_u = a and S_v = b at the corner: the square
// there is flat (N_z = u + v), or folded over (N_z = u - v).
TEST(SurfaceFrames, corners_of_plane_patches) {
    const auto corner = [](double b) {
        const SplineData data = {
            {1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, b, 0, 0, 1, 0, 0, 1 + b, 1, 0}, {}, 0};
        return surface_frames(create(data).get(), {0, 0});
    };
    const auto flat = corner(-1);
    EXPECT_EQ(flat.status[0], NURBS_FRAME_LIMIT);
    EXPECT_EQ(flat.normals, (std::vector<double>{0, 0, 1}));
    EXPECT_EQ(corner(1).status[0], NURBS_FRAME_UNDEFINED);
}

// (u + v, 3 u^2 + 4 u v + v^2, 0) has parallel derivatives at the corner and N_z = -2 u - 2 v + ...: second
// derivatives enter with their factors.
TEST(SurfaceFrames, a_curved_corner_of_a_plane_patch) {
    SplineData data = {{2, 2}, {3, 3}, {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
    for (int i = 0; i <= 2; ++i) {
        for (int j = 0; j <= 2; ++j) {
            const double y = (i == 2 ? 3 : 0) + i * j + (j == 2 ? 1 : 0);
            data.points.insert(data.points.end(), {(i + j) / 2.0, y, 0});
        }
    }
    const auto frames = surface_frames(create(data).get(), {0, 0, 0.01, 0.02});
    EXPECT_EQ(frames.status, (std::vector<int32_t>{NURBS_FRAME_LIMIT, 0}));
    EXPECT_EQ(frames.normals[2], -1);
    EXPECT_EQ(frames.normals[5], -1);
}

// S = (u^2, v^2, 0): S_u x S_v = 4 u v (0, 0, 1). At the inner zero the normal depends on the side.
TEST(SurfaceFrames, squares_have_one_sided_normals) {
    // (2 u - 1)^2 and v^2 over [0, 1] as Bezier patches.
    SplineData data = {{2, 2}, {3, 3}, {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
    for (const double x : {1.0, -1.0, 1.0}) {
        for (const double y : {0.0, 0.0, 1.0}) {
            data.points.insert(data.points.end(), {x, y, 0});
        }
    }
    const auto g = create(data);
    const auto right = surface_frames(g.get(), {0.5, 0});
    const auto left = surface_frames(g.get(), {0.5, 0}, NURBS_LEFT);
    EXPECT_EQ(right.status[0], NURBS_FRAME_LIMIT);
    EXPECT_EQ(right.normals[2], 1);
    EXPECT_EQ(left.status[0], NURBS_FRAME_LIMIT);
    EXPECT_EQ(left.normals[2], -1);
}

TEST(SurfaceFrames, kinks_have_two_normals) {
    // A roof: z = min(u, 2 - u).
    const SplineData roof = {{1, 1},
                             {3, 2},
                             {{0, 0, 1, 2, 2}, {0, 0, 1, 1}},
                             3,
                             {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0},
                             {},
                             0};
    const auto g = create(roof);
    const auto right = surface_frames(g.get(), {1, 0.5});
    const auto left = surface_frames(g.get(), {1, 0.5}, NURBS_LEFT);
    const double h = std::sqrt(0.5);
    EXPECT_LE(norm(minus(vector_at(right.normals, 0), {h, 0, h})), 2 * eps);
    EXPECT_LE(norm(minus(vector_at(left.normals, 0), {-h, 0, h})), 2 * eps);
}

TEST(SurfaceFrames, where_there_is_no_limit) {
    const auto undefined = [](const SplineData &data, const std::vector<double> &param) {
        const auto frames = surface_frames(create(data).get(), param);
        return frames.status[0] == NURBS_FRAME_UNDEFINED && std::isnan(frames.normals[0]) &&
               std::isnan(frames.normals[1]) && std::isnan(frames.normals[2]) &&
               std::isfinite(frames.points[0]);
    };
    // A curve run through twice, a point, a step, and a corner whose two edges leave in one direction while
    // the surface turns around it.
    const SplineData line = {
        {1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2}, {}, 0};
    const SplineData point = {
        {1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3}, {}, 0};
    const SplineData step = {{0, 1}, {1, 2}, {{0, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 1, 0, 0}, {}, 0};
    SplineData corner = {{2, 2}, {3, 3}, {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
    corner.points = {0, 0, 0, 1, 0, 0, 2, 1, 0, 1, 0, 0, 1, 1, 2, 3, 1, 0, 2, 0, 1, 2, 2, 1, 3, 3, 3};
    EXPECT_TRUE(undefined(line, {0.25, 0.5}));
    EXPECT_TRUE(undefined(point, {0.25, 0.5}));
    EXPECT_TRUE(undefined(step, {0.25, 0.5}));
    EXPECT_TRUE(undefined(corner, {0, 0}));
    EXPECT_FALSE(undefined(corner, {0.5, 0.5}));
}

TEST(SurfaceFrames, parameters_that_give_nan) {
    const auto g = create(revolved(full_circle(1, 3)));
    const auto frames = surface_frames(g.get(), {0.5, 0.5, 7, 0.5}, NURBS_ON_ALL_AXES(2, NURBS_NAN));
    EXPECT_EQ(frames.status, (std::vector<int32_t>{0, NURBS_FRAME_UNDEFINED}));
    EXPECT_TRUE(std::isnan(frames.normals[3]) && std::isnan(frames.points[3]) && std::isnan(frames.du[3]));
}

// One parameter, the same bits: alone (where the bounds of the whole spline do not pay), in a batch, on a
// grid, and as nurbs_eval_derivs() gives them.
TEST(SurfaceFrames, same_bits_alone_in_a_batch_and_on_a_grid) {
    for_each_case(640000, 150, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, surface_recipe(random, 4));
        const auto g = create(data);
        std::vector<std::vector<double>> axes(2);
        for (int k = 0; k < 2; ++k) {
            for (int i = random.whole(1, 12); i > 0; --i) {
                axes[static_cast<size_t>(k)].push_back(random_param(
                    random, data.knots[static_cast<size_t>(k)], data.degrees[static_cast<size_t>(k)]));
            }
        }
        std::vector<double> params;
        for (const double u : axes[0]) {
            for (const double v : axes[1]) {
                params.insert(params.end(), {u, v});
            }
        }
        const auto batch = surface_frames(g.get(), params);
        const auto grid = surface_grid_frames(g.get(), axes);
        const auto derivs = eval_derivs(g.get(), 1, params);
        ASSERT_TRUE(same_bits(batch.points, grid.points) && same_bits(batch.du, grid.du) &&
                    same_bits(batch.dv, grid.dv) && same_bits(batch.normals, grid.normals) &&
                    batch.status == grid.status)
            << where(seed, data);
        for (size_t i = 0; i < batch.status.size(); ++i) {
            const auto alone = surface_frames(g.get(), {params[2 * i], params[2 * i + 1]});
            ASSERT_EQ(alone.status[0], batch.status[i]) << where(seed, data);
            for (size_t c = 0; c < 3; ++c) {
                ASSERT_TRUE(same_bits(alone.normals[c], batch.normals[3 * i + c])) << where(seed, data);
                ASSERT_TRUE(same_bits(batch.points[3 * i + c], derivs[9 * i + c])) << where(seed, data);
                ASSERT_TRUE(same_bits(batch.du[3 * i + c], derivs[9 * i + 3 + c])) << where(seed, data);
                ASSERT_TRUE(same_bits(batch.dv[3 * i + c], derivs[9 * i + 6 + c])) << where(seed, data);
            }
        }
    });
}

// Powers of two are exact: sizes and speeds change no bit of a normal, and no decision.
TEST(SurfaceFrames, scales_change_nothing) {
    for_each_case(650000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = surface_recipe(random, 4);
        auto data = random_spline(random, recipe);
        if (random.chance(30)) {
            collapse(data, random.whole(0, 1), random.chance(50));
            data.flags = 0;
        }
        const auto params = random_params(random, data, 6);
        const double speed = std::ldexp(1, random.whole(-30, 30));
        std::vector<double> other_params = params;
        for (double &t : other_params) {
            t *= speed;
        }
        const auto other = scaled(data, std::ldexp(1, random.whole(-20, 20)), speed);
        const auto a = surface_frames(create(data).get(), params);
        const auto b = surface_frames(create(other).get(), other_params);
        ASSERT_TRUE(same_bits(a.normals, b.normals)) << where(seed, data) << hex(params);
        ASSERT_EQ(a.status, b.status) << where(seed, data) << hex(params);
    });
}

TEST(SurfaceFrames, exchanged_axes_turn_the_normal_over) {
    for_each_case(660000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, surface_recipe(random, 4));
        const auto param = random_params(random, data, 1);
        const auto a = surface_frames(create(data).get(), param);
        const auto b = surface_frames(create(transposed(data)).get(), {param[1], param[0]});
        const Exact exact = exact_at(data, param.data());
        if (a.status[0] != 0 || b.status[0] != 0) {
            return; // on the border of the noise the order of the sums may decide
        }
        const long double bound = 4 * exact.noise() / norm(approximate(exact.product)) + 8 * eps;
        ASSERT_LE(norm(minus(vector_at(a.normals, 0), times(-1, vector_at(b.normals, 0)))), bound)
            << where(seed, data) << "at " << hex(param);
    });
}

} // namespace
