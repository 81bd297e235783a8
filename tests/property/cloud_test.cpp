// Fits of points without parameters: splines come back, noise stays outside, and neither order nor unit matters.
#include "property/fits.h"

#include <limits>
#include <numbers>

namespace cloud_test {

using namespace support;
using namespace support::fits;
using support::products::set_axis;

namespace {

struct Cloud {
    int32_t dim = 2;
    std::vector<double> points, weights;

    [[nodiscard]] int64_t size() const { return std::ssize(points) / dim; }
    void add(const std::vector<double> &point) { points.insert(points.end(), point.begin(), point.end()); }
};

struct CloudFit {
    nurbs_cloud_options options{};
    nurbs_cloud_report report{};

    CloudFit() {
        require_ok(nurbs_cloud_options_init(&options, sizeof options));
        report.struct_size = sizeof report;
    }
    Handle operator()(const Handle &start, const Cloud &cloud) {
        return made([&](nurbs **out) {
            return nurbs_fit_cloud(start.get(), cloud.size(), cloud.points.data(), 0, 0,
                                   cloud.weights.empty() ? nullptr : cloud.weights.data(), 0, &options,
                                   &report, out);
        });
    }
    [[nodiscard]] bool converged() const { return (report.bits & NURBS_CLOUD_NOT_CONVERGED) == 0; }
};

Handle start_for(const Cloud &cloud, const SplineData &over) {
    const auto knots = over.all_knots();
    return made([&](nurbs **out) {
        return nurbs_cloud_start(over.axes(), over.degrees.data(), over.counts.data(), knots.data(),
                                 std::ssize(knots), cloud.size(), cloud.dim, cloud.points.data(), 0, 0,
                                 over.flags, out);
    });
}

// --- Spaces ---

SplineData even_axes(std::vector<int32_t> degrees, std::vector<int64_t> counts, int32_t dim) {
    SplineData data;
    data.dim = dim;
    for (size_t k = 0; k < degrees.size(); ++k) {
        set_axis(data, degrees[k], even_curve(degrees[k], counts[k]).knots[0]);
    }
    data.points.resize(static_cast<size_t>(data.point_count() * dim));
    return data;
}

SplineData ring(int degree, int spans, int32_t dim = 2) {
    SplineData data;
    std::vector<double> knots;
    for (int i = -degree; i <= spans + degree; ++i) {
        knots.push_back(static_cast<double>(i) / spans);
    }
    set_axis(data, degree, knots);
    data.dim = dim;
    data.flags = NURBS_PERIODIC;
    return data;
}

// Control points over their places in the domain, with bends.
SplineData bent(Random &random, SplineData data, double size) {
    for (int64_t i = 0; i < data.point_count(); ++i) {
        int64_t rest = i;
        for (int k = data.axes() - 1; k >= 0; --k) {
            const int64_t count = data.counts[static_cast<size_t>(k)];
            data.points[static_cast<size_t>(i * data.dim + k)] = static_cast<double>(rest % count);
            rest /= count;
        }
        for (int c = data.axes(); c < data.dim; ++c) {
            data.points[static_cast<size_t>(i * data.dim + c)] = random.between(-size, size);
        }
    }
    return data;
}

SplineData shaken(Random &random, SplineData data, double size) {
    for (double &x : data.points) {
        x += random.between(-size, size);
    }
    return data;
}

// Points of a spline over [0, 1]^axes, its corners among them.
Cloud on(Random &random, const Handle &g, int axes, int32_t dim, int n) {
    Cloud cloud{dim, {}, {}};
    for (int i = 0; i < n; ++i) {
        std::vector<double> params;
        for (int k = 0; k < axes; ++k) {
            params.push_back(i < 1 << axes ? i >> k & 1 : random.unit());
        }
        cloud.add(eval(g.get(), params));
    }
    return cloud;
}

double gauss(Random &random) {
    return std::sqrt(-2 * std::log1p(-random.unit())) * std::cos(2 * std::numbers::pi * random.unit());
}

std::vector<double> control_points(const Handle &g) {
    return read_back(g.get()).points;
}

// --- Laws ---

TEST(Clouds, CurvesComeBackFromNear) {
    Random random(1);
    for (int round = 0; round < 8; ++round) {
        const int32_t degree = random.whole(2, 4), dim = 2 + round % 2;
        const SplineData data = bent(random, even_axes({degree}, {10}, dim), 1.5);
        const Cloud cloud = on(random, create(data), 1, dim, 1000);
        CloudFit fit;
        const Handle g = fit(create(shaken(random, data, 0.1)), cloud);
        EXPECT_TRUE(fit.converged()) << round;
        EXPECT_LT(fit.report.largest, 1e-9) << round << " after " << fit.report.rounds;
        EXPECT_EQ(fit.report.uncertified, 0);
    }
}

TEST(Clouds, SurfacesComeBackFromNear) {
    Random random(2);
    const SplineData data = bent(random, even_axes({3, 2}, {6, 5}, 3), 0.7);
    const Cloud cloud = on(random, create(data), 2, 3, 1500);
    CloudFit fit;
    const Handle g = fit(create(shaken(random, data, 0.03)), cloud);
    EXPECT_TRUE(fit.converged());
    EXPECT_LT(fit.report.largest, 1e-9) << fit.report.rounds;
}

TEST(Clouds, LinesAndPlanesAreTheirOwnStart) {
    Random random(3);
    Cloud line, plane{3, {}, {}};
    for (int i = 0; i < 300; ++i) {
        const double u = random.unit(), v = random.unit();
        line.add({1 + 2 * u, 3 - u});
        plane.add({u + v, u - 3 * v, 2 * u});
    }
    CloudFit fit;
    (void)fit(start_for(line, even_axes({3}, {8}, 2)), line);
    EXPECT_LT(fit.report.largest, 1e-14);
    EXPECT_EQ(fit.report.rounds, 1);
    (void)fit(start_for(plane, even_axes({3, 3}, {6, 6}, 3)), plane);
    EXPECT_LT(fit.report.largest, 1e-14);
}

// A circle with noise across it: what is left is the noise, as with known parameters, and the circle is much nearer.
TEST(Clouds, NoiseStaysOutsideACircle) {
    constexpr double sigma = 0.01;
    constexpr int n = 3000;
    Random random(4);
    Cloud cloud;
    Sample known{1, 2, {}, {}, {}};
    for (int i = 0; i < n; ++i) {
        const double t = (i + 0.5) / n, r = 1 + sigma * gauss(random);
        cloud.add({r * std::cos(2 * std::numbers::pi * t), r * std::sin(2 * std::numbers::pi * t)});
        known.params.push_back(t);
    }
    known.values = cloud.points;
    CloudFit fit;
    const Handle g = fit(start_for(cloud, ring(3, 12)), cloud);
    EXPECT_TRUE(fit.converged());
    EXPECT_NEAR(fit.report.rms, sigma, 0.05 * sigma);
    Fit with_parameters(ring(3, 12));
    (void)with_parameters(known);
    EXPECT_NEAR(fit.report.rms, with_parameters.report.rms, 0.01 * sigma);
    for (int i = 0; i < 100; ++i) {
        const auto at = eval(g.get(), {i / 100.0});
        EXPECT_NEAR(std::hypot(at[0], at[1]), 1, 0.25 * sigma) << i;
    }
    EXPECT_EQ(fit.report.boundary, 0);
}

TEST(Clouds, NoiseStaysOutsideAHalfSphere) {
    constexpr double sigma = 0.01;
    Random random(5);
    Cloud cloud{3, {}, {}};
    while (cloud.size() < 2500) {
        const double x = gauss(random), y = gauss(random), z = std::abs(gauss(random));
        const double r = (1 + sigma * gauss(random)) / std::hypot(x, y, z);
        cloud.add({r * x, r * y, r * z});
    }
    CloudFit fit;
    const Handle g = fit(start_for(cloud, even_axes({3, 3}, {7, 7}, 3)), cloud);
    EXPECT_NEAR(fit.report.rms, sigma, 0.07 * sigma);
    EXPECT_EQ(fit.report.uncertified, 0);
    for (int i = 0; i < 100; ++i) {
        const auto at = eval(g.get(), {0.2 + 0.06 * (i % 10), 0.2 + 0.06 * (i / 10)});
        EXPECT_NEAR(std::hypot(at[0], at[1], at[2]), 1, sigma) << i;
    }
}

// Without a penalty the surface folds, to come nearer to the points.
TEST(Clouds, NoiseFoldsNoSurface) {
    constexpr double sigma = 0.01;
    Random random(12);
    Cloud cloud{3, {}, {}};
    for (int i = 0; i < 2500; ++i) {
        const double u = random.unit(), v = random.unit(), z = 0.3 * std::sin(4 * u) * std::cos(3 * v);
        cloud.add({u + sigma * gauss(random), v + sigma * gauss(random), z + sigma * gauss(random)});
    }
    CloudFit fit;
    const Handle g = fit(start_for(cloud, even_axes({3, 3}, {8, 8}, 3)), cloud);
    EXPECT_NEAR(fit.report.rms, sigma, 0.07 * sigma);
    EXPECT_LT(extent(read_back(g.get())), 2);
    EXPECT_GT(fit.report.lambda, 0);
}

Cloud noisy_arc(uint64_t seed, int n) {
    Random random(seed);
    Cloud cloud;
    for (int i = 0; i < n; ++i) {
        const double t = 3 * random.unit();
        cloud.add({5 * t + 0.02 * gauss(random), std::sin(2 * t) + 0.02 * gauss(random)});
        cloud.weights.push_back(random.between(0.5, 2));
    }
    return cloud;
}

TEST(Clouds, OrderDoesNotMatter) {
    Cloud cloud = noisy_arc(6, 500);
    CloudFit fit, other;
    const SplineData space = even_axes({3}, {9}, 2);
    const Handle g = fit(start_for(cloud, space), cloud);
    Random random(7);
    Cloud mixed;
    const auto order = permutation(random, 500);
    for (const size_t i : order) {
        mixed.add({cloud.points[2 * i], cloud.points[2 * i + 1]});
        mixed.weights.push_back(cloud.weights[i]);
    }
    const Handle same = other(start_for(mixed, space), mixed);
    EXPECT_EQ(control_points(g), control_points(same));
    EXPECT_EQ(fit.report.squares, other.report.squares);
    EXPECT_EQ(static_cast<size_t>(fit.report.largest_index),
              order[static_cast<size_t>(other.report.largest_index)]);
}

TEST(Clouds, UnitsDoNotMatter) {
    const Cloud cloud = noisy_arc(8, 400);
    const SplineData space = even_axes({3}, {9}, 2);
    CloudFit fit;
    const auto wanted = control_points(fit(start_for(cloud, space), cloud));
    for (const double unit : {1e-6, 1e6, 0x1p-700, 0x1p600}) {
        for (const double weight : {1.0, 1e-200, 0x1p300}) {
            Cloud scaled = cloud;
            for (double &x : scaled.points) {
                x *= unit;
            }
            for (double &w : scaled.weights) {
                w *= weight;
            }
            CloudFit other;
            const auto found = control_points(other(start_for(scaled, space), scaled));
            EXPECT_EQ(other.report.rounds, fit.report.rounds);
            int exponent = 0;
            const bool exact = std::frexp(unit, &exponent) == 0.5 && std::frexp(weight, &exponent) == 0.5;
            for (size_t i = 0; i < wanted.size(); ++i) {
                EXPECT_NEAR(found[i] / unit, wanted[i], exact ? 0 : 1e-6) << unit << ' ' << weight;
            }
        }
    }
}

TEST(Clouds, TheSumNeverRises) {
    Random random(9);
    const SplineData data = bent(random, even_axes({3}, {12}, 2), 2);
    const Cloud cloud = on(random, create(data), 1, 2, 300);
    const Handle start = create(shaken(random, data, 2)); // so far away that steps are too long
    double before = HUGE_VAL;
    for (int rounds = 1; rounds < 25; ++rounds) {
        CloudFit fit;
        fit.options.rounds = rounds;
        fit.options.lambda = fit.options.first_lambda = 0;
        (void)fit(start, cloud);
        EXPECT_LE(fit.report.rounds, rounds);
        EXPECT_LE(fit.report.squares, before) << rounds;
        before = fit.report.squares;
    }
    EXPECT_LT(before, 10);
}

// Kinks, jumps and ends that are not clamped; a volume in four dimensions.
TEST(Clouds, AnyPolynomialStartWillDo) {
    Random random(10);
    const Cloud cloud = noisy_arc(11, 400);
    std::vector<SplineData> spaces(4);
    set_axis(spaces[0], 1, {0, 0, 0.2, 0.4, 0.6, 0.8, 1, 1});
    set_axis(spaces[1], 2, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1});
    set_axis(spaces[2], 3, {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6});
    set_axis(spaces[3], 0, {0, 1, 2, 3});
    for (const SplineData &space : spaces) {
        CloudFit first, fit;
        const Handle start = start_for(cloud, space);
        first.options.rounds = 1;
        (void)first(start, cloud);
        (void)fit(start, cloud);
        EXPECT_LT(fit.report.rms, (space.degrees[0] == 0 ? 0.9999 : 0.5) * first.report.rms)
            << space.degrees[0];
        EXPECT_EQ(fit.report.data_count, 400);
    }
    const SplineData volume = bent(random, even_axes({2, 1, 1}, {3, 2, 2}, 4), 0.3);
    CloudFit fit;
    (void)fit(create(shaken(random, volume, 0.02)), on(random, create(volume), 3, 4, 300));
    EXPECT_LT(fit.report.largest, 1e-4);
}

// --- Offsets ---

constexpr double finest = 0x1p-20; // digit of coordinates

double rounded(double x) {
    return std::round(x / finest) * finest;
}

std::vector<double> moved(const std::vector<double> &points, const std::vector<double> &by) {
    std::vector<double> result = points;
    for (size_t i = 0; i < result.size(); ++i) {
        result[i] += by[i % by.size()];
    }
    return result;
}

// An arc about 0.
Cloud arc_about_zero() {
    Cloud cloud = noisy_arc(13, 500);
    for (size_t i = 0; i < cloud.points.size(); ++i) {
        cloud.points[i] = rounded(cloud.points[i] - (i % 2 == 0 ? 7.5 : 0));
    }
    return cloud;
}

// Offsets that coordinates can have without being rounded change the control points by themselves, rounded once.
TEST(Clouds, OffsetsDoNotMatter) {
    const Cloud cloud = arc_about_zero();
    const SplineData space = even_axes({3}, {9}, 2);
    SplineData start = read_back(start_for(cloud, space).get());
    const std::vector<double> found_start = start.points;
    for (double &x : start.points) {
        x = rounded(x);
    }
    CloudFit fit;
    const auto wanted = control_points(fit(create(start), cloud));
    for (const double size : {0x1p10, 0x1p20, 0x1p30}) {
        const std::vector<double> by{size, -1.5 * size};
        Cloud far = cloud;
        far.points = moved(cloud.points, by);
        SplineData far_start = start;
        far_start.points = moved(start.points, by);
        CloudFit other;
        EXPECT_EQ(control_points(start_for(far, space)), moved(found_start, by)) << size;
        EXPECT_EQ(control_points(other(create(far_start), far)), moved(wanted, by)) << size;
        EXPECT_EQ(other.report.rounds, fit.report.rounds);
        EXPECT_EQ(other.report.lambda, fit.report.lambda);
        EXPECT_NEAR(other.report.largest, fit.report.largest, other.report.noise);
        EXPECT_LT(other.report.noise, 4096 * 0x1p-52 * size);
    }
}

// Points that are no farther apart than a few last digits, and far less than that along an axis.
TEST(Clouds, OffsetsMayBeAllThereIs) {
    Cloud same{3, {}, {}}, close;
    for (int i = 0; i < 50; ++i) {
        same.add({1e300, -3, 7});
        close.add({1e300, 1e-320 * (i % 7)});
    }
    CloudFit fit;
    (void)fit(start_for(same, even_axes({2, 2}, {4, 4}, 3)), same);
    EXPECT_EQ(fit.report.squares, 0);
    (void)fit(start_for(close, even_axes({3}, {6}, 2)), close);
    EXPECT_LE(fit.report.largest, fit.report.noise);
    EXPECT_LE(fit.report.rms, fit.report.largest);
}

// --- Large factors ---

// The smallest root mean square of distances from a line.
double rms_of_line(const Cloud &cloud) {
    double w = 0, mean[2] = {}, xx = 0, xy = 0, yy = 0;
    for (size_t i = 0; i < cloud.weights.size(); ++i) {
        w += cloud.weights[i];
        mean[0] += cloud.weights[i] * cloud.points[2 * i];
        mean[1] += cloud.weights[i] * cloud.points[2 * i + 1];
    }
    for (size_t i = 0; i < cloud.weights.size(); ++i) {
        const double x = cloud.points[2 * i] - mean[0] / w, y = cloud.points[2 * i + 1] - mean[1] / w;
        xx += cloud.weights[i] * x * x;
        xy += cloud.weights[i] * x * y;
        yy += cloud.weights[i] * y * y;
    }
    return std::sqrt((xx + yy - std::hypot(xx - yy, 2 * xy)) / 2 / w);
}

// Whatever the start is, a line is left, that of least squares but for its ends; and factors that large are all the same.
TEST(Clouds, HugeFactorsLeaveLines) {
    const Cloud cloud = noisy_arc(14, 500);
    for (const int64_t count : {9, 100}) {
        const Handle line = start_for(cloud, even_axes({3}, {count}, 2));
        CloudFit bent;
        const Handle curve = bent(line, cloud);
        std::vector<double> wanted;
        for (const Handle *start : {&line, &curve}) {
            wanted.clear();
            for (const double lambda : {1e20, 1e300, std::numeric_limits<double>::max()}) {
                CloudFit fit;
                fit.options.lambda = lambda;
                const Handle g = fit(*start, cloud);
                EXPECT_TRUE(fit.converged()) << count << ' ' << lambda;
                EXPECT_LT(fit.report.lambda, 1e9); // that of where lines begin
                EXPECT_NEAR(fit.report.rms, rms_of_line(cloud), 1e-3 * rms_of_line(cloud));
                const auto first = eval(g.get(), {0}), middle = eval(g.get(), {0.5}),
                           last = eval(g.get(), {1});
                for (size_t c = 0; c < 2; ++c) {
                    EXPECT_NEAR(middle[c], (first[c] + last[c]) / 2, 1e-6) << count << ' ' << lambda;
                }
                const auto found = control_points(g);
                EXPECT_EQ(found, wanted.empty() ? found : wanted);
                wanted = found;
            }
        }
    }
}

TEST(Clouds, HugeFactorsLeavePlanes) {
    Random random(15);
    Cloud cloud{3, {}, {}};
    for (int i = 0; i < 400; ++i) {
        const double u = 2 * random.unit() - 1, v = random.unit();
        cloud.add({u, v, u + v + 0.1 * u * u});
    }
    CloudFit fit;
    fit.options.lambda = 1e300;
    const auto at = read_back(fit(start_for(cloud, even_axes({3, 2}, {6, 5}, 3)), cloud).get()).points;
    EXPECT_TRUE(fit.converged());
    EXPECT_LT(fit.report.rms, 0.1);
    const auto point = [&](size_t i, size_t j, size_t c) { return at[(5 * i + j) * 3 + c]; };
    for (size_t c = 0; c < 3; ++c) { // inside, control points are evenly far apart
        EXPECT_NEAR(point(2, 2, c) + point(3, 2, c), point(0, 2, c) + point(5, 2, c), 1e-6);
        EXPECT_NEAR(point(2, 1, c) + point(2, 3, c), point(2, 0, c) + point(2, 4, c), 1e-6);
    }
}

// --- Numbers far apart ---

// Beside a point that is very far away, the others' distances are as large as they are.
TEST(Clouds, SquaresBesideAFarPoint) {
    SplineData line = even_axes({1}, {2}, 2);
    line.points = {0, 0, 1e300, 0};
    Cloud cloud{2, {}, {}};
    for (int i = 0; i < 25; ++i) {
        cloud.add({0, 3});
    }
    cloud.add({1e300, 0});
    CloudFit fit;
    fit.options.rounds = 1;
    (void)fit(create(line), cloud);
    EXPECT_NEAR(fit.report.squares, 25 * 9, 1e-12);
    EXPECT_NEAR(fit.report.rms, std::sqrt(25 * 9 / 26.0), 1e-14);
    EXPECT_EQ(fit.report.largest, 3);
}

// A lambda beyond the largest one that changes anything acts as the one that is told.
TEST(Clouds, TheLambdaThatWasUsed) {
    Random random(15);
    Cloud cloud{2, {}, {}};
    for (int i = 0; i < 100; ++i) {
        const double u = random.unit();
        cloud.add({u, u * u});
    }
    const Handle start = start_for(cloud, even_axes({3}, {8}, 2));
    CloudFit huge;
    huge.options.lambda = 1e300;
    const auto points = read_back(huge(start, cloud).get()).points;
    const double least = std::pow(3 * std::numbers::pi / 2, 4);
    EXPECT_DOUBLE_EQ(huge.report.lambda, 0x1p26 * 100 / least);
    CloudFit same;
    same.options.lambda = huge.report.lambda;
    EXPECT_TRUE(same_bits(read_back(same(start, cloud).get()).points, points));
    EXPECT_EQ(same.report.lambda, huge.report.lambda);
}

// --- Limits of work ---

// Counted: the fit never has a larger sum than one that had less work.
TEST(Clouds, ALimitOfWorkLeavesWhatThereIs) {
    Random random(17);
    Cloud cloud{4, {}, {}};
    for (int i = 0; i < 300; ++i) {
        cloud.add({random.unit(), random.unit(), random.unit(), random.unit()});
    }
    const Handle start = start_for(cloud, even_axes({2, 2, 2}, {5, 5, 5}, 4));
    CloudFit fit;
    fit.options.lambda = 0;
    const auto within = [&](int64_t work) {
        nurbs_call_options call{};
        require_ok(nurbs_call_options_init(&call, sizeof call));
        call.work = work;
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_fit_cloud_with(start.get(), cloud.size(), cloud.points.data(), 0, 0,
                                                         nullptr, 0, &fit.options, &fit.report, &call, &out);
        const Handle made(out);
        return status;
    };
    EXPECT_EQ(within(1000), NURBS_ERROR_WORK);
    double before = HUGE_VAL;
    for (const int64_t work : {200000000, 600000000, 1800000000}) {
        ASSERT_EQ(within(work), NURBS_OK);
        EXPECT_EQ(fit.report.bits, NURBS_CLOUD_NOT_CONVERGED) << work;
        EXPECT_LT(fit.report.squares, before) << work;
        before = fit.report.squares;
    }
}

// --- Collapsed shapes ---

// Along whole lines of parameters points are equally near: a start of no area, as one on a diagonal.
TEST(Clouds, CollapsedStartsEndSoon) {
    Random random(16);
    Cloud cloud{3, {}, {}};
    for (int i = 0; i < 100; ++i) {
        const double u = random.unit(), v = random.unit();
        cloud.add({u, v, std::sin(u + v)});
    }
    SplineData diagonal = even_axes({3, 3}, {8, 8}, 3);
    for (size_t i = 0; i < 64; ++i) {
        diagonal.points[3 * i] = 0.1 * static_cast<double>(i / 8 + i % 8);
    }
    CloudFit fit;
    nurbs_call_options call{};
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = 1'000'000'000;
    (void)made([&](nurbs **out) {
        return nurbs_fit_cloud_with(create(diagonal).get(), cloud.size(), cloud.points.data(), 0, 0, nullptr,
                                    0, &fit.options, &fit.report, &call, out);
    });
    EXPECT_LT(fit.report.largest, 1e-3);
    EXPECT_EQ(fit.report.uncertified, 0);
}

} // namespace

} // namespace cloud_test
