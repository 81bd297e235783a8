// Normals of surfaces where S_u x S_v vanishes: poles, collapsed edges and corners by the exact expansion,
// one side or the other, and where there is no limit.
#include "property/surface_normals.h"

namespace surface_limits_test {

using namespace surface_normals;

namespace {

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

// Whichever edge collapses: the limit is the exact lowest term, across the edge.
TEST(SurfaceLimits, collapsed_edges_have_the_exact_limit) {
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
    EXPECT_GT(limits, support::of_whole_run(900));
}

// Poles of spheres made by revolving, at every longitude, from every side, at several sizes and speeds.
TEST(SurfaceLimits, poles_of_a_sphere_are_exact_to_rounding) {
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
TEST(SurfaceLimits, normals_near_a_pole_approach_it) {
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

TEST(SurfaceLimits, a_sphere_away_from_the_origin) {
    const auto g = create(moved(revolved(half_circle(1, 0)), {1000, -2000, 500}));
    for (const double u : {0.0, 0.1, 0.25, 0.6}) {
        const auto frames = surface_frames(g.get(), {u, 0, u, 1, u, 0.3});
        EXPECT_EQ(frames.status, (std::vector<int32_t>{NURBS_FRAME_LIMIT, NURBS_FRAME_LIMIT, 0}));
        EXPECT_LE(norm(minus(vector_at(frames.normals, 0), {0, 0, -1})), 1e-11L);
        EXPECT_LE(norm(minus(vector_at(frames.normals, 1), {0, 0, 1})), 1e-11L);
    }
}

// The normal of a cone at its apex is that of the ruling through the same u.
TEST(SurfaceLimits, a_cone_has_the_normal_of_the_ruling) {
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
TEST(SurfaceLimits, corners_of_plane_patches) {
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
TEST(SurfaceLimits, a_curved_corner_of_a_plane_patch) {
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
    EXPECT_NEAR(frames.normals[5], -1, 0x1p-52); // of a regular point: the square root of a rounded square
}

// S = (u^2, v^2, 0): S_u x S_v = 4 u v (0, 0, 1). At the inner zero the normal depends on the side.
TEST(SurfaceLimits, squares_have_one_sided_normals) {
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

TEST(SurfaceLimits, kinks_have_two_normals) {
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

TEST(SurfaceLimits, where_there_is_no_limit) {
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

} // namespace

} // namespace surface_limits_test
