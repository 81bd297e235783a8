// Approximation of splines by simpler ones: the bound is proven, corners stay, and less is needed than there was.
#include "property/fits.h"

#include <limits>
#include <numeric>

namespace approximate_test {

using namespace support;
using namespace support::fits;

namespace {

struct Approximated {
    Handle spline;
    double bound = -1;
    [[nodiscard]] int64_t count() const { return read_back(spline.get()).point_count(); }
};

Approximated approximated(const nurbs *g, const std::vector<int32_t> &degrees, double tolerance,
                          int64_t max_count = 0) {
    Approximated result;
    result.spline = made([&](nurbs **out) {
        return nurbs_approximate(g, degrees.empty() ? nullptr : degrees.data(), tolerance, max_count,
                                 &result.bound, out);
    });
    return result;
}

// As fits are; others are g itself with raised degrees.
bool is_clamped(const SplineData &data) {
    for (int k = 0; k < data.axes(); ++k) {
        const std::vector<double> &knots = data.knots[static_cast<size_t>(k)];
        const auto p = static_cast<size_t>(data.degrees[static_cast<size_t>(k)]);
        if (knots[0] != knots[p] || knots[knots.size() - 1 - p] != knots.back()) {
            return false;
        }
    }
    return true;
}

} // namespace

TEST(Approximate, is_within_its_bound) {
    for_each_case(920000, 60, [](Random &random, uint64_t seed) {
        const int axes = random.chance(80) ? 1 : 2;
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 7 : 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = Spacing::full;
            axis.placement = Placement::origin;
        }
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const double tolerance = extent(data) * random.magnitude(1e-3, 0.1);
        const std::vector<int32_t> degrees(static_cast<size_t>(axes), random.whole(1, 5));
        const Approximated result = approximated(g.get(), degrees, tolerance);
        const SplineData back = read_back(result.spline.get());
        ASSERT_TRUE(back.weights.empty()) << where(seed, data);
        ASSERT_EQ(back.degrees, degrees) << where(seed, data);
        ASSERT_EQ(back.flags, data.flags) << where(seed, data);
        double most = 0;
        for (int i = 0; i < 300; ++i) {
            const auto param = random_params(random, data, 1);
            const auto a = eval(g.get(), param), b = eval(result.spline.get(), param);
            double sum = 0;
            for (size_t c = 0; c < a.size(); ++c) {
                sum = std::hypot(sum, a[c] - b[c]);
            }
            most = std::max(most, sum);
        }
        ASSERT_LE(most, result.bound) << where(seed, data);
        if (data.flags == 0 && is_clamped(back)) { // corners, of jumps beside them too
            std::vector<double> lower, upper;
            for (int k = 0; k < axes; ++k) {
                lower.push_back(data.lower(k));
                upper.push_back(data.upper(k));
            }
            ASSERT_TRUE(same_bits(eval(g.get(), lower), eval(result.spline.get(), lower)))
                << where(seed, data);
            const uint32_t left = NURBS_ON_ALL_AXES(axes, NURBS_LEFT);
            ASSERT_TRUE(same_bits(eval(g.get(), upper, left), eval(result.spline.get(), upper, left)))
                << where(seed, data);
        }
    });
}

TEST(Approximate, meets_the_tolerance_with_few_control_points) {
    const double s = 0.70710678118654757;
    const SplineData circle{{2},
                            {9},
                            {{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}},
                            2,
                            {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0},
                            {1, s, 1, s, 1, s, 1, s, 1},
                            0};
    const Handle g = create(circle);
    for (const auto &[degree, tolerance, most] :
         {std::tuple{3, 1e-2, 16}, {3, 1e-4, 30}, {3, 1e-6, 90}, {5, 1e-6, 42}, {5, 1e-9, 95}}) {
        const Approximated result = approximated(g.get(), {degree}, tolerance);
        EXPECT_LE(result.bound, tolerance) << degree;
        EXPECT_LE(result.count(), most) << degree << ' ' << tolerance;
    }
    // The degree of g, a limit that is too low, and a tolerance that no polynomial meets.
    EXPECT_EQ(read_back(approximated(g.get(), {}, 1e-2).spline.get()).degrees[0], 2);
    const Approximated few = approximated(g.get(), {3}, 1e-6, 20);
    EXPECT_LE(few.count(), 20);
    EXPECT_GT(few.bound, 1e-6);
    EXPECT_GT(approximated(g.get(), {3}, 0, 30).bound, 0);
}

TEST(Approximate, needs_least_for_any_distance) {
    SplineData cubic = even_curve(3, 9, 2);
    std::iota(cubic.points.begin(), cubic.points.end(), 0.0);
    const Handle g = create(cubic);
    const Approximated result = approximated(g.get(), {1}, std::numeric_limits<double>::infinity());
    EXPECT_EQ(result.count(), 2);
    // One constant cannot keep two ends; two can.
    EXPECT_EQ(approximated(g.get(), {0}, std::numeric_limits<double>::infinity()).count(), 2);
}

TEST(Approximate, returns_what_is_simple_already) {
    SplineData cubic = even_curve(3, 8, 2);
    for (size_t i = 0; i < cubic.points.size(); ++i) {
        cubic.points[i] = std::sin(static_cast<double>(i * i));
    }
    const Handle g = create(cubic);
    const Approximated same = approximated(g.get(), {3}, 0);
    EXPECT_EQ(same.bound, 0);
    EXPECT_TRUE(same_bits(read_back(same.spline.get()).points, cubic.points));
    const Approximated near = approximated(g.get(), {3}, 1e-9);
    EXPECT_LE(near.bound, 1e-9);
    EXPECT_EQ(near.count(), 8);
    EXPECT_EQ(read_back(approximated(g.get(), {4}, 0).spline.get()).degrees[0], 4);
}

// With a limit of work, counted: the closest one that was met, with a bound that holds.
TEST(Approximate, ends_at_a_limit_of_work_with_what_it_has) {
    Random random(921000);
    SplineData wild;
    wild.dim = 3;
    for (int k = 0; k < 2; ++k) {
        support::products::set_axis(wild, 3, even_curve(3, 12).knots[0]);
    }
    for (int64_t i = 0; i < wild.point_count(); ++i) {
        for (int c = 0; c < 3; ++c) {
            wild.points.push_back(random.between(-1, 1));
        }
        wild.weights.push_back(random.magnitude(1e-2, 1e2));
    }
    const Handle g = create(wild);
    const auto within = [&](int64_t work, Approximated &result) {
        nurbs_call_options call{};
        require_ok(nurbs_call_options_init(&call, sizeof call));
        call.work = work;
        nurbs *out = nullptr;
        const nurbs_status status =
            nurbs_approximate_with(g.get(), nullptr, 0, 0, &result.bound, &call, &out);
        result.spline = Handle(out);
        return status;
    };
    Approximated none, few, more;
    EXPECT_EQ(within(100000, none), NURBS_ERROR_WORK);
    ASSERT_EQ(within(300000000, few), NURBS_OK);
    ASSERT_EQ(within(1200000000, more), NURBS_OK);
    EXPECT_GT(more.bound, 0);
    EXPECT_LT(more.bound, few.bound);
    for (int i = 0; i < 300; ++i) {
        const auto param = random_params(random, wild, 1);
        const auto a = eval(g.get(), param), b = eval(few.spline.get(), param);
        EXPECT_LE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), few.bound);
    }
}

// Of a rational solid with a kink at every knot, whose least fit that keeps them has 28^3 control points: they are given up.
TEST(Approximate, gives_kinks_up_that_take_too_long) {
    Random random(925000);
    SplineData kinked;
    kinked.degrees = {1, 1, 1};
    kinked.dim = 3;
    kinked.counts = {10, 10, 10};
    std::vector<double> knots(12);
    for (int i = 0; i < 12; ++i) {
        knots[static_cast<size_t>(i)] = std::clamp(i - 1, 0, 9);
    }
    kinked.knots = {knots, knots, knots};
    for (int i = 0; i < 1000; ++i) {
        kinked.weights.push_back(random.between(0.5, 2));
        for (int c = 0; c < 3; ++c) {
            kinked.points.push_back(random.between(-1, 1));
        }
    }
    const Handle g = create(kinked);
    const Approximated found = approximated(g.get(), {3, 3, 3}, 1e-6);
    EXPECT_LT(found.count(), 28 * 28 * 28);
    EXPECT_GT(found.bound, 1e-6);
    EXPECT_LT(found.bound, 20);
}

} // namespace approximate_test
