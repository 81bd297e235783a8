// Features of curves against closed forms, and against signs in exact arithmetic.
#include "exact_points.h"
#include "exact_polynomials.h"
#include "made_shapes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace features_test {

using namespace support;

namespace {

using Vec = std::vector<double>;
constexpr double pi = std::numbers::pi;
constexpr uint32_t extrema = NURBS_FEATURE_CURVATURE_MAXIMUM | NURBS_FEATURE_CURVATURE_MINIMUM;

struct Features {
    Vec params, values;
    std::vector<int32_t> kinds;
    int32_t complete = -1;
};

Features features(const nurbs *g, uint32_t kinds) {
    Features f;
    int64_t count = -1;
    require_ok(nurbs_curve_features(g, kinds, 0, nullptr, nullptr, nullptr, &count, &f.complete));
    const auto n = static_cast<size_t>(count);
    f.params.resize(n);
    f.values.resize(n);
    f.kinds.resize(n);
    require_ok(nurbs_curve_features(g, kinds, count, f.params.data(), f.kinds.data(), f.values.data(),
                                    nullptr, nullptr));
    EXPECT_TRUE(std::is_sorted(f.params.begin(), f.params.end()));
    return f;
}

int64_t count_of(const Features &f, int32_t kind) {
    return std::count(f.kinds.begin(), f.kinds.end(), kind);
}

SplineData bezier(int dim, Vec points, Vec weights = {}) {
    const auto p = static_cast<int32_t>(points.size()) / dim - 1;
    SplineData data{{p}, {p + 1}, {{}}, dim, std::move(points), std::move(weights), 0};
    data.knots[0].assign(static_cast<size_t>(p) + 1, 0.0);
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(p) + 1, 1.0);
    return data;
}

Handle ellipse(double a, double b, double start, double sweep) {
    nurbs *out = nullptr;
    require_ok(
        nurbs_curve_ellipse(2, nullptr, nullptr, nullptr, a, b, start, sweep, NURBS_ARC_QUARTERS, &out));
    return Handle(out);
}

} // namespace

// The four vertices, with curvatures a / b^2 and b / a^2, at any scale; at knots, and away from them.
TEST(CurveFeatures, vertices_of_an_ellipse) {
    for_each_case(7100, 100, [](Random &random, uint64_t seed) {
        const double scale = random.magnitude(1e-6, 1e6);
        const double a = scale * random.between(1.2, 4), b = scale;
        const double start = random.chance(50) ? random.between(-3, 3) : -pi / 4;
        const Handle g = ellipse(a, b, start, 2 * pi);
        const Features f = features(g.get(), extrema | NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CUSP |
                                                 NURBS_FEATURE_KINK | NURBS_FEATURE_JUMP);
        EXPECT_EQ(f.complete, 1) << seed;
        ASSERT_EQ(f.params.size(), 4U) << seed;
        const Vec points = eval(g.get(), f.params);
        for (size_t i = 0; i < 4; ++i) {
            const bool most = f.kinds[i] == NURBS_FEATURE_CURVATURE_MAXIMUM;
            EXPECT_NEAR(std::fabs(points[2 * i + (most ? 0 : 1)]), most ? a : b, 1e-12 * a) << seed;
            EXPECT_NEAR(f.values[i], most ? a / (b * b) : b / (a * a), 1e-11 / scale) << seed;
        }
        EXPECT_EQ(count_of(f, NURBS_FEATURE_CURVATURE_MAXIMUM), 2);
    });
}

// Without the ends there are three vertices where it starts at one; as a periodic curve the seam has the
// fourth.
TEST(CurveFeatures, vertex_at_the_seam) {
    const Handle g = ellipse(2, 1, 0, 2 * pi);
    EXPECT_EQ(features(g.get(), extrema).params.size(), 3U);
    nurbs *out = nullptr;
    require_ok(nurbs_make_periodic(g.get(), 0, 1e-12, nullptr, nullptr, &out));
    const Handle closed(out);
    const Features f = features(closed.get(), extrema | NURBS_FEATURE_KINK);
    ASSERT_EQ(f.params.size(), 4U);
    EXPECT_EQ(f.complete, 1);
    EXPECT_EQ(f.kinds[0], NURBS_FEATURE_CURVATURE_MAXIMUM);
    EXPECT_NEAR(f.values[0], 2, 1e-12);
}

// The curvature of a circle has no extrema, which double precision cannot prove.
TEST(CurveFeatures, circle) {
    const Features f = features(ellipse(2, 2, 0.3, 5).get(), extrema);
    EXPECT_TRUE(f.params.empty());
    EXPECT_EQ(f.complete, 0);
    const Features g = features(ellipse(2, 2, 0.3, 5).get(), NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CUSP);
    EXPECT_TRUE(g.params.empty());
    EXPECT_EQ(g.complete, 1);
}

// y = x^3 - x: the inflection at 0; |curvature| is largest at 45 x^4 - 18 x^2 ... of y'' (1 + y'^2)
// derivative.
TEST(CurveFeatures, cubic) {
    const Handle g = create(bezier(2, {-1, 0, -1. / 3, 2. / 3 + 2. / 3, 1. / 3, -2. / 3 - 2. / 3, 1, 0}));
    const Features f = features(g.get(), 0x3f);
    EXPECT_EQ(f.complete, 1);
    EXPECT_EQ(count_of(f, NURBS_FEATURE_INFLECTION), 1);
    const auto at = static_cast<size_t>(std::find(f.kinds.begin(), f.kinds.end(), NURBS_FEATURE_INFLECTION) -
                                        f.kinds.begin());
    EXPECT_NEAR(f.params[at], 0.5, 1e-15);
    EXPECT_NEAR(f.values[at], 0, 1e-14);
    EXPECT_EQ(count_of(f, NURBS_FEATURE_CURVATURE_MAXIMUM), 2);
    EXPECT_EQ(count_of(f, NURBS_FEATURE_CURVATURE_MINIMUM), 0); // that at the inflection is 0
}

// (t - c)^2, (t - c)^3 has a cusp at c, in the plane and turned in space.
TEST(CurveFeatures, cusp) {
    for_each_case(7200, 60, [](Random &random, uint64_t seed) {
        const double c = random.whole(1, 63) / 64.0;
        const Vec x{c * c, c * c - 2 * c / 3, c * c - 4 * c / 3 + 1. / 3, (1 - c) * (1 - c)};
        const Vec y{-c * c * c, -c * c * c + c * c, -c * c * c + 2 * c * c - c, (1 - c) * (1 - c) * (1 - c)};
        const int dim = random.whole(2, 3);
        SplineData data = bezier(dim, Vec(static_cast<size_t>(4 * dim)));
        for (size_t i = 0; i < 4; ++i) {
            data.points[i * static_cast<size_t>(dim)] = x[i];
            data.points[i * static_cast<size_t>(dim) + 1] = y[i];
        }
        move(data, random_motion(random, dim, random.magnitude(1e-3, 1e3), 1));
        const Features f = features(create(data).get(), NURBS_FEATURE_CUSP);
        ASSERT_EQ(f.params.size(), 1U) << seed;
        EXPECT_EQ(f.complete, 1) << seed;
        EXPECT_NEAR(f.params[0], c, 1e-13) << seed;
        EXPECT_TRUE(std::isinf(f.values[0])) << seed;
    });
}

// A cubic whose first two control points are one has its only zero derivative there.
TEST(CurveFeatures, double_point_at_an_end) {
    const Features f = features(create(bezier(2, {1, 1, 1, 1, 2, 3, 4, 0})).get(), NURBS_FEATURE_CUSP);
    ASSERT_EQ(f.params.size(), 1U);
    EXPECT_EQ(f.params[0], 0);
    EXPECT_EQ(f.complete, 1);
}

TEST(CurveFeatures, kinks_and_jumps) {
    SplineData square{{1}, {5}, {{0, 0, 1, 2, 3, 4, 4}}, 2, {0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, {}, 0};
    const Features f = features(create(square).get(), 0x3f);
    EXPECT_EQ(f.complete, 1);
    EXPECT_EQ(f.params, (Vec{1, 2, 3}));
    for (const double angle : f.values) {
        EXPECT_NEAR(angle, pi / 2, 1e-15);
    }
    square.knots = {{-1, 0, 1, 2, 3, 4, 5}};
    square.flags = NURBS_PERIODIC;
    const Features round = features(create(square).get(), NURBS_FEATURE_KINK); // one at the seam, too
    ASSERT_EQ(round.params, (Vec{0, 1, 2, 3}));
    for (const double angle : round.values) {
        EXPECT_NEAR(angle, pi / 2, 4e-16);
    }
    const SplineData apart{{1}, {4}, {{0, 0, 1, 1, 2, 2}}, 2, {0, 0, 1, 0, 4, 4, 5, 4}, {}, 0};
    const Features g = features(create(apart).get(), NURBS_FEATURE_JUMP | NURBS_FEATURE_KINK);
    ASSERT_EQ(g.params.size(), 1U);
    EXPECT_EQ(g.kinds[0], NURBS_FEATURE_JUMP);
    EXPECT_NEAR(g.values[0], 5, 1e-14);
}

// x = t, y = t^2, z = (t - c)^4: the torsion has the sign of z''', that of t - c.
TEST(CurveFeatures, torsion) {
    const double c = 0.375;
    Vec z;
    for (const double k : {0.0, 1.0, 2.0, 3.0, 4.0}) {
        const double terms[] = {c * c * c * c, -4 * c * c * c * k / 4, 6 * c * c * k * (k - 1) / 12,
                                -4 * c * k * (k - 1) * (k - 2) / 24, k * (k - 1) * (k - 2) * (k - 3) / 24};
        z.push_back(terms[0] + terms[1] + terms[2] + terms[3] + terms[4]);
    }
    Vec points;
    for (size_t k = 0; k < 5; ++k) {
        const auto i = static_cast<double>(k);
        points.insert(points.end(), {i / 4, i * (i - 1) / 12, z[k]});
    }
    const Features f = features(create(bezier(3, points)).get(), NURBS_FEATURE_TORSION);
    ASSERT_EQ(f.params.size(), 1U);
    EXPECT_EQ(f.complete, 1);
    EXPECT_NEAR(f.params[0], c, 1e-13);
    nurbs *out = nullptr;
    require_ok(nurbs_curve_helix(3, nullptr, nullptr, nullptr, 2, 0, 1, 0, 1.5, 1e-6, nullptr, &out));
    const Handle helix(out);
    const Features g = features(helix.get(), NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CUSP);
    EXPECT_TRUE(g.params.empty());
    EXPECT_EQ(g.complete, 1);
}

// A plane curve with an inflection stays one in space.
TEST(CurveFeatures, inflection_of_a_plane_curve_in_space) {
    for_each_case(7300, 60, [](Random &random, uint64_t seed) {
        SplineData data = bezier(3, {0, 0, 0, 1, 2, 0, 2, -2.25, 0, 3.5, 0.125, 0});
        const Features flat =
            features(create(bezier(2, {0, 0, 1, 2, 2, -2.25, 3.5, 0.125})).get(), NURBS_FEATURE_INFLECTION);
        ASSERT_EQ(flat.params.size(), 1U);
        move(data, random_motion(random, 3, random.magnitude(1e-3, 1e3), 2));
        const Features f = features(create(data).get(), NURBS_FEATURE_INFLECTION);
        ASSERT_EQ(f.params.size(), 1U) << seed;
        EXPECT_EQ(f.complete, 1) << seed;
        EXPECT_NEAR(f.params[0], flat.params[0], 1e-12);
    });
}

// Where all is certain the signs of the curvature alternate at the inflections and nowhere else, in exact
// arithmetic.
TEST(CurveFeatures, signs_between_inflections_are_exact) {
    int complete = 0;
    for_each_case(7400, 200, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 6);
        recipe.dim = 2;
        recipe.axes[0].form = random.chance(70) ? KnotForm::clamped : KnotForm::unclamped;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const Features f = features(g.get(), NURBS_FEATURE_INFLECTION);
        complete += f.complete;
        if (f.complete == 0) {
            return;
        }
        int last = 0;
        size_t passed = 0, crossed = 0;
        Vec params = random_params(random, data, 30);
        std::sort(params.begin(), params.end());
        for (const double t : params) {
            const auto d = reference::exact_derivatives(data, 2, &t);
            const auto value = [&](size_t order, size_t c) {
                return Rational(d[order][c].numerator, d[order][c].denominator);
            };
            const Rational bend = value(1, 0) * value(2, 1) - value(1, 1) * value(2, 0);
            const int sign = bend > 0 ? 1 : bend < 0 ? -1 : 0;
            const bool beside = std::any_of(f.params.begin(), f.params.end(), [&](double x) {
                return std::fabs(x - t) <= 1e-9 * (data.upper(0) - data.lower(0));
            });
            if (sign == 0 || beside) {
                continue;
            }
            passed =
                static_cast<size_t>(std::lower_bound(f.params.begin(), f.params.end(), t) - f.params.begin());
            if (last != 0) {
                EXPECT_EQ(sign != last, (passed - crossed) % 2 == 1) << t << where(seed, data);
            }
            last = sign;
            crossed = passed;
        }
    });
    EXPECT_GT(complete, support::of_whole_run(100));
}

// Between extrema |curvature| runs one way, at many places.
TEST(CurveFeatures, curvature_is_monotone_between_extrema) {
    int complete = 0;
    for_each_case(7500, 100, [&](Random &random, uint64_t seed) {
        const int p = random.whole(2, 7), dim = random.whole(2, 3);
        Vec points(static_cast<size_t>(dim * (p + 1))),
            weights(static_cast<size_t>(random.chance(50) ? p + 1 : 0));
        std::generate(points.begin(), points.end(), [&] { return random.between(-1, 1); });
        std::generate(weights.begin(), weights.end(), [&] { return random.between(0.5, 2); });
        const SplineData data = bezier(dim, points, weights);
        const Handle g = create(data);
        const Features f = features(g.get(), extrema | NURBS_FEATURE_INFLECTION);
        complete += f.complete;
        constexpr int n = 2000;
        Vec params, bends(n);
        for (int i = 0; i < n; ++i) {
            params.push_back((i + 0.5) / n);
        }
        require_ok(nurbs_curve_eval_frames(g.get(), n, params.data(), 0, nullptr, 0, 0, nullptr, 0, 0,
                                           nullptr, 0, 0, nullptr, 0, 0, bends.data(), 0, nullptr, 0, nullptr,
                                           0));
        for (size_t i = 0; i + 2 < bends.size(); ++i) {
            const double a = std::fabs(bends[i]), b = std::fabs(bends[i + 1]), c = std::fabs(bends[i + 2]);
            const bool turns = (b - a) * (c - b) < 0 && std::fabs(b - a) + std::fabs(c - b) > 1e-9 * b;
            const auto next = std::lower_bound(f.params.begin(), f.params.end(), params[i]);
            const bool told = next != f.params.end() && *next <= params[i + 2];
            EXPECT_TRUE(!turns || told || f.complete == 0) << params[i] << where(seed, data);
        }
        for (size_t i = 0; i < f.params.size(); ++i) {
            const int32_t kind = f.kinds[i];
            const double h = 1e-5, t = f.params[i];
            if (kind == NURBS_FEATURE_INFLECTION || t < h || t > 1 - h) {
                continue;
            }
            Vec around{t - h, t + h}, two(2);
            require_ok(nurbs_curve_eval_frames(g.get(), 2, around.data(), 0, nullptr, 0, 0, nullptr, 0, 0,
                                               nullptr, 0, 0, nullptr, 0, 0, two.data(), 0, nullptr, 0,
                                               nullptr, 0));
            const double at = std::fabs(f.values[i]), slack = 1e-9 * at;
            for (const double x : two) {
                EXPECT_TRUE(kind == NURBS_FEATURE_CURVATURE_MAXIMUM ? std::fabs(x) <= at + slack
                                                                    : std::fabs(x) >= at - slack)
                    << t << where(seed, data);
            }
        }
    });
    EXPECT_GT(complete, support::of_whole_run(90));
}

// High degrees: nothing is claimed that rounding hides.
TEST(CurveFeatures, high_degrees) {
    for_each_case(7600, 6, [](Random &random, uint64_t seed) {
        const int p = random.whole(20, 31), dim = random.whole(2, 3);
        Vec points, weights;
        for (int i = 0; i <= p; ++i) {
            for (int c = 0; c < dim; ++c) {
                points.push_back(c == 0 ? i : random.between(-5, 5));
            }
            weights.push_back(random.between(0.8, 1.25));
        }
        const Handle g = create(bezier(dim, points, weights));
        const Features f = features(g.get(), extrema | NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CUSP);
        std::printf("degree %d, dimension %d: %zu features, complete %d\n", p, dim, f.params.size(),
                    f.complete);
        EXPECT_LT(f.params.size(), 100U) << seed;
    });
}

// Whatever the size: the same places, and curvatures that are multiplied.
TEST(CurveFeatures, of_every_size) {
    const SplineData data = bezier(2, {0, 0, 1, 4, 2, -3, 3, 2, 4, 0});
    const Features base = features(create(data).get(), extrema | NURBS_FEATURE_INFLECTION);
    ASSERT_GE(base.params.size(), 4U);
    for (const int k : {-1000, -600, -300, 300, 600, 1000}) {
        const Features found =
            features(create(scaled(data, std::ldexp(1, k))).get(), extrema | NURBS_FEATURE_INFLECTION);
        ASSERT_EQ(found.params, base.params) << k;
        for (size_t i = 0; i < base.values.size(); ++i) {
            EXPECT_EQ(found.values[i], std::ldexp(base.values[i], -k)) << k;
        }
    }
}

} // namespace features_test
