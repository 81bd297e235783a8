// Smoothing splines: limits, criteria, conditions, and what the data do not determine.
#include "property/fits.h"

#include <limits>

namespace smoothing_test {

using namespace support;
using namespace support::fits;

namespace {

Sample noisy(Random &random, size_t size, double noise) {
    Sample sample;
    for (size_t i = 0; i < size; ++i) {
        const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(size);
        sample.params.push_back(t);
        double sum = 0; // about normal
        for (int k = 0; k < 12; ++k) {
            sum += random.between(-0.5, 0.5);
        }
        sample.values.push_back(std::sin(6 * t) + noise * sum);
    }
    return sample;
}

} // namespace

TEST(Smoothing, ends_in_the_polynomial_that_costs_nothing) {
    for_each_case(898000, 20, [](Random &random, uint64_t seed) {
        const Sample sample = noisy(random, 100, 0.1);
        const int order = random.whole(1, 3);
        Fit smooth(even_curve(4, 20)), line(even_curve(order - 1, order));
        smooth.options.smoothing = NURBS_SMOOTHING_LAMBDA;
        smooth.options.penalty_order = order;
        const auto wanted = eval(line(sample).get(), sample.params);
        for (const double lambda : {1e14, 1e30, 1e300, std::numeric_limits<double>::max()}) {
            smooth.options.lambda = lambda;
            const auto found = eval(smooth(sample).get(), sample.params);
            for (size_t i = 0; i < found.size(); ++i) {
                ASSERT_NEAR(found[i], wanted[i], 1e-10) << "seed " << seed << ' ' << lambda;
            }
            ASSERT_NEAR(smooth.report.freedom, order, 1e-6) << "seed " << seed << ' ' << lambda;
            ASSERT_LE(smooth.report.lambda, lambda);
        }
        smooth.options.lambda = 0;
        Fit plain(even_curve(4, 20));
        EXPECT_TRUE(same_bits(read_back(smooth(sample).get()).points, read_back(plain(sample).get()).points));
        ASSERT_NEAR(smooth.report.freedom, 20, 1e-6) << "seed " << seed;
    });
}

// What the data determine in spite of rounding a penalty does not take away.
TEST(Smoothing, of_the_highest_degree) {
    support::Random random(898400);
    const Sample sample = noisy(random, 400, 0);
    Fit fit(even_curve(31, 40));
    fit.options.smoothing = NURBS_SMOOTHING_LAMBDA;
    for (const double lambda : {1e-20, 1e-15, 1e-10}) {
        fit.options.lambda = lambda;
        (void)fit(sample);
        ASSERT_LE(fit.report.rms, std::sqrt(lambda) + 1e-13) << lambda;
        ASSERT_GE(fit.report.freedom, 0);
        ASSERT_LE(fit.report.freedom, 40);
    }
}

// With more control points than data they could all be met, and the criterion would be 0 / 0.
TEST(Smoothing, finds_the_noise_among_more_control_points_than_data) {
    for_each_case(898500, 10, [](Random &random, uint64_t seed) {
        const double noise = random.magnitude(0.01, 0.2);
        Fit curve(even_curve(3, random.whole(110, 600)));
        curve.options.smoothing = NURBS_SMOOTHING_GCV;
        (void)curve(noisy(random, 100, noise));
        ASSERT_NEAR(curve.report.sigma / noise, 1, 0.35) << "seed " << seed;
        ASSERT_LT(curve.report.freedom, 40) << "seed " << seed;

        Sample scattered{2, 1, {}, {}, {}};
        for (int i = 0; i < 400; ++i) {
            const double u = random.unit(), v = random.unit();
            scattered.params.insert(scattered.params.end(), {u, v});
            scattered.values.push_back(std::sin(6 * u) + noise * std::sqrt(3) * random.between(-1, 1));
        }
        SplineData net = even_curve(3, random.whole(24, 40));
        net.degrees.push_back(3);
        net.counts.push_back(net.counts[0]);
        net.knots.push_back(net.knots[0]);
        net.points.assign(static_cast<size_t>(net.counts[0] * net.counts[0]), 0.0);
        Fit surface(net);
        surface.options.smoothing = NURBS_SMOOTHING_GCV;
        (void)surface(scattered);
        ASSERT_NEAR(surface.report.sigma / noise, 1, 0.35) << "seed " << seed;
    });
}

TEST(Smoothing, minimises_the_criterion) {
    for_each_case(899000, 20, [](Random &random, uint64_t seed) {
        const Sample sample = noisy(random, 300, 0.1);
        Fit best(even_curve(3, 60)), other(best.over);
        best.options.smoothing = NURBS_SMOOTHING_GCV;
        (void)best(sample);
        const auto criterion = [&](const Fit &fit) {
            const double left = 300 - fit.report.freedom;
            return 300 * fit.report.squares / (left * left);
        };
        other.options.smoothing = NURBS_SMOOTHING_LAMBDA;
        for (const double factor : {0.001, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 1000.0}) {
            other.options.lambda = factor * best.report.lambda;
            (void)other(sample);
            ASSERT_LE(criterion(best), criterion(other) * (1 + 1e-5)) << "seed " << seed << ' ' << factor;
        }
        ASSERT_NEAR(best.report.sigma, 0.1, 0.03) << "seed " << seed;
    });
}

// The likelihood that remains has its noise right, too.
TEST(Smoothing, by_likelihood_finds_the_noise) {
    for_each_case(900000, 20, [](Random &random, uint64_t seed) {
        const double noise = random.magnitude(1e-4, 0.1);
        const Sample sample = noisy(random, 400, noise);
        Fit best(even_curve(3, 60));
        best.options.smoothing = NURBS_SMOOTHING_REML;
        (void)best(sample);
        ASSERT_NEAR(best.report.sigma / noise, 1, 0.2) << "seed " << seed;
    });
}

TEST(Smoothing, leaves_what_is_allowed) {
    for_each_case(901000, 20, [](Random &random, uint64_t seed) {
        const Sample sample = noisy(random, 300, 0.1);
        Fit fit(even_curve(3, 60));
        fit.options.smoothing = NURBS_SMOOTHING_DISCREPANCY;
        fit.options.target = 300 * 0.01;
        (void)fit(sample);
        ASSERT_NEAR(fit.report.squares, fit.options.target, 1e-6 * fit.options.target) << "seed " << seed;
        ASSERT_LE(fit.report.squares, fit.options.target * (1 + 1e-12)) << "seed " << seed;
        ASSERT_EQ(fit.report.bits, 0);
        fit.options.target = 1e-3;
        (void)fit(sample);
        ASSERT_EQ(fit.report.bits, NURBS_FIT_TARGET_MISSED) << "seed " << seed;
    });
}

TEST(Smoothing, keeps_conditions) {
    for_each_case(902000, 40, [](Random &random, uint64_t seed) {
        const Sample sample = noisy(random, 200, 0.1);
        Fit fit(even_curve(3, random.whole(6, 30)));
        const std::vector<double> at = {0, 0, random.between(0.1, 0.9), 1, 1};
        const std::vector<int32_t> orders = {0, 1, random.whole(0, 2), 0, 0};
        std::vector<double> targets = {random.between(-1, 1), random.between(-5, 5), random.between(-1, 1),
                                       random.between(-1, 1), 0};
        targets[4] = targets[3]; // said twice
        fit.options.conditions = 5;
        fit.options.condition_params = at.data();
        fit.options.condition_orders = orders.data();
        fit.options.condition_targets = targets.data();
        fit.options.smoothing = random.whole(0, 2);
        fit.options.lambda = 1e-6;
        const Handle made = fit(sample);
        const SplineData back = read_back(made.get());
        ASSERT_EQ(back.points.front(), targets[0]) << "seed " << seed;
        ASSERT_EQ(back.points.back(), targets[3]) << "seed " << seed;
        for (size_t i = 0; i < at.size(); ++i) {
            const auto values = eval_derivs(made.get(), 2, {at[i]});
            const double knot_step = 1.0 / static_cast<double>(back.counts[0] - 3);
            ASSERT_NEAR(values[static_cast<size_t>(orders[i])], targets[i],
                        1e-13 * extent(back) * std::pow(4 / knot_step, orders[i]))
                << "seed " << seed << " condition " << i;
        }
        Handle none;
        targets[4] += 1e-3;
        ASSERT_EQ(fit.run(sample, none), NURBS_ERROR_CONTRADICTION) << "seed " << seed;
        ASSERT_NE(last_error().find("[4]"), std::string::npos) << last_error();
    });
}

// Among all splines that fulfil the conditions none has a smaller sum: moves that keep them do not pay.
TEST(Smoothing, is_a_minimum_under_its_conditions) {
    for_each_case(903000, 20, [](Random &random, uint64_t seed) {
        const Sample sample = noisy(random, 100, 0.1);
        Fit fit(even_curve(3, 10));
        const double at = random.between(0.1, 0.9), target = 0.3;
        fit.options.conditions = 1;
        fit.options.condition_params = &at;
        fit.options.condition_targets = &target;
        const SplineData best = read_back(fit(sample).get());
        const auto squares = [&](const SplineData &spline) {
            const auto values = eval(create(spline).get(), sample.params);
            double sum = 0;
            for (size_t i = 0; i < values.size(); ++i) {
                sum += (values[i] - sample.values[i]) * (values[i] - sample.values[i]);
            }
            return sum;
        };
        for (int move = 0; move < 20; ++move) {
            SplineData moved = best;
            for (double &x : moved.points) {
                x += random.between(-1e-3, 1e-3);
            }
            const double gap = eval(create(moved).get(), {at})[0] - target;
            std::ranges::for_each(moved.points, [gap](double &x) { x -= gap; });
            ASSERT_GE(squares(moved), squares(best) * (1 - 1e-12)) << "seed " << seed;
        }
    });
}

TEST(Smoothing, tells_what_the_data_do_not_determine) {
    Sample sample;
    for (int i = 0; i < 200; ++i) {
        const double t = i / 199.0;
        if (t < 0.4 || t > 0.7) {
            sample.params.push_back(t);
            sample.values.push_back(t * t);
        }
    }
    Fit fit(even_curve(3, 23));
    Handle made;
    ASSERT_EQ(fit.run(sample, made), NURBS_ERROR_RANK);
    EXPECT_NE(last_error().find("control point"), std::string::npos);
    fit.options.regularize = 1;
    ASSERT_EQ(fit.run(sample, made), NURBS_OK) << last_error();
    // Where data are, they are met; between them the least bending continues the parabola within the error of its knots.
    EXPECT_LE(fit.report.largest, 1e-9);
    EXPECT_NEAR(eval(made.get(), {0.55})[0], 0.55 * 0.55, 0.05);
}

TEST(Smoothing, copes_with_bad_data) {
    const auto status = [](Fit &fit, const Sample &sample) {
        Handle made;
        return fit.run(sample, made);
    };
    Fit cubic(even_curve(3, 4));
    Sample sample{1, 1, {0, 0.25, 0.5, 1}, {1, 2, 3, 4}, {}};
    EXPECT_EQ(status(cubic, sample), NURBS_OK); // as many data as control points
    EXPECT_LE(cubic.report.largest, 1e-14);
    sample.params = {0, 0.5, 0.5, 1};
    EXPECT_EQ(status(cubic, sample), NURBS_ERROR_RANK);
    sample.params = {0, 0.5, 0.5 + 1e-6, 1}; // almost repeated: determined, though hardly
    EXPECT_EQ(status(cubic, sample), NURBS_OK) << last_error();
    sample.params[2] = 0.5 + 1e-10; // no better than rounding
    EXPECT_EQ(status(cubic, sample), NURBS_ERROR_RANK);
    sample = {1, 1, {0.5}, {7}, {}};
    Fit constant(even_curve(0, 1));
    EXPECT_EQ(status(constant, sample), NURBS_OK);
    EXPECT_EQ(status(cubic, sample), NURBS_ERROR_RANK);
    sample = {1, 1, {}, {}, {}};
    EXPECT_EQ(status(constant, sample), NURBS_ERROR_RANK);
    cubic.options.regularize = 1;
    EXPECT_EQ(status(cubic, sample), NURBS_OK) << last_error();
    sample = {1, 1, {0.5}, {7}, {}};
    ASSERT_EQ(status(cubic, sample), NURBS_OK) << last_error();
    EXPECT_LE(cubic.report.largest, 1e-9);
}

TEST(Smoothing, keeps_digits_beside_an_offset) {
    for_each_case(904000, 10, [](Random &random, uint64_t seed) {
        Sample sample = noisy(random, 100, 0);
        Fit fit(even_curve(3, 12));
        const SplineData one = read_back(fit(sample).get());
        std::ranges::for_each(sample.values, [](double &y) { y += 1e8; });
        const SplineData other = read_back(fit(sample).get());
        for (size_t i = 0; i < one.points.size(); ++i) {
            ASSERT_NEAR(one.points[i] + 1e8, other.points[i], 1e-6) << "seed " << seed;
        }
    });
}

} // namespace smoothing_test
