// Rotation-minimizing frames: closed forms on plane curves, the rotation against the Frenet frame in space,
// and the order of convergence.
#include "support/cases.h"
#include "support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace minimal_frames_test {

using namespace support;

namespace {

constexpr long double eps = 0x1p-52L;

std::vector<double> even_params(int n, double lower = 0, double upper = 1) {
    std::vector<double> params;
    for (int i = 0; i < n; ++i) {
        params.push_back(i + 1 == n ? upper : lower + (upper - lower) * i / (n - 1));
    }
    return params;
}

// (3 t, 3 t^2, 3 t^3)
SplineData twisted_cubic() {
    return {{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 3, {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 3}, {}, 0};
}

// A full circle of radius 2 in the plane z = 1.
SplineData circle() {
    const auto flat = full_circle(2, 0);
    SplineData data = flat;
    data.dim = 3;
    data.points.clear();
    for (int64_t i = 0; i < 9; ++i) {
        data.points.insert(data.points.end(), {flat.coordinate(i, 0), flat.coordinate(i, 1), 1});
    }
    return data;
}

void expect_orthonormal(const CurveFrames &f, size_t i) {
    const Vector t = vector_at(f.tangents, i);
    const Vector n = vector_at(f.normals, i);
    const Vector b = vector_at(f.binormals, i);
    EXPECT_LE(std::fabs(norm(t) - 1) + std::fabs(norm(n) - 1), 8 * eps);
    EXPECT_LE(std::fabs(dot(t, n)), 4 * eps);
    EXPECT_LE(norm(minus(b, cross(t, n))), 4 * eps);
}

// On a plane curve the normal of the plane stays, and so does the angle to the curve's own normal, whatever
// the step.
TEST(MinimalFrames, plane_curves) {
    const auto g = create(circle());
    for (const int n : {5, 17, 1000}) {
        const auto up = minimal_frames(g.get(), even_params(n), {{0, 0, 5}});
        const auto inwards = minimal_frames(g.get(), even_params(n), {{-1, 0, 0}});
        for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
            const Vector p = vector_at(up.points, i);
            const long double bound = (8 + static_cast<long double>(i)) * 4 * eps;
            EXPECT_LE(norm(minus(vector_at(up.normals, i), {0, 0, 1})), bound);
            EXPECT_LE(norm(minus(vector_at(inwards.normals, i), {-p[0] / 2, -p[1] / 2, 0})), bound);
            expect_orthonormal(up, i);
            EXPECT_EQ(up.status[i], 0);
        }
    }
}

// N = cos a N_Frenet + sin a B_Frenet with a' = -torsion |C'|; Simpson's rule on a fine grid is the judge.
long double largest_error(int n) {
    const auto g = create(twisted_cubic());
    const auto start = curve_frames(g.get(), {0});
    const auto frames =
        minimal_frames(g.get(), even_params(n), {{start.normals[0], start.normals[1], start.normals[2]}});
    const auto frenet = curve_frames(g.get(), even_params(n));
    const auto rate = [](long double t) {
        const long double a = 1 + 9 * t * t + 9 * t * t * t * t;
        const long double b = 1 + 4 * t * t + 9 * t * t * t * t;
        return -3 * std::sqrt(b) / a; // -(1 / a) |C'|, C' = 3 (1, 2 t, 3 t^2)
    };
    long double angle = 0;
    long double worst = 0;
    for (size_t i = 1; i < static_cast<size_t>(n); ++i) {
        constexpr int steps = 200;
        const long double h = 1.0L / (n - 1) / steps;
        for (int j = 0; j < steps; ++j) {
            const long double t = static_cast<long double>(i - 1) / (n - 1) + j * h;
            angle += h / 6 * (rate(t) + 4 * rate(t + h / 2) + rate(t + h));
        }
        const Vector normal = vector_at(frenet.normals, i);
        const Vector binormal = vector_at(frenet.binormals, i);
        const Vector exact = minus(times(std::cos(angle), normal), times(-std::sin(angle), binormal));
        worst = std::max(worst, norm(minus(vector_at(frames.normals, i), exact)));
    }
    return worst;
}

TEST(MinimalFrames, the_error_falls_with_the_fourth_power_of_the_step) {
    long double before = largest_error(9);
    EXPECT_LE(before, 1e-3L);
    for (const int n : {17, 33, 65, 129}) {
        const long double error = largest_error(n);
        std::printf("%d points: error %.3Lg, ratio %.3Lf\n", n, error, before / error);
        EXPECT_GE(before / error, 13);
        EXPECT_LE(before / error, 19);
        before = error;
    }
}

// A curve run forth and back ends with the normal that it began with: each step is its own inverse reversed.
TEST(MinimalFrames, forth_and_back) {
    for_each_case(900000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {AxisRecipe{random.whole(2, 5)}};
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        auto params = even_params(200, data.lower(0), data.upper(0));
        params.insert(params.end(), params.rbegin(), params.rend());
        const auto f = minimal_frames(create(data).get(), params);
        for (size_t i = 0; i < params.size(); ++i) {
            ASSERT_EQ(f.status[i], 0) << where(seed, data);
            expect_orthonormal(f, i);
        }
        ASSERT_LE(norm(minus(vector_at(f.normals, 0), vector_at(f.normals, params.size() - 1))), 1e-9L)
            << where(seed, data);
    });
}

TEST(MinimalFrames, the_default_is_across_the_smallest_coordinate) {
    const auto f = minimal_frames(create(twisted_cubic()).get(), {0, 0.5}); // T = (1, 0, 0)
    EXPECT_EQ(std::vector<double>(f.normals.begin(), f.normals.begin() + 3), (std::vector<double>{0, 1, 0}));
}

// A first normal that is nearly the tangent still gives a frame.
TEST(MinimalFrames, a_slanting_first_normal) {
    const auto g = create(circle());
    for (const double slant : {1.0, 1e-4, 1e-8, 1e-12}) {
        const auto f = minimal_frames(g.get(), {0.1, 0.2}, {{-0.5, 0.3, slant}});
        const auto t = vector_at(f.tangents, 0);
        const auto near = minimal_frames(g.get(), {0.1, 0.2},
                                         {{static_cast<double>(t[0]), static_cast<double>(t[1]), slant}});
        expect_orthonormal(f, 0);
        expect_orthonormal(near, 0);
        EXPECT_NEAR(near.normals[2], 1, 1e-3);
    }
}

TEST(MinimalFrames, repeated_parameters_repeat_the_frame) {
    const auto g = create(twisted_cubic());
    const auto once = minimal_frames(g.get(), {0, 0.25, 0.5, 1});
    const auto twice = minimal_frames(g.get(), {0, 0, 0.25, 0.25, 0.25, 0.5, 1});
    const size_t places[] = {0, 0, 1, 1, 1, 2, 3};
    for (size_t i = 0; i < 7; ++i) {
        EXPECT_LE(norm(minus(vector_at(twice.normals, i), vector_at(once.normals, places[i]))), 16 * eps);
        expect_orthonormal(twice, i);
    }
}

// At a vertex of a polyline, seen from both sides, the tangent turns the shortest way: about z by 90 degrees,
// then about x.
TEST(MinimalFrames, kinks_turn_the_shortest_way) {
    const SplineData corner = {{1}, {4}, {{0, 0, 1, 2, 3, 3}}, 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1},
                               {},  0};
    const auto g = create(corner);
    const auto f = minimal_frames(g.get(), {0.5, 1, 1.5, 2, 2.5}, {{0, 0, 1}});
    const auto straight = minimal_frames(g.get(), {0.5, 0.75}, {{0, 1, 0}});
    EXPECT_EQ(vector_at(straight.normals, 1), (Vector{0, 1, 0}));
    const auto beside = minimal_frames(g.get(), {0.5, std::nextafter(1, 0), 1}, {{0, 1, 0}});
    EXPECT_LE(norm(minus(vector_at(beside.normals, 2), {-1, 0, 0})), 8 * eps);
    EXPECT_LE(norm(minus(vector_at(f.normals, 2), {0, 0, 1})), 8 * eps);
    EXPECT_LE(norm(minus(vector_at(f.normals, 4), {0, -1, 0})), 8 * eps);
}

TEST(MinimalFrames, cusps_and_parameters_that_give_nan) {
    const SplineData cusp = {{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 3, {0, 0, 0, 0, 0, 0, 1, 0, 1, 1, 2, 0},
                             {},  0};
    const auto f = minimal_frames(create(cusp).get(), {0, 7, 0.5, 1}, std::nullopt, NURBS_NAN);
    EXPECT_EQ(f.status, (std::vector<int32_t>{NURBS_FRAME_LIMIT, NURBS_FRAME_UNDEFINED, 0, 0}));
    EXPECT_TRUE(std::isnan(f.normals[3]));
    for (const size_t i : {0u, 2u, 3u}) {
        expect_orthonormal(f, i);
    }
}

TEST(MinimalFrames, scales_change_nothing) {
    const auto data = twisted_cubic();
    const auto a = minimal_frames(create(data).get(), even_params(50));
    for (const double size : {0x1p-20, 0x1p20}) {
        const auto b = minimal_frames(create(scaled(data, size, 0x1p-30)).get(), even_params(50, 0, 0x1p-30));
        EXPECT_TRUE(same_bits(a.normals, b.normals));
    }
}

} // namespace

} // namespace minimal_frames_test
