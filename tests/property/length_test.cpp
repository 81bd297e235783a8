// Lengths of curves, and the parameters of lengths: closed forms, quadrature in fifty digits, laws.
#include "property/measures.h"

namespace length_test {

using namespace support;
using namespace support::measures;

namespace {

// (t^2, t^3) on [a, b] has the length of ((4 + 9 t^2)^(3/2) - 8) / 27 at both ends; with the cusp anywhere.
TEST(Measure, a_cusp_keeps_its_tolerance) {
    for (const double start : {-1.0, -0.37, -1e-3, 0.0, 1e-9}) {
        const double b = 0.8113, a = start;
        // blossoms of t^2 and t^3 over [a, b]
        const SplineData data = bezier(2, {a * a, a * a * a, (a * a + 2 * a * b) / 3, a * a * b,
                                           (b * b + 2 * a * b) / 3, a * b * b, b * b, b * b * b});
        const auto part = [](double t) { return (std::pow(4 + 9 * t * t, 1.5L) - 8) / 27; };
        const long double exact = part(b) + (a < 0 ? part(a) : -part(a));
        for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
            const Measured m = length(create(data).get(), tolerance);
            EXPECT_LE(std::fabs(static_cast<double>(m.value - exact)), std::max(m.error, 4 * double_eps))
                << start;
            EXPECT_LE(m.error, 2 * tolerance * m.value) << start;
        }
    }
}

TEST(Measure, a_near_cusp_keeps_its_tolerance) {
    for (const double gap : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-13}) {
        const SplineData data = bezier(2, {0, 0, 1.1, 1, -0.1 + gap, 1, 0.9, 0});
        const Measured m = length(create(data).get(), 1e-12);
        const Long exact = exact_length(data, 0, 1, 1e-20);
        EXPECT_LE(static_cast<double>(abs(exact - m.value)), m.error) << gap;
        EXPECT_LE(m.error, 2e-12 * m.value) << gap;
    }
}

TEST(Measure, lengths_agree_with_fifty_digits) {
    Random random(5521);
    for (int i = 0; i < 32; ++i) {
        const int degree = random.whole(1, i < 28 ? 5 : 12);
        const SplineData data =
            tangle(random, degree, degree + random.whole(1, 5), random.whole(2, 4), random.chance(60));
        for (const double tolerance : {1e-6, 1e-12, 0.0}) {
            const Measured m = length(create(data).get(), tolerance);
            const double off = static_cast<double>(abs(exact_length(data, -1, 1e9, 1e-18) - m.value));
            EXPECT_LE(off, m.error) << describe(data);
            EXPECT_LE(m.error, 1.5 * tolerance * m.value + 100 * (degree + 1) * double_eps * extent(data) * 8)
                << describe(data);
        }
    }
}

// T_n goes up and down n times between -1 and 1; its Bernstein coefficients are quotients of binomials.
TEST(Measure, chebyshev_polynomials_vary_by_twice_their_degree) {
    for (int n = 1; n <= 12; ++n) {
        std::vector<double> points;
        for (int j = 0; j <= n; ++j) {
            const double c =
                static_cast<double>(binomial(2 * n, 2 * j)) / static_cast<double>(binomial(n, j));
            points.push_back((n - j) % 2 == 0 ? c : -c);
        }
        const Handle g = create(bezier(1, points));
        for (const double tolerance : {1e-5, 1e-12}) {
            const Measured m = length(g.get(), tolerance);
            EXPECT_LE(std::fabs(m.value - 2 * n), m.error) << n;
            EXPECT_LE(m.error,
                      std::max(2 * tolerance, 64 * n * double_eps * *std::ranges::max_element(points)) *
                          m.value);
        }
    }
}

// Powers of two change nothing but the exponents.
TEST(Measure, lengths_scale_with_the_model_and_not_with_the_knots) {
    Random random(5523);
    for (int i = 0; i < 20; ++i) {
        const SplineData data = tangle(random, random.whole(1, 6), 12, 3, random.chance(50));
        const double before = length(create(data).get(), 1e-12).value;
        for (const int power : {-300, -20, 20, 300}) {
            const SplineData other = scaled(data, std::ldexp(1, power), std::ldexp(1, -power / 10));
            EXPECT_EQ(length(create(other).get(), 1e-12).value, std::ldexp(before, power));
        }
    }
}

TEST(Measure, lengths_and_parameters_are_inverse) {
    Random random(5524);
    for (int i = 0; i < 20; ++i) {
        const SplineData data = tangle(random, random.whole(1, 6), random.whole(7, 14), 3, random.chance(50));
        const Handle g = create(data);
        // The sum of the same table: that of the length alone may round otherwise.
        const double total = lengths_at(g.get(), {data.upper(0)})[0];
        std::vector<double> lengths = {0, total};
        for (int k = 0; k < 40; ++k) {
            lengths.push_back(random.unit() * total);
        }
        lengths.push_back(length(g.get()).value);
        EXPECT_NEAR(lengths.back(), total, 16 * double_eps * total);
        const std::vector<double> params = params_at(g.get(), lengths), again = lengths_at(g.get(), params);
        EXPECT_EQ(params[0], data.lower(0));
        EXPECT_EQ(params[1], data.upper(0));
        for (size_t k = 0; k < lengths.size(); ++k) {
            EXPECT_NEAR(again[k], lengths[k], 16 * double_eps * total) << describe(data);
        }
        for (size_t k = 2; k < 4; ++k) {
            const double exact = static_cast<double>(exact_length(data, -1, params[k], 1e-18));
            EXPECT_NEAR(exact, lengths[k], 32 * double_eps * total);
        }
    }
}

// Lengths are sums of those of pieces: they never fall, and that of the end belongs to the end, but to the start if the
// curve is a point.
TEST(Measure, lengths_rise_to_the_end) {
    Random random(5527);
    for (int i = 0; i < 600; ++i) {
        Recipe recipe{{random_axis(random, random.whole(1, 6))}};
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].placement = Placement::origin;
        recipe.axes[0].spans = random.whole(1, 25);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = i % 2 == 0
                                    ? tangle(random, random.whole(1, 6), random.whole(7, 30), 3, i % 4 == 0)
                                    : random_spline(random, recipe);
        const Handle g = create(data);
        std::vector<double> params;
        for (int k = 0; k < 50; ++k) {
            params.push_back(random.between(data.lower(0), data.upper(0)));
        }
        for (const double each : data.knots[0]) {
            const double knot = std::clamp(each, data.lower(0), data.upper(0));
            params.insert(params.end(),
                          {knot, std::nextafter(knot, data.lower(0)), std::nextafter(knot, data.upper(0))});
        }
        std::sort(params.begin(), params.end());
        const std::vector<double> lengths = lengths_at(g.get(), params);
        EXPECT_TRUE(std::is_sorted(lengths.begin(), lengths.end())) << describe(data);
        const double end = lengths.back() > 0 ? data.upper(0) : data.lower(0);
        EXPECT_EQ(params_at(g.get(), {lengths.back()})[0], end) << describe(data);
    }
}

// t^3 on [-1, 1] stands still at 0, and a curve with a jump loses nothing there.
TEST(Measure, the_first_parameter_where_a_curve_stands_still) {
    const Handle cubic = create(bezier(1, {-1, 1, -1, 1}));
    EXPECT_NEAR(params_at(cubic.get(), {1.0})[0], 0.5, 1e-5);
    SplineData jump;
    jump.degrees = {1};
    jump.counts = {6};
    jump.knots = {{0, 0, 1, 1, 2, 2, 3, 3}};
    jump.dim = 1;
    jump.points = {0, 1, 5, 5, 8, 9};
    EXPECT_EQ(params_at(create(jump).get(), {0.5, 1, 1.5, 2}), (std::vector<double>{0.5, 1, 2.5, 3}));
    EXPECT_EQ(length(create(jump).get()).value, 2);
}

TEST(Measure, equal_lengths_and_equal_chords) {
    Random random(5525);
    for (int i = 0; i < 12; ++i) {
        const SplineData data = tangle(random, 3, 9, 2, random.chance(50));
        const Handle g = create(data);
        const int64_t parts = random.whole(1, 20);
        std::vector<double> params(static_cast<size_t>(parts) + 1);
        double size = 0;
        require_ok(nurbs_curve_divide(g.get(), nullptr, parts, 1e-12, 0, params.data(), &size));
        const std::vector<double> at = lengths_at(g.get(), params);
        for (size_t k = 1; k < at.size(); ++k) {
            EXPECT_NEAR(at[k] - at[k - 1], size, 64 * double_eps * at.back());
        }
        const nurbs_status status =
            nurbs_curve_divide(g.get(), nullptr, parts, 1e-9, NURBS_EQUAL_CHORDS, params.data(), &size);
        if (status == NURBS_ERROR_NOT_CONVERGED) {
            continue; // a curve that crosses itself may have no such chord
        }
        require_ok(status);
        const Handle small = create(scaled(data, 0x1p-20)); // by a power of two, which changes no digit
        std::vector<double> again(params.size());
        double chord = 0;
        require_ok(
            nurbs_curve_divide(small.get(), nullptr, parts, 1e-9, NURBS_EQUAL_CHORDS, again.data(), &chord));
        EXPECT_EQ(again, params) << describe(data);
        EXPECT_EQ(chord, 0x1p-20 * size) << describe(data);
        EXPECT_EQ(params.front(), data.lower(0));
        EXPECT_EQ(params.back(), data.upper(0));
        const std::vector<double> points = eval(g.get(), params);
        for (size_t k = 1; k < params.size(); ++k) {
            EXPECT_GT(params[k], params[k - 1]);
            const double apart =
                std::hypot(points[2 * k] - points[2 * k - 2], points[2 * k + 1] - points[2 * k - 1]);
            EXPECT_NEAR(apart, size, 2e-9 * size + 64 * double_eps) << describe(data);
        }
    }
    std::vector<double> params(7);
    double chord = 0;
    const Handle circle = ellipse(2, 2);
    require_ok(
        nurbs_curve_divide(circle.get(), nullptr, 6, 1e-12, NURBS_EQUAL_CHORDS, params.data(), &chord));
    EXPECT_NEAR(chord, 2, 1e-11); // a regular hexagon
}

// Where walks by the first point at a distance jump over the end, chains are followed through folds: of these
// curves walks divide about half.
TEST(Measure, tangles_divide_into_a_few_equal_chords) {
    Random random(5529);
    int found = 0;
    for (int i = 0; i < 40; ++i) {
        const int dim = 2 + i % 2;
        const SplineData data = tangle(random, 3, 20, dim, random.chance(50));
        const Handle g = create(data);
        const int64_t parts = 2 + i % 4;
        std::vector<double> params(static_cast<size_t>(parts) + 1);
        double size = 0;
        const nurbs_status status =
            nurbs_curve_divide(g.get(), nullptr, parts, 1e-9, NURBS_EQUAL_CHORDS, params.data(), &size);
        if (status == NURBS_ERROR_NOT_CONVERGED) {
            continue;
        }
        require_ok(status);
        ++found;
        EXPECT_EQ(params.front(), data.lower(0));
        EXPECT_EQ(params.back(), data.upper(0));
        const std::vector<double> points = eval(g.get(), params);
        const auto stride = static_cast<size_t>(dim);
        for (size_t k = 1; k < params.size(); ++k) {
            EXPECT_GT(params[k], params[k - 1]);
            double square = 0;
            for (size_t c = 0; c < stride; ++c) {
                square += std::pow(points[k * stride + c] - points[(k - 1) * stride + c], 2);
            }
            EXPECT_NEAR(std::sqrt(square), size, 2e-9 * size) << describe(data);
        }
    }
    EXPECT_GE(found, 38);
}

} // namespace

} // namespace length_test
