// Composition with rational curves: exact values, circles, rational linear maps.
#include "property/compositions.h"

namespace compose_rational_test {

using namespace support;
using namespace support::compositions;
using reference::Rational;

namespace {

void set_weights(Random &random, SplineData &f, double ratio) {
    f.weights.clear();
    for (int64_t i = 0; i < f.counts[0]; ++i) {
        f.weights.push_back(random.magnitude(1 / ratio, ratio));
    }
}

// Weights that are powers of two, so that homogeneous records are exact.
void set_short_weights(Random &random, SplineData &f) {
    f.weights.clear();
    for (int64_t i = 0; i < f.counts[0]; ++i) {
        f.weights.push_back(std::exp2(random.whole(-2, 2)));
    }
}

// The result has homogeneous records like g with weights of 1.
SplineData lifted(const nurbs *g) {
    return homogeneous(made([&](nurbs **out) { return nurbs_make_rational(g, out); }).get());
}

TEST(ComposeRational, is_the_composition_at_every_point) {
    WorstErrors worst("rational compositions by degree, unit the bound");
    for_each_case(980000, 400, [&](Random &random, uint64_t seed) {
        MonotoneCase given = monotone_case(random);
        auto &[data, f] = given;
        const bool records = random.chance(30);
        records ? set_short_weights(random, f)
                : set_weights(random, f, random.chance(70) ? 3 : random.magnitude(10, 1e4));
        auto g = create(data);
        if (data.rational() && random.chance(30)) {
            g = homogeneous_form(g.get());
        }
        const auto curve = records ? homogeneous_form(create(f).get()) : create(f);
        const auto composed = compose(g.get(), curve.get());
        const SplineData h = homogeneous(composed.get());
        ASSERT_NO_FATAL_FAILURE(expect_frame(given, h));
        expect_composed({lifted(g.get()), f, h}, random, 1, worst, where(seed, data) + where(seed, f));
    });
}

// They touch knot lines, run along them and pass through their corners.
TEST(ComposeRational, curves_may_touch_knot_lines_and_turn_back) {
    WorstErrors worst("rational curves on surfaces and in volumes by degree, unit the bound");
    for_each_case(981000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(80) ? 2 : 3, q = random.whole(1, 3);
        const SplineData data = whole_knots(random, axes, 2);
        SplineData f = parameter_curve(random, q, axes);
        for (int64_t i = 0; i < f.counts[0] * axes; ++i) {
            const int k = static_cast<int>(i % axes);
            f.points.push_back(data.lower(k) + random.whole(0, 8) / 8.0 * (data.upper(k) - data.lower(k)));
        }
        set_short_weights(random, f);
        const auto g = create(data), curve = create(f);
        const auto composed = compose(g.get(), curve.get());
        expect_composed({lifted(g.get()), f, homogeneous(composed.get())}, random, largest_factor(data, f),
                        worst, where(seed, data) + where(seed, f));
    });
}

// The arc of a plane patch is the arc, and that of a quarter of a cylinder lies on the cylinder.
TEST(ComposeRational, a_circle_of_the_domain_is_a_circle_of_the_plane) {
    const double centre[] = {0.5, 0.5};
    const SplineData plane{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 2, {0, 0, 0, 1, 1, 0, 1, 1}, {}, 0};
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_SMOOTH}) {
        const Handle circle = made(
            [&](nurbs **out) { return nurbs_curve_circle(2, centre, nullptr, nullptr, 0.25, form, out); });
        const Handle traced = compose(create(plane).get(), circle.get());
        for (int i = 0; i <= 64; ++i) {
            const std::vector<double> p = eval(traced.get(), {i / 64.0});
            ASSERT_NEAR(std::hypot(p[0] - 0.5, p[1] - 0.5), 0.25, 8 * static_cast<double>(eps));
        }
    }
}

// f of degree 1 with weights is a rational linear map of the domain.
TEST(ComposeRational, with_a_rational_line_is_the_curve_over_that_parameter) {
    for_each_case(982000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = up_to_sixteen(random, 1, 7);
        if (data.degrees[0] == 0) {
            return;
        }
        const double ratio = random.magnitude(0.1, 10);
        const double rho = std::pow(ratio, 1.0 / data.degrees[0]);
        const SplineData f{{1}, {2}, {{0, 0, 16, 16}}, 1, {0, 16}, {1, rho}, 0};
        const Handle g = create(data), composed = compose(g.get(), create(f).get());
        const Handle other =
            made([&](nurbs **out) { return nurbs_reparametrize_moebius(g.get(), 0, ratio, out); });
        const SplineData got = read_back(composed.get()), wanted = read_back(other.get());
        ASSERT_EQ(got.points.size(), wanted.points.size()) << where(seed, data);
        const double factor = got.weights[0] / wanted.weights[0],
                     u = uncertainty(f, 0) + 64 * 16 * static_cast<double>(eps);
        for (size_t i = 0; i < got.knots[0].size(); ++i) {
            ASSERT_NEAR(got.knots[0][i], wanted.knots[0][i], 10 * u) << where(seed, data);
        }
        for (size_t i = 0; i < got.weights.size(); ++i) {
            ASSERT_NEAR(got.weights[i], factor * wanted.weights[i], 64 * u * got.weights[i])
                << where(seed, data);
        }
    });
}

nurbs_status status_of(const SplineData &g, const SplineData &f) {
    nurbs *out = nullptr;
    const nurbs_status status = nurbs_compose(create(g).get(), create(f).get(), &out);
    const Handle taken(out);
    return status;
}

TEST(ComposeRational, monotone_or_refused) {
    const SplineData g{{1}, {3}, {{0, 0, 0.5, 1, 1}}, 1, {0, 1, 0}, {}, 0};
    const auto arc = [](std::vector<double> points, std::vector<double> weights) {
        const int n = static_cast<int>(points.size());
        SplineData f{
            {n - 1}, {n}, {std::vector<double>(points.size(), 0.0)}, 1, std::move(points), std::move(weights),
            0};
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(n), 1.0);
        return f;
    };
    ASSERT_EQ(status_of(g, arc({0, 0.25, 1}, {1, 100, 1})), NURBS_OK);
    ASSERT_EQ(status_of(g, arc({0, 1, 0.5}, {1, 2, 1})), NURBS_ERROR_NOT_MONOTONE);
    ASSERT_EQ(status_of(g, arc({0, 0, 0.9, 1}, {3, 1, 2, 1})), NURBS_OK);   // f' = 0 at one end
    ASSERT_EQ(status_of(g, arc({0, 0.6, 0.4, 1}, {1, 1, 1, 1})), NURBS_OK); // not by the control points
    ASSERT_EQ(status_of(g, arc({0, 0.6, 0.4, 1}, {1, 9, 9, 1})), NURBS_ERROR_NOT_MONOTONE);
    ASSERT_EQ(status_of(g, arc({0.5, 0.5}, {1, 2})), NURBS_ERROR_NOT_MONOTONE);
    ASSERT_EQ(status_of(g, arc({0, 2, 1}, {1, 1, 1})), NURBS_ERROR_NOT_MONOTONE);
    ASSERT_EQ(status_of(g, arc({0, 0.5, 1.5}, {1, 1, 1})), NURBS_ERROR_OUTSIDE_DOMAIN);
    ASSERT_EQ(status_of(g, arc({0, 0.5, 1}, {1, 0, 1})), NURBS_ERROR_RATIONAL);
    const std::vector<double> steep = [] {
        std::vector<double> points;
        for (int i = 0; i <= 31; ++i) {
            points.push_back(i / 31.0);
        }
        return points;
    }();
    ASSERT_EQ(status_of(g, arc(steep, std::vector<double>(32, 0.7))), NURBS_OK); // of degree 31
}

// Equal weights far from 0 in the parameter blur f no more than none.
TEST(ComposeRational, with_equal_weights_wherever_it_lies) {
    const SplineData g{{1}, {3}, {{0, 0, 0.5, 1, 1}}, 1, {0, 1, 0}, {}, 0};
    SplineData f{{2}, {3}, {{1e15, 1e15, 1e15, 1e15 + 1, 1e15 + 1, 1e15 + 1}}, 1, {0, 0.4, 1}, {}, 0};
    ASSERT_EQ(status_of(g, f), NURBS_OK);
    f.weights = {3, 3, 3};
    ASSERT_EQ(status_of(g, f), NURBS_OK);
    f.weights = {1, 3, 1e9};
    ASSERT_EQ(status_of(g, f), NURBS_ERROR_NOT_REPRESENTABLE);
}

} // namespace

} // namespace compose_rational_test
