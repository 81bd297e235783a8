// Frenet frames, curvature and torsion of curves against exact derivatives and closed forms; limits at cusps,
// inflections and on straight lines.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/frames.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace curve_frames_test {

using namespace support;
using reference::eps;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The derivatives of orders 1 to 3, exact but for the rounding to long double, and the header's bounds of
// their errors.
struct Exact {
    std::array<Vector, 4> d{};
    std::array<long double, 4> error{};
    [[nodiscard]] Vector product() const { return cross(d[1], d[2]); }
    [[nodiscard]] long double noise() const {
        return norm(d[1]) * error[2] + error[1] * (norm(d[2]) + error[2]);
    }
};

Exact exact_at(const SplineData &data, double t) {
    const auto derivs = reference::exact_derivatives(data, 3, &t);
    const auto sizes = reference::magnitudes(data, 3, &t, reference::Terms::seen_from_o);
    Exact exact;
    for (size_t k = 1; k <= 3; ++k) {
        Vector size{};
        for (size_t c = 0; c < static_cast<size_t>(data.dim); ++c) {
            exact.d[k][c] = reference::quotient(derivs[k][c].numerator, derivs[k][c].denominator);
            size[c] = sizes[k][c];
        }
        exact.error[k] = 2 * (reference::c_of(data) + 2 * static_cast<long double>(k)) * eps * norm(size);
    }
    return exact;
}

Recipe curve_recipe(Random &random, int dim) {
    Recipe recipe = random_recipe(random, 1, random.chance(10) ? 9 : 5);
    recipe.dim = dim;
    for (AxisRecipe &axis : recipe.axes) { // 1e-17 to the power -6 would leave the range of squares
        axis.placement = axis.placement == Placement::small ? Placement::origin : axis.placement;
    }
    return recipe;
}

TEST(CurveFrames, regular_frames_in_space_keep_their_bounds) {
    long double worst = 0;
    for_each_case(700000, 2000, [&](Random &random, uint64_t seed) {
        const auto data = random_spline(random, curve_recipe(random, 3));
        const double t = away_from_underflow(random_params(random, data, 1))[0];
        const auto f = curve_frames(create(data).get(), {t});
        const Exact x = exact_at(data, t);
        const std::string place = where(seed, data) + "at " + hex(t);
        const long double area = norm(x.product());
        if (f.status[0] != 0) {
            ASSERT_TRUE(norm(x.d[1]) <= 2.1L * x.error[1] || area <= 2.1L * x.noise()) << place;
            return;
        }
        const long double along = x.error[1] / norm(x.d[1]) + 4 * eps;
        const long double across = x.noise() / area + 4 * eps;
        const Vector t_exact = unit(x.d[1]);
        const Vector b_exact = unit(x.product());
        const long double curvature = area / std::pow(norm(x.d[1]), 3.0L);
        const long double torsion = dot(b_exact, x.d[3]) / area;
        const long double torsion_bound =
            (x.error[3] + norm(x.d[3]) * across) / area + (std::fabs(torsion) + norm(x.d[3]) / area) * across;
        const long double errors[] = {
            norm(minus(vector_at(f.tangents, 0), t_exact)) / along,
            norm(minus(vector_at(f.binormals, 0), b_exact)) / across,
            norm(minus(vector_at(f.normals, 0), cross(b_exact, t_exact))) / (along + across),
            std::fabs(f.curvatures[0] / curvature - 1) / (across + 3 * along),
            f.torsions[0] == torsion ? 0 : std::fabs(f.torsions[0] - torsion) / torsion_bound};
        for (const long double error : errors) {
            worst = std::max(worst, error);
            ASSERT_LE(error, 2) << place << " kind " << &error - errors;
        }
    });
    std::printf("frames in space: largest error %.3Lf of the bound\n", worst);
}

TEST(CurveFrames, regular_frames_in_the_plane_keep_their_bounds) {
    for_each_case(710000, 1500, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, curve_recipe(random, 2));
        const double t = away_from_underflow(random_params(random, data, 1))[0];
        const auto f = curve_frames(create(data).get(), {t});
        const Exact x = exact_at(data, t);
        const std::string place = where(seed, data) + "at " + hex(t);
        const long double speed = norm(x.d[1]);
        if (f.status[0] != 0) {
            ASSERT_LE(speed, 2.1L * x.error[1]) << place;
            return;
        }
        const Vector t_exact = unit(x.d[1]);
        const long double along = x.error[1] / speed + 4 * eps;
        ASSERT_LE(std::hypot(f.tangents[0] - t_exact[0], f.tangents[1] - t_exact[1]), 2 * along) << place;
        ASSERT_EQ(f.normals, (std::vector<double>{-f.tangents[1], f.tangents[0]})) << place;
        const long double curvature = x.product()[2] / std::pow(speed, 3.0L);
        const long double bound = x.noise() / std::pow(speed, 3.0L) +
                                  3 * (std::fabs(curvature) + norm(x.d[2]) / speed / speed) * along;
        ASSERT_LE(std::fabs(f.curvatures[0] - curvature), 2 * bound) << place;
    });
}

// To rounding, however badly the vectors themselves are determined.
TEST(CurveFrames, frames_are_orthonormal) {
    for_each_case(750000, 2000, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, curve_recipe(random, 3));
        auto params = random_params(random, data, 3);
        params.push_back(data.upper(0) + random.magnitude(1, 1e3) * (data.upper(0) - data.lower(0)));
        const auto f = curve_frames(create(data).get(), params, NURBS_EXTRAPOLATE);
        for (size_t i = 0; i < params.size(); ++i) {
            if (f.status[i] != NURBS_FRAME_UNDEFINED) {
                const Vector t = vector_at(f.tangents, i);
                const Vector n = vector_at(f.normals, i);
                const Vector b = vector_at(f.binormals, i);
                ASSERT_LE(std::fabs(norm(t) - 1) + std::fabs(norm(n) - 1) + std::fabs(norm(b) - 1), 8 * eps)
                    << where(seed, data) << "at " << hex(params[i]);
                ASSERT_LE(std::fabs(dot(t, n)) + std::fabs(dot(t, b)), 8 * eps) << where(seed, data);
                ASSERT_LE(norm(minus(b, cross(t, n))), 8 * eps) << where(seed, data);
            }
        }
    });
}

TEST(CurveFrames, circles_have_curvature_one_over_r) {
    for (const double r : {1.0, 1e-6, 1e6, 3.7}) {
        for (const double speed : {1.0, 1e-9}) {
            auto data = full_circle(r, 0);
            data = scaled(data, 1, speed);
            const auto g = create(data);
            Random random(720000);
            for (int i = 0; i < 1000; ++i) {
                const auto f = curve_frames(g.get(), {random.unit() * speed});
                ASSERT_NEAR(f.curvatures[0] * r, 1, 64 * static_cast<double>(eps));
                ASSERT_NEAR(f.normals[0], -f.points[0] / r, 16 * static_cast<double>(eps));
                ASSERT_NEAR(f.normals[1], -f.points[1] / r, 16 * static_cast<double>(eps));
                ASSERT_EQ(f.status[0], 0);
            }
        }
    }
}

// The curve (a s^i, b s^j, c s^k) for s in [0, 1], or from -1 to 0, or from -1 to 1, as a Bezier curve of
// degree 6; coordinate j of the points is exact where powers are multiplied by binomials.
SplineData monomials(const std::array<int, 3> &powers, int dim, double lower, double upper) {
    SplineData data = {{6}, {7}, {std::vector<double>(14, lower)}, dim, {}, {}, 0};
    std::fill(data.knots[0].begin() + 7, data.knots[0].end(), upper);
    for (int j = 0; j < 7; ++j) {
        for (int c = 0; c < dim; ++c) {
            // The blossom of s^p at (lower, 6 - j times; upper, j times).
            const int p = powers[static_cast<size_t>(c)];
            double sum = 0;
            for (int i = 0; i <= p; ++i) {
                sum += static_cast<double>(binomial(j, i) * binomial(6 - j, p - i)) * std::pow(upper, i) *
                       std::pow(lower, p - i);
            }
            data.points.push_back(sum);
        }
    }
    return data;
}

// The factor that monomials() gives to s^p.
double factor(int p) {
    return static_cast<double>(binomial(6, p));
}

// T, N and B are coordinate axes at s = 0; from the left T is turned over where the lowest power is even.
TEST(CurveFrames, limits_of_monomial_curves) {
    const int limit = NURBS_FRAME_LIMIT;
    const int normal = NURBS_FRAME_NORMAL_LIMIT;
    const struct {
        std::array<int, 3> powers;
        int32_t status;
        double curvature;
        double torsion;
    } cases[] = {
        {{1, 2, 3}, 0, 2 * factor(2) / 36, 3 * factor(3) / (factor(1) * factor(2))},
        {{1, 2, 4}, 0, 2 * factor(2) / 36, 0},
        {{1, 3, 4}, normal, 0, 4 / 2.0 * factor(4) / (factor(1) * factor(3))},
        {{1, 3, 6}, normal, 0, 0},
        {{2, 3, 5}, limit | normal, infinity, 5 * factor(5) / (factor(2) * factor(3))},
        {{2, 4, 6}, limit | normal, 2 * factor(4) / 225, 3 * factor(6) / (factor(2) * factor(4))},
        {{2, 5, 6}, limit | normal, 0, infinity},
        {{3, 4, 5}, limit | normal, infinity, infinity},
    };
    for (const auto &c : cases) {
        for (const bool left : {false, true}) {
            const auto data = monomials(c.powers, 3, -1, 1);
            const auto f = curve_frames(create(data).get(), {0}, left ? NURBS_LEFT : 0);
            // In s' = -s the curve has the odd coefficients negated; T is turned back.
            const double tangent = (left ? -1 : 1) * (left && c.powers[0] % 2 == 1 ? -1.0 : 1.0);
            const double across = left && c.powers[1] % 2 == 1 ? -1.0 : 1.0;
            const std::string place = std::to_string(c.powers[0]) + std::to_string(c.powers[1]) +
                                      std::to_string(c.powers[2]) + (left ? " from the left" : "");
            EXPECT_EQ(f.status[0], c.status) << place;
            EXPECT_LE(norm(minus(vector_at(f.tangents, 0), {tangent, 0, 0})), 1e-12L) << place;
            EXPECT_LE(norm(minus(vector_at(f.normals, 0), {0, across, 0})), 1e-12L) << place;
            EXPECT_LE(norm(minus(vector_at(f.binormals, 0), {0, 0, tangent * across})), 1e-12L) << place;
            if (std::isinf(c.curvature)) {
                EXPECT_EQ(f.curvatures[0], c.curvature) << place;
            } else {
                EXPECT_NEAR(f.curvatures[0], c.curvature, 1e-12) << place;
            }
            if (std::isinf(c.torsion)) {
                EXPECT_TRUE(std::isinf(f.torsions[0])) << place;
            } else {
                EXPECT_NEAR(std::fabs(f.torsions[0]), c.torsion, 1e-12) << place;
            }
        }
    }
}

// What the limits say is what the frames nearby tend to.
TEST(CurveFrames, limits_continue_the_frames_beside_them) {
    for (const std::array<int, 3> &powers :
         {std::array{1, 3, 4}, std::array{2, 3, 5}, std::array{2, 4, 6}, std::array{3, 4, 6}}) {
        const auto g = create(monomials(powers, 3, -1, 1));
        for (const bool left : {false, true}) {
            const auto at = curve_frames(g.get(), {0}, left ? NURBS_LEFT : 0);
            const auto beside = curve_frames(g.get(), {left ? -1e-3 : 1e-3});
            EXPECT_EQ(beside.status[0], 0);
            EXPECT_LE(norm(minus(vector_at(at.tangents, 0), vector_at(beside.tangents, 0))), 0.05L);
            EXPECT_LE(norm(minus(vector_at(at.normals, 0), vector_at(beside.normals, 0))), 0.05L);
            if (std::isfinite(at.curvatures[0])) {
                EXPECT_NEAR(at.curvatures[0], beside.curvatures[0], 0.05);
            }
            if (std::isfinite(at.torsions[0])) {
                EXPECT_NEAR(at.torsions[0], beside.torsions[0], 0.05 * std::fabs(at.torsions[0]) + 0.05);
            }
        }
    }
}

TEST(CurveFrames, cusps_of_the_plane) {
    const auto g = create(monomials({2, 3, 0}, 2, -1, 1));
    const auto right = curve_frames(g.get(), {0});
    const auto left = curve_frames(g.get(), {0}, NURBS_LEFT);
    EXPECT_EQ(right.status[0], NURBS_FRAME_LIMIT);
    EXPECT_NEAR(right.tangents[0], 1, 1e-15);
    EXPECT_NEAR(left.tangents[0], -1, 1e-15);
    EXPECT_EQ(right.curvatures[0], infinity);
    EXPECT_EQ(left.curvatures[0], infinity); // the curve turns left before the cusp too
    const auto before = curve_frames(g.get(), {-0.01});
    EXPECT_GT(before.curvatures[0], 0);
}

TEST(CurveFrames, straight_lines_follow_the_rule) {
    const SplineData line = {{1}, {2}, {{0, 0, 1, 1}}, 3, {1, 2, 3, 3, 3, 5}, {}, 0}; // along (2, 1, 2)
    SplineData cubic = {{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 3, {}, {1, 3, 0.7, 2}, 0};
    for (const double s : {0.0, 0.3, 0.4, 1.0}) {
        cubic.points.insert(cubic.points.end(), {1 + 2 * s, 2 + s, 3 + 2 * s});
    }
    for (const auto &data : {line, cubic}) {
        for (const double t : {0.0, 0.3, 1.0}) {
            const auto f = curve_frames(create(data).get(), {t});
            EXPECT_EQ(f.status[0], NURBS_FRAME_RULE);
            EXPECT_EQ(f.curvatures[0], 0);
            EXPECT_EQ(f.torsions[0], 0);
            const Vector tangent = {2 / 3.0L, 1 / 3.0L, 2 / 3.0L};
            const Vector rule = unit(minus({0, 1, 0}, times(1 / 3.0L, tangent)));
            EXPECT_LE(norm(minus(vector_at(f.tangents, 0), tangent)), 8 * eps);
            EXPECT_LE(norm(minus(vector_at(f.normals, 0), rule)), 16 * eps);
            EXPECT_LE(norm(minus(vector_at(f.binormals, 0), cross(tangent, rule))), 16 * eps);
        }
    }
}

TEST(CurveFrames, a_point_has_no_frame) {
    const SplineData point = {{2}, {3}, {{0, 0, 0, 1, 1, 1}}, 3, {1, 2, 3, 1, 2, 3, 1, 2, 3}, {}, 0};
    const auto f = curve_frames(create(point).get(), {0.5});
    EXPECT_EQ(f.status[0], NURBS_FRAME_UNDEFINED);
    EXPECT_TRUE(std::isnan(f.tangents[0]) && std::isnan(f.normals[1]) && std::isnan(f.binormals[2]) &&
                std::isnan(f.curvatures[0]) && std::isnan(f.torsions[0]));
    EXPECT_EQ(f.points, (std::vector<double>{1, 2, 3}));
}

// (t, t^2, t^3), whose curvature and torsion have closed forms.
TEST(CurveFrames, the_twisted_cubic) {
    const SplineData cubic = {{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 3, {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 3},
                              {},  0};
    const auto g = create(cubic); // (3 t, 3 t^2, 3 t^3)
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0;
        const auto f = curve_frames(g.get(), {t});
        const double a = 1 + 9 * t * t + 9 * t * t * t * t;
        const double b = 1 + 4 * t * t + 9 * t * t * t * t;
        EXPECT_NEAR(f.curvatures[0], 2 * std::sqrt(a) / (b * std::sqrt(b)) / 3, 1e-14);
        EXPECT_NEAR(f.torsions[0], 1 / a, 1e-14); // 3 / a, divided by the size
    }
}

// Powers of two are exact: sizes and speeds change the scale of the results and nothing else.
TEST(CurveFrames, scales_change_nothing) {
    for_each_case(730000, 400, [](Random &random, uint64_t seed) {
        const int dim = random.whole(2, 3);
        auto data = random_spline(random, curve_recipe(random, dim));
        // A vanishing first derivative at a clamped start.
        if (random.chance(30) && data.points.size() >= 2 * static_cast<size_t>(dim)) {
            std::copy_n(data.points.begin() + dim, dim, data.points.begin());
            data.flags = 0;
        }
        auto params = random_params(random, data, 4);
        params.push_back(data.lower(0));
        const double speed = std::ldexp(1, random.whole(-20, 20));
        const double size = std::ldexp(1, random.whole(-20, 20));
        std::vector<double> other_params = params;
        for (double &t : other_params) {
            t *= speed;
        }
        const auto a = curve_frames(create(data).get(), params);
        const auto b = curve_frames(create(scaled(data, size, speed)).get(), other_params);
        ASSERT_EQ(a.status, b.status) << where(seed, data) << hex(params);
        ASSERT_TRUE(same_bits(a.tangents, b.tangents) && same_bits(a.normals, b.normals) &&
                    same_bits(a.binormals, b.binormals))
            << where(seed, data) << hex(params);
        for (size_t i = 0; i < params.size(); ++i) {
            ASSERT_TRUE(same_bits(a.curvatures[i], b.curvatures[i] * size)) << where(seed, data);
            ASSERT_TRUE(dim == 2 || same_bits(a.torsions[i], b.torsions[i] * size)) << where(seed, data);
        }
    });
}

TEST(CurveFrames, same_bits_alone_and_in_a_batch) {
    for_each_case(740000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, curve_recipe(random, random.whole(2, 3)));
        const auto g = create(data);
        const auto params = random_params(random, data, 70);
        const auto batch = curve_frames(g.get(), params);
        for (size_t i = 0; i < params.size(); i += 9) {
            const auto alone = curve_frames(g.get(), {params[i]});
            ASSERT_EQ(alone.status[0], batch.status[i]) << where(seed, data) << hex(params[i]);
            ASSERT_TRUE(same_bits(alone.curvatures[0], batch.curvatures[i])) << where(seed, data);
            for (size_t c = 0; c < alone.normals.size(); ++c) {
                ASSERT_TRUE(same_bits(alone.normals[c], batch.normals[i * alone.normals.size() + c]))
                    << where(seed, data);
            }
        }
    });
}

} // namespace

} // namespace curve_frames_test
