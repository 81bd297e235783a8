// Fits to a tolerance: it is met with few control points, kinks and jumps are found, and nothing depends on scale.
#include "property/fits.h"

#include <numbers>

namespace fit_tolerance_test {

using namespace support;
using namespace support::fits;

namespace {

struct Result {
    Handle spline;
    nurbs_fit_report report{};
    [[nodiscard]] int64_t count() const { return read_back(spline.get()).counts[0]; }
};

Result fitted(const Sample &sample, std::vector<int32_t> degrees, double tolerance, uint32_t flags = 0,
              int64_t max_count = 0, const double *domain = nullptr) {
    Result result;
    result.report.struct_size = sizeof result.report;
    const nurbs_data data = sample.view();
    result.spline = made([&](nurbs **out) {
        return nurbs_fit_tolerance(&data, degrees.data(), domain, tolerance, max_count, flags, nullptr,
                                   &result.report, out);
    });
    return result;
}

template <class Function>
Sample curve(int64_t n, int32_t dim, Function &&f) {
    Sample sample{1, dim, {}, {}, {}};
    for (int64_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(n - 1);
        sample.params.push_back(t);
        const std::vector<double> y = f(t);
        sample.values.insert(sample.values.end(), y.begin(), y.end());
    }
    return sample;
}

std::vector<double> flower(double t) {
    const double angle = 2 * std::numbers::pi * t, r = 1 + 0.3 * std::cos(7 * angle);
    return {r * std::cos(angle), r * std::sin(angle)};
}

double distance_at(const nurbs *g, const Sample &sample, size_t i) {
    const auto width = static_cast<size_t>(sample.axes), dim = static_cast<size_t>(sample.dim);
    const auto first = sample.params.begin() + static_cast<int64_t>(i * width);
    const auto point = eval(g, {first, first + sample.axes});
    double sum = 0;
    for (size_t c = 0; c < dim; ++c) {
        sum = std::hypot(sum, point[c] - sample.values[i * dim + c]);
    }
    return sum;
}

} // namespace

TEST(FitTolerance, is_met_with_few_control_points) {
    const Sample sample = curve(10000, 2, flower);
    for (const auto &[tolerance, most] : {std::pair{1e-2, 30}, {1e-3, 44}, {1e-4, 70}, {1e-6, 210}}) {
        const Result result = fitted(sample, {3}, tolerance);
        EXPECT_EQ(result.report.bits, 0);
        EXPECT_LE(result.count(), most) << tolerance;
        double largest = 0;
        for (size_t i = 0; i < 10000; ++i) {
            largest = std::max(largest, distance_at(result.spline.get(), sample, i));
        }
        EXPECT_LE(largest, tolerance);
        EXPECT_NEAR(result.report.largest, largest, 1e-15);
        EXPECT_NEAR(
            distance_at(result.spline.get(), sample, static_cast<size_t>(result.report.largest_index)),
            largest, 1e-15);
    }
    EXPECT_EQ(fitted(sample, {3}, 1e-6, 0, 50).report.bits, NURBS_FIT_TARGET_MISSED);
    EXPECT_LE(fitted(sample, {3}, 1e-6, 0, 50).count(), 50);
}

TEST(FitTolerance, finds_kinks_and_jumps) {
    for_each_case(910000, 20, [](Random &random, uint64_t seed) {
        const int p = random.whole(2, 5);
        const double kink = random.between(0.1, 0.4), jump = random.between(0.6, 0.9);
        Sample sample = curve(3000, 1, [&](double t) {
            return std::vector<double>{std::fabs(t - kink) + (t < jump ? 0 : 1) + 0.1 * std::sin(3 * t)};
        });
        const auto order = permutation(random, 3000); // in any order
        sample = sample.part(order);
        const Result result = fitted(sample, {p}, 1e-6);
        ASSERT_EQ(result.report.bits, 0) << "seed " << seed << " degree " << p;
        const auto knots = read_back(result.spline.get()).knots[0];
        const auto near = [&](double at, double reach) {
            return std::ranges::count_if(knots, [&](double t) { return std::fabs(t - at) <= reach; });
        };
        EXPECT_EQ(near(kink, 1e-5), p) << "seed " << seed << " degree " << p;
        EXPECT_EQ(near(jump, 1.0 / 2999), p + 1) << "seed " << seed << " degree " << p;
    });
}

// A kink and a jump are found at any tolerance at which they are in the way, so that less is not more.
TEST(FitTolerance, needs_no_more_control_points_for_a_larger_tolerance) {
    const Sample sample = curve(4000, 1, [](double t) {
        return std::vector{std::sin(5 * t) + 3 * std::abs(t - 0.37) + (t > 0.7 ? 1 : 0)};
    });
    int64_t before = 20;
    for (const double tolerance : {1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1}) {
        const Result result = fitted(sample, {3}, tolerance);
        EXPECT_EQ(result.report.bits, 0) << tolerance;
        EXPECT_LE(result.count(), before) << tolerance;
        before = result.count();
    }
}

// What does for some of the data only is looked for with all of them: short features lie between some.
TEST(FitTolerance, is_met_by_all_data_whatever_some_show) {
    const Sample sample = curve(4001, 1, [](double t) {
        double y = t;
        for (int k = 1; k < 8; ++k) {
            y += 0.01 * std::exp(-std::pow((t - (500 * k + 1) / 4000.0) * 2500, 2));
        }
        return std::vector{y};
    });
    for (const double tolerance : {5e-3, 2e-3}) {
        EXPECT_EQ(fitted(sample, {3}, tolerance).report.bits, 0) << tolerance;
    }
}

TEST(FitTolerance, is_free_of_scale) {
    const Sample sample = curve(5000, 2, flower);
    const SplineData one = read_back(fitted(sample, {3}, 1e-3).spline.get());
    Sample other = sample;
    std::ranges::for_each(other.values, [](double &y) { y *= 0x1p30; });
    std::ranges::for_each(other.params, [](double &t) { t *= 0x1p-30; });
    const SplineData two = read_back(fitted(other, {3}, 1e-3 * 0x1p30).spline.get());
    EXPECT_TRUE(same_bits(scaled(one, 0x1p30, 0x1p-30).points, two.points));
    EXPECT_TRUE(same_bits(scaled(one, 0x1p30, 0x1p-30).all_knots(), two.all_knots()));
}

TEST(FitTolerance, closes_periodic_curves_smoothly) {
    Sample sample = curve(4000, 2, flower);
    const Result open = fitted(sample, {3}, 1e-4), closed = fitted(sample, {3}, 1e-4, NURBS_PERIODIC);
    EXPECT_EQ(closed.report.bits, 0);
    EXPECT_LE(closed.count(), open.count() + 6);
    const auto start = eval_derivs(closed.spline.get(), 2, {0}),
               end = eval_derivs(closed.spline.get(), 2, {1}, NURBS_LEFT);
    for (size_t i = 0; i < start.size(); ++i) {
        EXPECT_NEAR(start[i], end[i], 1e-9);
    }
}

TEST(FitTolerance, gives_each_axis_what_it_needs) {
    for_each_case(911000, 3, [](Random &random, uint64_t seed) {
        Sample sample{2, 1, {}, {}, {}};
        for (int i = 0; i < 20000; ++i) {
            const double u = random.between(0, 1), v = random.between(0, 1);
            sample.params.insert(sample.params.end(), {u, v});
            sample.values.push_back(std::sin(12 * u) + v * v);
        }
        const std::vector<double> domain = {0, 1, 0, 1};
        const Result result = fitted(sample, {3, 3}, 1e-3, 0, 0, domain.data());
        ASSERT_EQ(result.report.bits, 0) << "seed " << seed;
        const auto counts = read_back(result.spline.get()).counts;
        EXPECT_LE(counts[0], 20) << "seed " << seed;
        EXPECT_LE(counts[1], 6) << "seed " << seed;
    });
}

TEST(FitTolerance, copes_with_few_and_noisy_data) {
    const Sample constant = curve(100, 1, [](double) { return std::vector<double>{7}; });
    EXPECT_EQ(fitted(constant, {3}, 0).count(), 4);
    const Sample two = curve(2, 1, [](double t) { return std::vector<double>{t}; });
    EXPECT_LE(fitted(two, {3}, 1e-12).report.largest, 1e-12);
    const Sample some = curve(12, 2, flower);
    EXPECT_LE(fitted(some, {3}, 1e-9).report.largest, 1e-9);
    for_each_case(912000, 2, [](Random &random, uint64_t) {
        const Sample noisy = curve(
            5000, 1, [&](double t) { return std::vector<double>{std::sin(t) + random.between(-1, 1)}; });
        const Result result = fitted(noisy, {3}, 1e-3);
        EXPECT_EQ(result.report.bits, NURBS_FIT_TARGET_MISSED);
        EXPECT_LE(result.report.largest, 2);
    });
}

// With a limit of work, counted: more control points than a tolerance needs, or the closest fit that was met.
TEST(FitTolerance, ends_at_a_limit_of_work_with_what_it_has) {
    const auto wave = [](double u, double v) { return std::sin(5 * u) * std::cos(4 * v); };
    Random random(911000);
    Sample smooth{2, 1, {}, {}, {}}, noise = smooth;
    for (int i = 0; i < 2000; ++i) {
        const double u = random.unit(), v = random.unit();
        smooth.params.insert(smooth.params.end(), {u, v});
        smooth.values.push_back(wave(u, v));
        noise.values.push_back(random.between(-1, 1));
    }
    noise.params = smooth.params;
    const auto within = [](const Sample &sample, double tolerance, int64_t work, Result &result) {
        result.report.struct_size = sizeof result.report;
        nurbs_call_options call{};
        require_ok(nurbs_call_options_init(&call, sizeof call));
        call.work = work;
        const int32_t degrees[] = {3, 3};
        const nurbs_data data = sample.view();
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_fit_tolerance_with(&data, degrees, nullptr, tolerance, 0, 0,
                                                             nullptr, &result.report, &call, &out);
        result.spline = Handle(out);
        return status;
    };
    const auto points = [](const Result &result) { return read_back(result.spline.get()).point_count(); };
    Result none, met, best, missed, closer;
    EXPECT_EQ(within(smooth, 1e-4, 100000, none), NURBS_ERROR_WORK);
    ASSERT_EQ(within(smooth, 1e-4, 40000000, met), NURBS_OK);
    ASSERT_EQ(within(smooth, 1e-4, 2000000000, best), NURBS_OK);
    EXPECT_EQ(met.report.bits, 0);
    EXPECT_LE(met.report.largest, 1e-4);
    EXPECT_EQ(best.report.bits, 0);
    EXPECT_LT(points(best), points(met));
    ASSERT_EQ(within(noise, 0, 20000000, missed), NURBS_OK);
    ASSERT_EQ(within(noise, 0, 2000000000, closer), NURBS_OK);
    EXPECT_EQ(missed.report.bits, NURBS_FIT_TARGET_MISSED);
    EXPECT_LT(closer.report.largest, missed.report.largest);
    EXPECT_EQ(distance_at(missed.spline.get(), noise, static_cast<size_t>(missed.report.largest_index)),
              missed.report.largest);
}

} // namespace fit_tolerance_test
