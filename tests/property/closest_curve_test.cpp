// Closest and farthest points of curves. With homogeneous points A, w the distance from x is at least d where
//
//     |A - x w|^2 - d^2 w^2 >= 0,
//
// a polynomial on each span. Its Bernstein coefficients are integers here, after a common factor; halving
// proves it nonnegative or finds a place where it is not. No rounding comes in.
#include "property/exact_polynomials.h"
#include "property/same_shape.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace closest_curve_test {

using namespace support;
using reference::Integer;
using reference::Rational;

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

struct Answer {
    double t = 0;
    std::vector<double> foot;
    double distance = 0;
    int32_t status = 0;
};

struct Asked {
    const double *range = nullptr;
    double tolerance = 0;
    int64_t budget = 0;
    bool farthest = false;
};

std::vector<Answer> ask(const nurbs *g, int dim, const std::vector<double> &points, const Asked &asked = {}) {
    const auto n = static_cast<int64_t>(points.size()) / dim;
    std::vector<double> params(static_cast<size_t>(n)), feet(points.size()),
        distances(static_cast<size_t>(n));
    std::vector<int32_t> status(static_cast<size_t>(n));
    const auto call = asked.farthest ? nurbs_farthest_points : nurbs_closest_points;
    require_ok(call(g, n, points.data(), 0, 0, asked.range, asked.tolerance, asked.budget, params.data(), 0,
                    0, feet.data(), 0, 0, distances.data(), 0, status.data(), 0));
    std::vector<Answer> answers;
    for (int64_t i = 0; i < n; ++i) {
        const auto at = static_cast<size_t>(i);
        const double *foot = feet.data() + i * dim;
        answers.push_back({params[at], {foot, foot + dim}, distances[at], status[at]});
    }
    return answers;
}

double largest(const std::vector<double> &values) {
    return std::transform_reduce(
        values.begin(), values.end(), 0.0, [](double a, double b) { return std::max(a, b); },
        [](double x) { return std::fabs(x); });
}

// What the header allows rounding.
double noise(const SplineData &data, const double *point) {
    const double x = std::sqrt(std::inner_product(point, point + data.dim, point, 0.0));
    return 64 * (data.degrees[0] + 1) * unit * (largest(data.points) + x);
}

// Whether sign (|A - x w|^2 - d^2 w^2) >= 0 on [from, to] of one span.
bool beyond(const SplineData &data, double from, double to, const double *x, double d, int sign) {
    const std::vector<Polynomial> parts = piece(data, from, to);
    const Polynomial &w = parts.back();
    const Rational square = reference::exact(d) * reference::exact(d);
    Polynomial rest = product(w, w);
    const Integer common = denominator(square);
    for (Integer &value : rest) {
        value *= -numerator(square);
    }
    Rational shared = 1; // a common denominator of the coordinates of x, so that all stays whole
    for (int c = 0; c < data.dim; ++c) {
        shared *= denominator(reference::exact(x[c]));
    }
    const Integer scale = numerator(shared);
    for (Integer &value : rest) {
        value *= scale * scale;
    }
    for (int c = 0; c < data.dim; ++c) {
        Polynomial offset = parts[static_cast<size_t>(c)];
        for (Integer &value : offset) {
            value *= scale;
        }
        const Rational at = reference::exact(x[c]) * shared;
        add(offset, w, -numerator(at));
        add(rest, product(offset, offset), common);
    }
    if (sign < 0) {
        for (Integer &value : rest) {
            value = -value;
        }
    }
    return nonnegative(rest);
}

// Whether no point of the part of the curve is nearer than d (farther, for the farthest point).
bool beyond_everywhere(const SplineData &data, double lower, double upper, const double *x, double d,
                       int sign) {
    std::vector<double> breaks = data.knots[0];
    breaks.push_back(lower);
    breaks.push_back(upper);
    std::erase_if(breaks, [&](double t) { return t < lower || t > upper; });
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        if (!beyond(data, breaks[i], breaks[i + 1], x, d, sign)) {
            return false;
        }
    }
    return true;
}

SplineData random_curve(Random &random, int max_degree) {
    Recipe recipe = random_recipe(random, 1, max_degree);
    recipe.axes[0].spans = random.whole(2, 6);
    recipe.dim = random.whole(1, 4);
    return random_spline(random, recipe);
}

// Points about a curve, on it, and near it.
std::vector<double> query_points(Random &random, const SplineData &data, const nurbs *g, int n) {
    const double size = largest(data.points);
    std::vector<double> points;
    for (int i = 0; i < n; ++i) {
        const int kind = random.whole(0, 3);
        const double t = random_param(random, data.knots[0], data.degrees[0]);
        const std::vector<double> on = eval(g, {t});
        const double far = kind == 0 ? 0 : size * (kind == 1 ? random.magnitude(1e-15, 1e-3) : 1.0);
        for (int c = 0; c < data.dim; ++c) {
            const double away = far * random.between(-1, 1);
            points.push_back(kind == 3 ? 1.5 * away : on[static_cast<size_t>(c)] + away);
        }
    }
    return points;
}

// Answers that are proven, and among all those whose parameters, far from 0 or close together, are too coarse
// for it.
struct Tally {
    int all = 0;
    int proven = 0;

    bool count(const Answer &answer, const SplineData &data, uint64_t seed) {
        const bool coarse = (answer.status & NURBS_CLOSEST_COARSE) != 0;
        ++all;
        proven += coarse ? 0 : 1;
        EXPECT_NE(coarse, (answer.status & NURBS_CLOSEST_CERTIFIED) != 0)
            << answer.status << where(seed, data);
        return !coarse;
    }
    void expect_most() const {
        std::printf("%d of %d proven\n", proven, all);
        EXPECT_GE(proven, all * 8 / 10);
    }
};

void expect_proven(const SplineData &data, double lower, double upper, const double *x, const Answer &answer,
                   bool farthest, uint64_t seed) {
    const double margin = noise(data, x);
    const double d = farthest ? answer.distance + margin : std::max(0.0, answer.distance - margin);
    EXPECT_TRUE(d == 0 || beyond_everywhere(data, lower, upper, x, d, farthest ? -1 : 1))
        << "x = " << hex({x, x + data.dim}) << ", t = " << hex(answer.t) << ", d = " << hex(answer.distance)
        << where(seed, data);
}

} // namespace

TEST(ClosestOnCurve, certified_answers_are_right_in_exact_arithmetic) {
    Tally tally;
    for_each_case(0x6001, 250, [&tally](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 5);
        const Handle g = create(data);
        const std::vector<double> points = query_points(random, data, g.get(), 4);
        const Asked asked{nullptr, 0, 0, random.chance(30)};
        const std::vector<Answer> answers = ask(g.get(), data.dim, points, asked);
        for (size_t i = 0; i < answers.size(); ++i) {
            const double *x = points.data() + i * static_cast<size_t>(data.dim);
            if (tally.count(answers[i], data, seed)) {
                expect_proven(data, data.lower(0), data.upper(0), x, answers[i], asked.farthest, seed);
            }
        }
    });
    tally.expect_most();
}

TEST(ClosestOnCurve, a_range_is_all_that_is_searched) {
    Tally tally;
    for_each_case(0x6002, 150, [&tally](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 4);
        const Handle g = create(data);
        double range[2] = {random_param(random, data.knots[0], data.degrees[0]),
                           random_param(random, data.knots[0], data.degrees[0])};
        if (range[1] < range[0]) {
            std::swap(range[0], range[1]);
        }
        if (!(range[1] > range[0])) {
            return;
        }
        const std::vector<double> points = query_points(random, data, g.get(), 2);
        const Asked asked{range, 0, 0, random.chance(30)};
        const std::vector<Answer> answers = ask(g.get(), data.dim, points, asked);
        for (size_t i = 0; i < answers.size(); ++i) {
            EXPECT_GE(answers[i].t, range[0]);
            EXPECT_LE(answers[i].t, range[1]);
            const bool end = answers[i].t == range[0] || answers[i].t == range[1];
            const bool whole = range[0] == data.lower(0) && range[1] == data.upper(0) && data.periodic(0);
            EXPECT_EQ((answers[i].status & NURBS_CLOSEST_BOUNDARY) != 0, end && !whole) << where(seed, data);
            const double *x = points.data() + i * static_cast<size_t>(data.dim);
            if (tally.count(answers[i], data, seed)) {
                expect_proven(data, range[0], range[1], x, answers[i], asked.farthest, seed);
            }
        }
    });
    tally.expect_most();
}

// The point is that of the parameter, from the side that the status tells, and the distance that of the
// point.
TEST(ClosestOnCurve, feet_are_points_of_the_curve) {
    int from_below = 0;
    for_each_case(0x6003, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 9);
        const Handle g = create(data);
        const std::vector<double> points = query_points(random, data, g.get(), 5);
        const std::vector<Answer> answers = ask(g.get(), data.dim, points);
        for (size_t i = 0; i < answers.size(); ++i) {
            const std::vector<double> right = eval(g.get(), {answers[i].t});
            const std::vector<double> left = eval(g.get(), {answers[i].t}, NURBS_LEFT);
            const bool below = (answers[i].status & NURBS_CLOSEST_LEFT) != 0;
            EXPECT_TRUE(same_bits(answers[i].foot, below ? left : right)) << where(seed, data);
            from_below += below ? 1 : 0;
            double square = 0;
            for (size_t c = 0; c < right.size(); ++c) {
                const double d = answers[i].foot[c] - points[i * right.size() + c];
                square += d * d;
            }
            EXPECT_NEAR(answers[i].distance, std::sqrt(square), 8 * unit * answers[i].distance)
                << where(seed, data);
        }
    });
    EXPECT_GT(from_below, support::of_whole_run(0));
}

TEST(ClosestOnCurve, a_batch_gives_the_bits_of_single_queries) {
    for_each_case(0x6004, 40, [](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 5);
        const Handle g = create(data);
        const std::vector<double> points = query_points(random, data, g.get(), 150);
        const std::vector<Answer> together = ask(g.get(), data.dim, points);
        for (size_t i = 0; i < together.size(); i += 7) {
            const double *x = points.data() + i * static_cast<size_t>(data.dim);
            const Answer alone = ask(g.get(), data.dim, {x, x + data.dim})[0];
            EXPECT_TRUE(same_bits(alone.t, together[i].t) && same_bits(alone.foot, together[i].foot) &&
                        alone.status == together[i].status)
                << where(seed, data);
        }
    });
}

// Units of length and parameters that are powers of two change nothing else.
TEST(ClosestOnCurve, powers_of_two_are_exact) {
    for_each_case(0x6008, 60, [](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 5);
        const Handle g = create(data);
        const std::vector<double> points = query_points(random, data, g.get(), 5);
        const std::vector<Answer> before = ask(g.get(), data.dim, points);
        for (const int exponent : {-600, -30, 30, 600}) {
            SplineData other = data;
            std::vector<double> moved = points;
            for (std::vector<double> *values : {&other.points, &moved}) {
                std::for_each(values->begin(), values->end(),
                              [&](double &x) { x = std::ldexp(x, exponent); });
            }
            std::for_each(other.knots[0].begin(), other.knots[0].end(), [](double &t) { t *= 0.125; });
            const Handle h = create(other);
            const std::vector<Answer> after = ask(h.get(), data.dim, moved);
            for (size_t i = 0; i < before.size(); ++i) {
                EXPECT_EQ(after[i].t, 0.125 * before[i].t) << exponent << where(seed, data);
                EXPECT_EQ(after[i].status, before[i].status) << exponent << where(seed, data);
            }
        }
    });
}

// Points so far away that products overflow are answered all the same, without proof, whatever the budget.
TEST(ClosestOnCurve, points_at_the_end_of_the_numbers) {
    for_each_case(0x6009, 40, [](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 4);
        const Handle g = create(data);
        std::vector<double> x(static_cast<size_t>(data.dim));
        for (double &value : x) {
            value = random.chance(50) ? std::numeric_limits<double>::max() : -random.magnitude(1e150, 1e308);
        }
        for (const bool farthest : {false, true}) {
            const Answer answer = ask(g.get(), data.dim, x, {nullptr, 0, int64_t{1} << 62, farthest})[0];
            EXPECT_GE(answer.t, data.lower(0)) << where(seed, data);
            EXPECT_LE(answer.t, data.upper(0)) << where(seed, data);
        }
    });
}

// No farthest point of a curve that goes to infinity is certified.
TEST(ClosestOnCurve, unbounded_curves_have_no_farthest_point) {
    const int32_t degrees[] = {1, 2};
    const double line[] = {1, 0, 0, 0, 1, 1}, pole[] = {1, 0, 1, 0, 1, -1, -1, 0, 1};
    const double knots[] = {0, 0, 0, 1, 1, 1}, x[] = {0, 0};
    for (int i = 0; i < 2; ++i) {
        const int64_t count = degrees[i] + 1;
        nurbs *out = nullptr;
        require_ok(nurbs_create_homogeneous(1, &degrees[i], &count, knots + 1 - i, 2 * count, 2,
                                            i == 0 ? line : pole, 0, 0, 0, &out));
        const Handle g(out);
        int32_t status = 0;
        require_ok(nurbs_farthest_points(g.get(), 1, x, 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                         nullptr, 0, &status, 0));
        EXPECT_EQ(status & NURBS_CLOSEST_CERTIFIED, 0);
    }
}

// Many queries against the best of many samples.
TEST(ClosestOnCurve, no_sample_is_nearer) {
    Tally tally;
    for_each_case(0x6005, 200, [&tally](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 15);
        recipe.axes[0].spans = random.whole(1, 40);
        recipe.dim = random.whole(1, 3);
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const std::vector<double> points = query_points(random, data, g.get(), 50);
        const std::vector<Answer> answers = ask(g.get(), data.dim, points);
        constexpr int samples = 2000;
        std::vector<double> params;
        for (int i = 0; i <= samples; ++i) {
            params.push_back(std::lerp(data.lower(0), data.upper(0), static_cast<double>(i) / samples));
        }
        const std::vector<double> curve = eval(g.get(), params);
        for (size_t q = 0; q < answers.size(); ++q) {
            const double *x = points.data() + q * static_cast<size_t>(data.dim);
            const double limit = answers[q].distance - noise(data, x);
            const bool proven = tally.count(answers[q], data, seed);
            for (size_t i = 0; proven && i < params.size(); ++i) {
                double square = 0;
                for (int c = 0; c < data.dim; ++c) {
                    const double d = curve[i * static_cast<size_t>(data.dim) + static_cast<size_t>(c)] - x[c];
                    square += d * d;
                }
                ASSERT_GE(std::sqrt(square), limit) << hex(params[i]) << where(seed, data);
            }
        }
    });
    tally.expect_most();
}

namespace {

Handle circle(double radius) {
    const double center[] = {0, 0}, x[] = {1, 0};
    nurbs *g = nullptr;
    require_ok(nurbs_curve_circle(2, center, nullptr, x, radius, NURBS_ARC_QUARTERS, &g));
    return Handle(g);
}

} // namespace

TEST(ClosestOnCurve, distances_from_a_circle) {
    const Handle g = circle(2);
    Random random(0x6006);
    for (int i = 0; i < 2000; ++i) {
        const double angle = random.between(0, 2 * std::numbers::pi), r = random.magnitude(1e-9, 1e4);
        const std::vector<double> x{r * std::cos(angle), r * std::sin(angle)};
        const Answer near = ask(g.get(), 2, x)[0], far = ask(g.get(), 2, x, {nullptr, 0, 0, true})[0];
        EXPECT_NEAR(near.distance, std::fabs(std::hypot(x[0], x[1]) - 2), 64 * 3 * unit * (2 + r));
        EXPECT_NEAR(far.distance, std::hypot(x[0], x[1]) + 2, 64 * 3 * unit * (2 + r));
        EXPECT_EQ(near.status & far.status & NURBS_CLOSEST_CERTIFIED, NURBS_CLOSEST_CERTIFIED);
    }
}

TEST(ClosestOnCurve, the_centre_of_a_circle_has_no_one_nearest_point) {
    const Handle g = circle(2);
    const Answer near = ask(g.get(), 2, {0, 0})[0], beside = ask(g.get(), 2, {1e-3, 1e-3})[0];
    EXPECT_EQ(near.status & ~NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_NOT_UNIQUE);
    EXPECT_EQ(beside.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_NEAR(near.distance, 2, 8 * unit);
}

// Inside a closed curve that runs counterclockwise about the origin, with corners and without, is its left
// side.
// A descent that begins at one end of the domain of a periodic curve passes the seam on its way to the minimum.
TEST(ClosestOnCurve, descents_pass_the_seam_of_a_periodic_curve) {
    const Handle circle = made([](nurbs **out) {
        return nurbs_curve_ellipse(2, nullptr, nullptr, nullptr, 1, 1, 0, 2 * std::numbers::pi,
                                   NURBS_ARC_QUARTERS, out);
    });
    const Handle g =
        made([&](nurbs **out) { return nurbs_make_periodic(circle.get(), 0, 1e-9, nullptr, nullptr, out); });
    for (const double angle : {0.1, -0.1, 0.9, -0.9}) {
        const double point[] = {3 * std::cos(angle), 3 * std::sin(angle)};
        const double guess = angle > 0 ? 1 - 0x1p-10 : 0x1p-10;
        double t = -1, distance = 0;
        int32_t status = -1;
        require_ok(nurbs_closest_local(g.get(), 1, point, 0, 0, &guess, 0, 0, &t, 0, 0, nullptr, 0, 0,
                                       &distance, 0, &status, 0));
        EXPECT_NEAR(distance, 2, 1e-12) << angle;
        EXPECT_EQ(status, 0) << angle;
    }
}

TEST(ClosestOnCurve, signed_distances_tell_inside_from_outside) {
    for_each_case(0x6007, 60, [](Random &random, uint64_t seed) {
        const int n = random.whole(3, 12), p = random.whole(1, 3);
        SplineData data;
        data.degrees = {p};
        data.counts = {n * p + 1};
        data.dim = 2;
        data.knots.resize(1);
        for (int i = 0; i <= n; ++i) { // p-fold knots: a kink at each
            data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(i % n == 0 ? p + 1 : p), i);
        }
        for (int i = 0; i <= n * p; ++i) {
            const double angle = 2 * std::numbers::pi * (i % (n * p)) / (n * p);
            const double r = i == n * p ? 0 : random.between(0.3, 2);
            data.points.push_back(i == n * p ? data.points[0] : r * std::cos(angle));
            data.points.push_back(i == n * p ? data.points[1] : r * std::sin(angle));
        }
        const Handle g = create(data);
        std::vector<double> params, points, distances(100);
        for (int i = 0; i < 4000; ++i) {
            params.push_back(n * (i / 4000.0));
        }
        const std::vector<double> polygon = eval(g.get(), params);
        for (int i = 0; i < 200; ++i) {
            points.push_back(random.between(-2, 2));
        }
        require_ok(nurbs_curve_signed_distances(g.get(), 100, points.data(), 0, 0, 0, 0, distances.data(), 0,
                                                nullptr, 0, nullptr, 0));
        for (size_t q = 0; q < 100; ++q) {
            const double x = points[2 * q], y = points[2 * q + 1];
            bool inside = false;
            for (size_t i = 0, j = polygon.size() - 2; i < polygon.size(); j = i, i += 2) {
                const double ax = polygon[i], ay = polygon[i + 1], bx = polygon[j], by = polygon[j + 1];
                inside ^= (ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax;
            }
            if (std::fabs(distances[q]) > 1e-4) { // the polygon is not the curve
                EXPECT_EQ(distances[q] > 0, inside) << x << " " << y << where(seed, data);
            }
        }
    });
}

} // namespace closest_curve_test
