// Unit normals of surfaces against exact derivatives, closed forms, and what must not change them.
#include "property/surface_normals.h"

namespace surface_frames_test {

using namespace surface_normals;

namespace {

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

} // namespace surface_frames_test
