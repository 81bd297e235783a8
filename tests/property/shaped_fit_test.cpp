// Fits of a prescribed shape: they have it, exactly, and nothing that has it is closer to the data.
#include "property/compositions.h"
#include "property/fits.h"

#include <algorithm>
#include <functional>

namespace shaped_fit_test {

using namespace support;
using namespace support::fits;
using reference::Rational;

namespace {

constexpr int32_t shapes[] = {NURBS_TREND_RISING,
                              NURBS_TREND_FALLING,
                              NURBS_TREND_CONVEX,
                              NURBS_TREND_CONCAVE,
                              NURBS_TREND_RISING + NURBS_TREND_CONVEX,
                              NURBS_TREND_FALLING + NURBS_TREND_CONVEX,
                              NURBS_TREND_RISING + NURBS_TREND_CONCAVE};

Sample wild(Random &random, size_t size, double scale) {
    Sample sample;
    for (size_t i = 0; i < size; ++i) {
        sample.params.push_back(random.unit());
        sample.values.push_back(scale * random.between(-1, 1));
    }
    return sample;
}

// Of a curve over clamped knots that has the shape, but for rounding.
std::vector<double> any_points(Random &random, const SplineData &over, int32_t shape, double scale) {
    const size_t p = static_cast<size_t>(over.degrees[0]);
    std::vector<double> slopes(static_cast<size_t>(over.counts[0] - 1));
    for (double &slope : slopes) {
        slope = random.between((shape & NURBS_TREND_RISING) != 0 ? 0 : -1,
                               (shape & NURBS_TREND_FALLING) != 0 ? 0 : 1);
    }
    if ((shape & NURBS_TREND_CONVEX) != 0) {
        std::ranges::sort(slopes);
    } else if ((shape & NURBS_TREND_CONCAVE) != 0) {
        std::ranges::sort(slopes, std::greater());
    }
    std::vector<double> points{scale * random.between(-1, 1)};
    for (size_t j = 0; j < slopes.size(); ++j) {
        points.push_back(points.back() +
                         scale * slopes[j] * (over.knots[0][j + p + 1] - over.knots[0][j + 1]));
    }
    return points;
}

double squares_of(const SplineData &over, const std::vector<double> &points, const Sample &sample) {
    SplineData moved = over;
    moved.points = points;
    const auto values = eval(create(moved).get(), sample.params);
    double sum = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        sum += (values[i] - sample.values[i]) * (values[i] - sample.values[i]);
    }
    return sum;
}

// In exact arithmetic.
bool has_shape(const SplineData &over, const std::vector<double> &points, int32_t shape) {
    const size_t p = static_cast<size_t>(over.degrees[0]);
    const std::vector<double> &knots = over.knots[0];
    const auto slope = [&](size_t j) -> Rational {
        return (Rational(points[j + 1]) - Rational(points[j])) /
               (Rational(knots[j + p + 1]) - Rational(knots[j + 1]));
    };
    bool all = true;
    for (size_t j = 0; j + 1 < points.size(); ++j) {
        all = all && ((shape & NURBS_TREND_RISING) == 0 || points[j] <= points[j + 1]);
        all = all && ((shape & NURBS_TREND_FALLING) == 0 || points[j] >= points[j + 1]);
        if (j + 2 < points.size() && (shape & (NURBS_TREND_CONVEX | NURBS_TREND_CONCAVE)) != 0) {
            const Rational bend = slope(j + 1) - slope(j);
            all = all && ((shape & NURBS_TREND_CONVEX) != 0 ? bend >= 0 : bend <= 0);
        }
    }
    return all;
}

} // namespace

TEST(ShapedFit, is_the_closest_one_and_has_its_shape_exactly) {
    for_each_case(941000, 60, [](Random &random, uint64_t seed) {
        const int p = random.whole(1, 5);
        Fit fit(even_curve(p, p + random.whole(2, 25)));
        const double scale = random.magnitude(1e-6, 1e6);
        const int32_t shape = shapes[random.whole(0, 6)];
        const Sample sample = wild(random, 200, scale);
        fit.options.shapes = &shape;
        const auto points = read_back(fit(sample).get()).points;
        ASSERT_TRUE(has_shape(fit.over, points, shape)) << "seed " << seed;
        const double least = squares_of(fit.over, points, sample);
        for (int i = 0; i < 20; ++i) {
            const auto other = any_points(random, fit.over, shape, scale);
            // A step towards it, whose derivative is not negative.
            std::vector<double> nearer = points;
            for (size_t j = 0; j < points.size(); ++j) {
                nearer[j] += (other[j] - points[j]) / 1024;
            }
            ASSERT_GE(squares_of(fit.over, nearer, sample), least * (1 - 1e-13)) << "seed " << seed;
        }
    });
}

// Where the data have the shape it costs nothing.
TEST(ShapedFit, of_data_that_have_it_is_that_without_it) {
    for_each_case(942000, 40, [](Random &random, uint64_t seed) {
        const int p = random.whole(1, 5);
        Fit fit(even_curve(p, p + random.whole(2, 25)));
        const int32_t shape = shapes[random.whole(0, 6)];
        SplineData shaped = fit.over;
        shaped.points = any_points(random, fit.over, shape, 1);
        Sample sample = wild(random, 300, 1);
        sample.values = eval(create(shaped).get(), sample.params);
        fit.options.shapes = &shape;
        const auto points = read_back(fit(sample).get()).points;
        for (size_t i = 0; i < points.size(); ++i) {
            ASSERT_NEAR(points[i], shaped.points[i], 1e-10) << "seed " << seed;
        }
    });
}

// A penalty that decides what few data leave open takes nothing from them, where a spline of the shape meets them.
TEST(ShapedFit, of_few_data_meets_them) {
    for_each_case(942100, 40, [](Random &random, uint64_t seed) {
        const int p = random.whole(1, 4);
        Fit fit(even_curve(p, p + random.whole(8, 25)));
        const int32_t shape = shapes[random.whole(0, 6)];
        SplineData shaped = fit.over;
        shaped.points = any_points(random, fit.over, shape, 1);
        Sample sample = wild(random, 8, 1);
        sample.values = eval(create(shaped).get(), sample.params);
        fit.options.shapes = &shape;
        fit.options.regularize = 1;
        const auto points = read_back(fit(sample).get()).points;
        ASSERT_TRUE(has_shape(fit.over, points, shape)) << "seed " << seed;
        ASSERT_LE(std::sqrt(squares_of(fit.over, points, sample)), 1e-14) << "seed " << seed;
        ASSERT_EQ(fit.report.freedom, std::round(fit.report.freedom)) << "seed " << seed;
        ASSERT_LE(fit.report.freedom, 8) << "seed " << seed;
    });
}

// Scales, reversal, and coordinates by themselves.
TEST(ShapedFit, does_not_depend_on_scales) {
    for_each_case(943000, 30, [](Random &random, uint64_t seed) {
        const int p = random.whole(1, 4);
        Fit fit(even_curve(p, p + 12));
        const int32_t rising = NURBS_TREND_RISING, falling = NURBS_TREND_FALLING;
        const Sample sample = wild(random, 150, 1);
        fit.options.shapes = &rising;
        const auto points = read_back(fit(sample).get()).points;
        Sample large = sample, reversed = sample;
        for (size_t i = 0; i < sample.values.size(); ++i) {
            large.values[i] *= 0x1p40;
            reversed.params[i] = 1 - sample.params[i];
        }
        const auto larger = read_back(fit(large).get()).points;
        fit.options.shapes = &falling;
        const auto back = read_back(fit(reversed).get()).points;
        for (size_t i = 0; i < points.size(); ++i) {
            ASSERT_NEAR(larger[i] * 0x1p-40, points[i], 1e-15) << "seed " << seed;
            ASSERT_NEAR(back[points.size() - 1 - i], points[i], 1e-13) << "seed " << seed;
        }
    });
}

TEST(ShapedFit, of_surfaces_and_with_bounds) {
    for_each_case(944000, 12, [](Random &random, uint64_t seed) {
        Sample sample{2, 1, {}, {}, {}};
        for (int i = 0; i < 400; ++i) {
            const double u = random.unit(), v = random.unit();
            sample.params.insert(sample.params.end(), {u, v});
            sample.values.push_back(u * u - v + 0.3 * random.between(-1, 1));
        }
        const SplineData line = even_curve(random.whole(1, 3), 7);
        SplineData net{};
        net = line;
        net.degrees.push_back(line.degrees[0]);
        net.counts.push_back(7);
        net.knots.push_back(line.knots[0]);
        net.points.assign(49, 0.0);
        Fit fit(net);
        const int32_t along[] = {NURBS_TREND_RISING + NURBS_TREND_CONVEX, NURBS_TREND_FALLING};
        const double lower = -0.75, upper = 0.5;
        fit.options.shapes = along;
        fit.options.lower = &lower;
        fit.options.upper = &upper;
        const auto points = read_back(fit(sample).get()).points;
        for (size_t i = 0; i < 7; ++i) {
            std::vector<double> column, row(points.begin() + static_cast<int64_t>(7 * i),
                                            points.begin() + static_cast<int64_t>(7 * i + 7));
            for (size_t j = 0; j < 7; ++j) {
                column.push_back(points[7 * j + i]);
            }
            ASSERT_TRUE(has_shape(line, column, along[0])) << "seed " << seed;
            ASSERT_TRUE(has_shape(line, row, along[1])) << "seed " << seed;
        }
        for (const double point : points) {
            ASSERT_TRUE(point >= lower && point <= upper) << "seed " << seed;
        }
    });
}

// Over knots that are not clamped it holds within rounding, and at the ends of the domain as well.
TEST(ShapedFit, over_knots_without_clamped_ends) {
    for_each_case(945000, 30, [](Random &random, uint64_t seed) {
        const int p = random.whole(1, 5);
        SplineData over = even_curve(p, p + 8);
        for (int i = 1; i <= p; ++i) {
            over.knots[0][static_cast<size_t>(p - i)] = -i * 0.125;
            over.knots[0][over.knots[0].size() - 1 - static_cast<size_t>(p - i)] = 1 + i * 0.125;
        }
        Fit fit(over);
        const int32_t rising = NURBS_TREND_RISING;
        fit.options.shapes = &rising;
        const Handle g = fit(wild(random, 150, 1));
        std::vector<double> params;
        for (int i = 0; i <= 200; ++i) {
            params.push_back(i / 200.0);
        }
        const auto values = eval(g.get(), params);
        for (size_t i = 1; i < values.size(); ++i) {
            ASSERT_GE(values[i], values[i - 1] - 1e-12) << "seed " << seed;
        }
    });
}

} // namespace shaped_fit_test
