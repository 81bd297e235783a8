// Fits that outliers do not pull along, and how sure fits are.
#include "property/fits.h"

#include <algorithm>

namespace robust_fit_test {

using namespace support;
using namespace support::fits;

namespace {

double normal(Random &random) {
    double sum = 0; // about normal
    for (int k = 0; k < 12; ++k) {
        sum += random.between(-0.5, 0.5);
    }
    return sum;
}

Sample noisy_spline(Random &random, const SplineData &truth, size_t size, double noise) {
    Sample sample{1, truth.dim, {}, {}, {}};
    for (size_t i = 0; i < size; ++i) {
        sample.params.push_back(random.unit());
    }
    sample.values = eval(create(truth).get(), sample.params);
    for (double &value : sample.values) {
        value += noise * normal(random);
    }
    return sample;
}

SplineData any_truth(Random &random, int32_t dim) {
    SplineData truth = even_curve(random.whole(1, 4), 9, dim);
    for (double &point : truth.points) {
        point = random.between(-1, 1);
    }
    return truth;
}

double largest_difference(const nurbs *a, const nurbs *b) {
    const auto x = read_back(a).points, y = read_back(b).points;
    double most = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        most = std::max(most, std::abs(x[i] - y[i]));
    }
    return most;
}

} // namespace

// Of data that all but a quarter agree exactly Tukey's fit is theirs, in any dimension.
TEST(RobustFit, finds_what_most_data_agree_in) {
    for_each_case(946000, 40, [](Random &random, uint64_t seed) {
        const SplineData truth = any_truth(random, random.whole(1, 4));
        Sample sample{1, truth.dim, {}, {}, {}};
        for (int i = 0; i < 300; ++i) { // as many outliers everywhere
            sample.params.push_back(i / 299.0);
        }
        sample.values = eval(create(truth).get(), sample.params);
        const double scale = random.magnitude(1e-6, 1e6);
        for (size_t i = 0; i < sample.values.size(); ++i) {
            const bool spoilt = i / static_cast<size_t>(truth.dim) % 4 == 1;
            sample.values[i] = scale * (sample.values[i] + (spoilt ? random.between(1, 3) : 0));
        }
        Fit fit(truth);
        fit.options.robust = NURBS_ROBUST_TUKEY;
        const auto points = read_back(fit(sample).get()).points;
        for (size_t i = 0; i < points.size(); ++i) {
            ASSERT_NEAR(points[i], scale * truth.points[i], 1e-9 * scale) << "seed " << seed;
        }
        ASSERT_EQ(fit.report.outliers, 75) << "seed " << seed;
        ASSERT_EQ(fit.report.bits, 0) << "seed " << seed;
    });
}

// Without outliers the scale is that of the noise, and little is lost.
TEST(RobustFit, of_good_data_is_about_as_good) {
    for_each_case(947000, 30, [](Random &random, uint64_t seed) {
        const SplineData truth = any_truth(random, random.whole(1, 4));
        const double noise = random.magnitude(1e-4, 0.1);
        const Sample sample = noisy_spline(random, truth, 1500, noise);
        Fit plain(truth), robust(truth);
        const Handle best = plain(sample), exact = create(truth);
        for (const int32_t rule : {NURBS_ROBUST_HUBER, NURBS_ROBUST_TUKEY}) {
            robust.options.robust = rule;
            const Handle g = robust(sample);
            ASSERT_NEAR(robust.report.sigma / noise, 1, 0.12) << "seed " << seed;
            ASSERT_LE(largest_difference(g.get(), best.get()), noise) << "seed " << seed;
            ASSERT_GE(robust.report.squares, plain.report.squares * (1 - 1e-12)) << "seed " << seed;
        }
    });
}

// A factor for all data changes nothing, and a width without end leaves least squares.
TEST(RobustFit, has_least_squares_as_its_limit) {
    for_each_case(948000, 30, [](Random &random, uint64_t seed) {
        const SplineData truth = any_truth(random, 2);
        const Sample sample = noisy_spline(random, truth, 200, 0.1);
        Fit plain(truth), wide(truth);
        wide.options.robust = NURBS_ROBUST_HUBER;
        wide.options.robust_width = 1e6;
        const Handle a = plain(sample), b = wide(sample);
        ASSERT_EQ(largest_difference(a.get(), b.get()), 0) << "seed " << seed;
        ASSERT_EQ(wide.report.outliers, 0) << "seed " << seed;
    });
}

// Only quotients of weights count, down to the smallest doubles.
TEST(RobustFit, has_weights_of_any_size) {
    Random random(953000);
    const SplineData truth = any_truth(random, 2);
    Sample sample = noisy_spline(random, truth, 300, 0.01);
    for (size_t i = 0; i < sample.values.size(); i += 14) {
        sample.values[i] += 1;
    }
    for (const int32_t rule : {NURBS_ROBUST_HUBER, NURBS_ROBUST_TUKEY}) {
        Fit one(truth), tiny(truth);
        one.options.robust = tiny.options.robust = rule;
        sample.weights.assign(300, 1);
        const auto wanted = read_back(one(sample).get()).points;
        sample.weights.assign(300, 5e-324);
        EXPECT_TRUE(same_bits(read_back(tiny(sample).get()).points, wanted));
        EXPECT_EQ(tiny.report.outliers, one.report.outliers);
        EXPECT_EQ(tiny.report.rms, one.report.rms);
        EXPECT_EQ(tiny.report.sigma, std::ldexp(one.report.sigma, -537));
    }
}

// Powers of two are told as they are, though the squares of values overflow or vanish.
TEST(FitReport, has_the_scale_of_the_data) {
    for_each_case(948500, 20, [](Random &random, uint64_t seed) {
        const SplineData truth = any_truth(random, 2);
        Sample sample = noisy_spline(random, truth, 100, 0.1);
        for (size_t i = 0; i < 100; ++i) {
            sample.weights.push_back(random.between(0.5, 2));
        }
        for (const int32_t rule : {NURBS_ROBUST_NONE, NURBS_ROBUST_HUBER, NURBS_ROBUST_TUKEY}) {
            Fit near(truth), far(truth);
            near.options.robust = far.options.robust = rule;
            const auto points = read_back(near(sample).get()).points;
            for (const auto &[values, weights] :
                 {std::pair{900, 900}, {-900, -900}, {900, -900}, {-900, 900}, {0, 0}}) {
                Sample scaled = sample;
                for (double &value : scaled.values) {
                    value = std::ldexp(value, values);
                }
                for (double &weight : scaled.weights) {
                    weight = std::ldexp(weight, weights);
                }
                const auto same = read_back(far(scaled).get()).points;
                for (size_t i = 0; i < points.size(); ++i) {
                    ASSERT_EQ(same[i], std::ldexp(points[i], values)) << "seed " << seed;
                }
                ASSERT_EQ(far.report.rms, std::ldexp(near.report.rms, values)) << "seed " << seed;
                ASSERT_EQ(far.report.sigma, std::ldexp(near.report.sigma, values + weights / 2))
                    << "seed " << seed;
                ASSERT_EQ(far.report.largest, std::ldexp(near.report.largest, values)) << "seed " << seed;
                ASSERT_EQ(far.report.squares, std::ldexp(near.report.squares, 2 * values + weights))
                    << "seed " << seed;
                ASSERT_EQ(far.report.rounds, near.report.rounds) << "seed " << seed;
            }
        }
    });
}

// --- Standard errors ---

// By many fits of new noise.
TEST(FitErrors, are_the_deviations_of_fits) {
    for_each_case(949000, 4, [](Random &random, uint64_t seed) {
        SplineData truth = any_truth(random, 1);
        const Sample clean = noisy_spline(random, truth, 100, 0);
        const std::vector<double> at{0, 0.1, 0.37, 0.5, 0.9, 1};
        const Statistics none = made_statistics([&](nurbs_statistics **out) {
            std::vector<double> breaks = truth.knots[0];
            breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
            const int64_t count = std::ssize(breaks);
            return nurbs_statistics_create(1, truth.degrees.data(), &count, breaks.data(), count, 1, 4, 1,
                                           out);
        });
        const nurbs_data data = clean.view();
        const Statistics all = made_statistics(
            [&](nurbs_statistics **out) { return nurbs_statistics_add(none.get(), &data, out); });
        std::vector<double> errors(at.size()), sums(at.size(), 0.0);
        require_ok(nurbs_fit_errors(all.get(), create(truth).get(), 1, 0, 0.1, std::ssize(at), at.data(), 0,
                                    0, 0, errors.data()));
        constexpr int trials = 800;
        const auto exact = eval(create(truth).get(), at);
        Fit fit(truth);
        for (int i = 0; i < trials; ++i) {
            Sample sample = clean;
            for (double &value : sample.values) {
                value += 0.1 * normal(random);
            }
            const auto found = eval(fit(sample).get(), at);
            for (size_t k = 0; k < at.size(); ++k) {
                sums[k] += (found[k] - exact[k]) * (found[k] - exact[k]);
            }
        }
        for (size_t k = 0; k < at.size(); ++k) {
            ASSERT_NEAR(std::sqrt(sums[k] / trials) / errors[k], 1, 0.12) << "seed " << seed << ' ' << at[k];
        }
    });
}

// On every axis count: without a penalty the sum of squared errors at the data is the number of control points.
TEST(FitErrors, add_up_to_the_trace_of_the_influence_matrix) {
    for_each_case(950000, 12, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3), p = random.whole(1, 3);
        const SplineData line = even_curve(p, p + random.whole(1, 3));
        SplineData net = line;
        for (int k = 1; k < axes; ++k) {
            net.degrees.push_back(line.degrees[0]);
            net.counts.push_back(line.counts[0]);
            net.knots.push_back(line.knots[0]);
        }
        net.points.assign(static_cast<size_t>(net.point_count()), 0.0);
        Sample sample{axes, 1, {}, {}, {}};
        for (int64_t i = 0; i < 6 * net.point_count(); ++i) {
            for (int k = 0; k < axes; ++k) {
                sample.params.push_back(random.unit());
            }
            sample.values.push_back(0);
            sample.weights.push_back(random.between(0.5, 4));
        }
        std::vector<double> breaks;
        std::vector<int64_t> counts;
        for (int k = 0; k < axes; ++k) {
            std::vector<double> own = line.knots[0];
            own.erase(std::unique(own.begin(), own.end()), own.end());
            breaks.insert(breaks.end(), own.begin(), own.end());
            counts.push_back(std::ssize(own));
        }
        const Statistics none = made_statistics([&](nurbs_statistics **out) {
            return nurbs_statistics_create(axes, net.degrees.data(), counts.data(), breaks.data(),
                                           std::ssize(breaks), 1, 1, 4, out);
        });
        const nurbs_data data = sample.view();
        const Statistics all = made_statistics(
            [&](nurbs_statistics **out) { return nurbs_statistics_add(none.get(), &data, out); });
        for (const double lambda : {0.0, 0.01}) {
            Fit fit(net);
            fit.options.smoothing = NURBS_SMOOTHING_LAMBDA;
            fit.options.penalty_order = 1;
            fit.options.lambda = lambda;
            const Handle g = fit(all);
            std::vector<double> errors(static_cast<size_t>(sample.size()));
            require_ok(nurbs_fit_errors(all.get(), g.get(), 1, lambda, 1, sample.size(), sample.params.data(),
                                        0, 0, 0, errors.data()));
            double sum = 0;
            for (size_t i = 0; i < errors.size(); ++i) {
                sum += sample.weights[i] * errors[i] * errors[i];
            }
            ASSERT_NEAR(sum, fit.report.freedom, 1e-9 * fit.report.freedom) << "seed " << seed;
        }
    });
}

} // namespace robust_fit_test
