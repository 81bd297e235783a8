// Critical points of the distance from curves: their number where it is known, and their kinds by samples.
#include "property/critical_points.h"
#include "property/same_shape.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace critical_curve_test {

using namespace support;

namespace {

double distance(const nurbs *g, double t, const std::vector<double> &x, uint32_t flags = 0) {
    const std::vector<double> point = eval(g, {t}, flags);
    double square = 0;
    for (size_t c = 0; c < x.size(); ++c) {
        square += (point[c] - x[c]) * (point[c] - x[c]);
    }
    return std::sqrt(square);
}

Handle ellipse(double a, double b) {
    const double center[] = {0, 0}, x[] = {1, 0};
    nurbs *g = nullptr;
    require_ok(
        nurbs_curve_ellipse(2, center, nullptr, x, a, b, 0, 2 * std::numbers::pi, NURBS_ARC_QUARTERS, &g));
    return Handle(g);
}

Handle square() {
    SplineData data;
    data.degrees = {1};
    data.counts = {5};
    data.dim = 2;
    data.knots = {{0, 0, 1, 2, 3, 4, 4}};
    data.points = {-1, -1, 1, -1, 1, 1, -1, 1, -1, -1};
    return create(data);
}

// Four normals of an ellipse go through a point inside its evolute (x a)^(2/3) + (y b)^(2/3) = (a^2 -
// b^2)^(2/3), two through a point outside.
TEST(CriticalPoints, normals_of_an_ellipse) {
    Random random(0x6021);
    const Handle g = ellipse(3, 2);
    for (int i = 0; i < 500; ++i) {
        const double x = random.between(-3, 3), y = random.between(-3, 3);
        const double evolute = std::pow(std::fabs(3 * x), 2.0 / 3) + std::pow(std::fabs(2 * y), 2.0 / 3);
        const double limit = std::pow(5.0, 2.0 / 3);
        if (std::fabs(evolute - limit) < 1e-6) {
            continue;
        }
        const Critical found = critical(g.get(), {x, y});
        const int64_t each = evolute < limit ? 2 : 1;
        EXPECT_EQ(found.number(NURBS_CRITICAL_MINIMUM), each) << x << " " << y;
        EXPECT_EQ(found.number(NURBS_CRITICAL_MAXIMUM), each) << x << " " << y;
        EXPECT_EQ(found.kinds.size(), static_cast<size_t>(2 * each)) << x << " " << y;
        EXPECT_NE(found.status & NURBS_CLOSEST_CERTIFIED, 0) << x << " " << y;
    }
}

TEST(CriticalPoints, kinks_and_middles_of_a_square) {
    const Handle g = square();
    const Critical found = critical(g.get(), {0.25, 0.125});
    EXPECT_EQ(found.number(NURBS_CRITICAL_MINIMUM), 4);
    EXPECT_EQ(found.number(NURBS_CRITICAL_MAXIMUM), 4);
    EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_EQ(found.params, (std::vector<double>{0, 0.625, 1, 1.5625, 2, 2.375, 3, 3.4375}));
}

// Beyond the centre of curvature of a vertex three normals have their feet near it. If the tolerance does not
// tell these apart they are one point, on whichever side of the seam they lie.
TEST(CriticalPoints, are_one_across_the_seam) {
    const double center[] = {0, 0};
    for (const double turn : {0.0, 0.5, 1.0}) {
        const double x[] = {std::cos(turn), std::sin(turn)}; // of the longer axis
        for (const int quarter : {0, 1, 2, 3}) {
            const double start = quarter * std::numbers::pi / 2;
            const Handle g = made([&](nurbs **out) {
                return nurbs_curve_ellipse(2, center, nullptr, x, 3, 2, start, 2 * std::numbers::pi,
                                           NURBS_ARC_QUARTERS, out);
            });
            const double at = 3 - 4.0 / 3 - 1e-3;
            const std::vector<double> point{at * x[0], at * x[1]};
            EXPECT_EQ(critical(g.get(), point).number(NURBS_CRITICAL_MINIMUM), 2) << quarter;
            const Critical found = critical(g.get(), point, 0.5);
            EXPECT_EQ(found.number(NURBS_CRITICAL_MINIMUM), 1) << quarter;
            EXPECT_EQ(found.number(NURBS_CRITICAL_MAXIMUM), 1) << quarter;
            EXPECT_EQ(found.kinds.size(), 2U) << quarter;
            EXPECT_TRUE(std::ranges::is_sorted(found.params)) << quarter;
        }
    }
}

// As the tolerance is for what follows each other along the curve.
TEST(CriticalPoints, a_crossing_is_two_points) {
    SplineData data;
    data.degrees = {1};
    data.counts = {4};
    data.dim = 2;
    data.knots = {{0, 0, 1, 2, 3, 3}};
    data.points = {0, 0, 2, 2, 2, 0, 0, 2};
    const Critical found = critical(create(data).get(), {1, 1}, 1e-6);
    EXPECT_EQ(std::ranges::count(found.distances, 0.0), 2);
    EXPECT_NE(found.status & NURBS_CLOSEST_CERTIFIED, 0);
}

// Every event is what samples beside it say, and samples show no other change of direction.
TEST(CriticalPoints, samples_agree) {
    int all = 0, certified = 0;
    for_each_case(0x6022, 150, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 6);
        recipe.axes[0].spans = random.whole(1, 6);
        recipe.axes[0].degree = random.whole(1, 6);
        recipe.axes[0].placement = Placement::origin;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.dim = random.whole(1, 3);
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        std::vector<double> x;
        for (int c = 0; c < data.dim; ++c) {
            x.push_back(random.between(-1, 1));
        }
        const Critical found = critical(g.get(), x);
        ++all;
        if ((found.status & NURBS_CLOSEST_CERTIFIED) == 0) {
            return;
        }
        ++certified;
        constexpr int samples = 3000;
        std::vector<double> values;
        for (int i = 0; i <= samples; ++i) {
            values.push_back(
                distance(g.get(), std::lerp(data.lower(0), data.upper(0), i / double{samples}), x));
        }
        int64_t minima = 0;
        for (size_t i = 1; i + 1 < values.size(); ++i) {
            minima += values[i - 1] > values[i] && values[i] < values[i + 1] ? 1 : 0;
        }
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        ASSERT_FALSE(found.distances.empty()) << where(seed, data);
        EXPECT_GE(found.number(NURBS_CRITICAL_MINIMUM) + found.number(NURBS_CRITICAL_SADDLE), minima)
            << where(seed, data);
        EXPECT_LE(*std::min_element(found.distances.begin(), found.distances.end()),
                  *low * (1 + 1e-12) + 1e-12)
            << where(seed, data);
        EXPECT_GE(*std::max_element(found.distances.begin(), found.distances.end()), *high * (1 - 1e-12))
            << where(seed, data);
    });
    std::printf("%d of %d certified\n", certified, all);
    EXPECT_GE(certified, all * 9 / 10);
}

TEST(ClosestAll, equally_near_points_are_all_found) {
    const Handle g = square();
    const Critical four = all_nearest(g.get(), {0, 0}, 0), two = all_nearest(g.get(), {0.5, 0.5}, 1e-9);
    EXPECT_EQ(four.params, (std::vector<double>{0.5, 1.5, 2.5, 3.5}));
    EXPECT_EQ(four.status, NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_NOT_UNIQUE);
    EXPECT_EQ(two.params, (std::vector<double>{1.75, 2.25}));
    const Critical one = all_nearest(g.get(), {0.5, 0.25}, 0.1),
                   more = all_nearest(g.get(), {0.5, 0.25}, 0.3);
    EXPECT_EQ(one.params, (std::vector<double>{1.625}));
    EXPECT_EQ(one.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_EQ(more.params, (std::vector<double>{1.625, 2.25}));
}

TEST(ClosestAll, a_crossing_has_two_parameters) {
    SplineData data;
    data.degrees = {1};
    data.counts = {4};
    data.dim = 2;
    data.knots = {{0, 0, 1, 2, 3, 3}};
    data.points = {0, 0, 2, 2, 2, 0, 0, 2};
    const Handle g = create(data);
    const Critical found = all_nearest(g.get(), {1, 1}, 0);
    EXPECT_EQ(found.params, (std::vector<double>{0.5, 2.5}));
    EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_NOT_UNIQUE);
}

TEST(ClosestAll, an_arc_around_its_centre_is_a_continuum) {
    const Handle g = ellipse(2, 2);
    const Critical found = all_nearest(g.get(), {0, 0}, 0);
    EXPECT_EQ(found.params.size(), 4U);
    EXPECT_EQ(found.status, NURBS_CLOSEST_NOT_UNIQUE);
}

} // namespace

} // namespace critical_curve_test
