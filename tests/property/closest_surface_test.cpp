// Nearest and farthest points of surfaces and volumes: against dense samples with a descent from the best of
// them, closed forms, exact arithmetic at the parameters returned, and laws.
#include "property/exact_points.h"
#include "property/made_shapes.h"
#include "property/query_noise.h"

namespace closest_surface_test {

using namespace support;

namespace {

struct Answer {
    std::vector<double> params, feet;
    double distance = 0;
    int32_t status = 0;

    [[nodiscard]] bool has(int32_t bit) const { return (status & bit) != 0; }
};

Answer ask(const nurbs *g, const SplineData &data, const std::vector<double> &x, bool farthest = false,
           const double *range = nullptr, double tolerance = 0, int64_t budget = 0) {
    Answer answer{std::vector<double>(data.degrees.size()), std::vector<double>(x.size()), 0, 0};
    const auto function = farthest ? nurbs_farthest_points : nurbs_closest_points;
    require_ok(function(g, 1, x.data(), 0, 0, range, tolerance, budget, answer.params.data(), 0, 0,
                        answer.feet.data(), 0, 0, &answer.distance, 0, &answer.status, 0));
    return answer;
}

double apart(const std::vector<double> &x, const double *y) {
    double sum = 0;
    for (size_t c = 0; c < x.size(); ++c) {
        sum += (x[c] - y[c]) * (x[c] - y[c]);
    }
    return std::sqrt(sum);
}

// The best of a grid over the domain, or over a range, and of a descent from it.
double sampled(const nurbs *g, const SplineData &data, const std::vector<double> &x, bool farthest,
               const std::vector<double> &range, int per_axis) {
    std::vector<std::vector<double>> places;
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        places.emplace_back();
        for (int i = 0; i <= per_axis; ++i) {
            const double t = range[2 * k] + (range[2 * k + 1] - range[2 * k]) * i / per_axis;
            places.back().push_back(std::min(t, range[2 * k + 1]));
        }
    }
    const std::vector<double> points = eval_grid(g, places);
    double best = farthest ? 0 : INFINITY;
    size_t at = 0;
    for (size_t i = 0; i * x.size() < points.size(); ++i) {
        const double d = apart(x, points.data() + i * x.size());
        if (farthest ? d > best : d < best) {
            best = d;
            at = i;
        }
    }
    if (farthest) {
        return best;
    }
    std::vector<double> guess(places.size());
    for (size_t k = places.size(); k-- > 0; at /= places[k].size()) {
        guess[k] = places[k][at % places[k].size()];
    }
    std::vector<double> found(guess.size());
    double d = 0;
    require_ok(nurbs_closest_local(g, 1, x.data(), 0, 0, guess.data(), 0, 0, found.data(), 0, 0, nullptr, 0,
                                   0, &d, 0, nullptr, 0));
    for (size_t k = 0; k < found.size(); ++k) {
        if (found[k] < range[2 * k] || found[k] > range[2 * k + 1]) {
            return best;
        }
    }
    return std::min(best, d);
}

std::vector<double> whole_range(const SplineData &data) {
    std::vector<double> range;
    for (int k = 0; k < data.axes(); ++k) {
        range.insert(range.end(), {data.lower(k), data.upper(k)});
    }
    return range;
}

std::vector<double> query_near(Random &random, const SplineData &data) {
    double size = 0;
    for (const double x : data.points) {
        size = std::max(size, std::fabs(x));
    }
    const bool near = random.chance(60);
    const double reach = size * random.magnitude(0.1, 10);
    std::vector<double> x;
    for (int c = 0; c < data.dim; ++c) {
        const int i = random.whole(0, static_cast<int>(data.point_count()) - 1);
        x.push_back(near ? data.coordinate(i, c) * random.between(0.9, 1.1) : reach * random.between(-1, 1));
    }
    return x;
}

std::vector<double> query_point(Random &random, int dim, double reach) {
    std::vector<double> x(static_cast<size_t>(dim));
    std::generate(x.begin(), x.end(), [&] { return random.between(-reach, reach); });
    return x;
}

SplineData random_shape(Random &random, bool plain) {
    const int axes = random.chance(70) ? 2 : 3;
    Recipe recipe = random_recipe(random, axes, axes == 2 ? 5 : 3);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = random.whole(1, axes == 2 ? 4 : 2);
        if (plain) {
            axis.spacing = Spacing::full;
            axis.placement = Placement::origin;
        }
    }
    if (plain && recipe.weights == Weights::extreme) {
        recipe.weights = Weights::moderate;
    }
    recipe.dim = random.chance(60) ? 3 : random.whole(1, 7);
    return random_spline(random, recipe);
}

// What is certified is beaten by no sample, nor by a descent from the best one.
TEST(ClosestSurface, what_is_certified_is_beaten_by_no_sample) {
    int asked = 0, certified = 0, plain_asked = 0, plain_certified = 0;
    for_each_case(2100000, 420, [&](Random &random, uint64_t seed) {
        const bool plain = random.chance(60);
        const SplineData data = random_shape(random, plain);
        const Handle g = create(data);
        for (int i = 0; i < 24; ++i) {
            const std::vector<double> x = query_near(random, data);
            const bool farthest = i % 4 == 3;
            const Answer answer = ask(g.get(), data, x, farthest);
            const double best =
                sampled(g.get(), data, x, farthest, whole_range(data), data.axes() == 2 ? 24 : 8);
            const double beaten = farthest ? best - answer.distance : answer.distance - best;
            ++asked;
            plain_asked += plain ? 1 : 0;
            ASSERT_EQ(int{answer.has(NURBS_CLOSEST_CERTIFIED)} + int{answer.has(NURBS_CLOSEST_BUDGET)} +
                          int{answer.has(NURBS_CLOSEST_COARSE)},
                      1);
            if (answer.has(NURBS_CLOSEST_CERTIFIED)) {
                ++certified;
                plain_certified += plain ? 1 : 0;
                ASSERT_LE(beaten, noise(data, x)) << where(seed, data) << hex(x) << " farthest " << farthest;
            }
        }
    });
    std::printf("%d of %d certified, %d of %d of those without extremes\n", certified, asked, plain_certified,
                plain_asked);
    EXPECT_GE(certified, asked * 9 / 10);
    EXPECT_GE(plain_certified, plain_asked * 998 / 1000);
}

// At a jump both limits belong to a surface.
long double distance_error(const SplineData &data, const std::vector<double> &x, const Answer &answer) {
    const reference::Sides left{answer.has(NURBS_CLOSEST_LEFT), answer.has(NURBS_CLOSEST_LEFT << 1),
                                answer.has(NURBS_CLOSEST_LEFT << 2)};
    Rational square = 0;
    size_t c = 0;
    for (const reference::Fraction &coordinate : reference::exact_point(data, answer.params.data(), left)) {
        const Rational delta = Rational(coordinate.numerator, coordinate.denominator) - exact(x[c++]);
        square += delta * delta;
    }
    return std::fabs(std::sqrt(as_long_double(square)) - answer.distance);
}

TEST(ClosestSurface, distances_are_those_of_the_parameters_in_exact_arithmetic) {
    WorstRatios worst("distance at the parameters");
    for_each_case(2110000, 120, [&](Random &random, uint64_t seed) {
        const SplineData data = random_shape(random, true);
        const Handle g = create(data);
        const std::vector<double> x = query_near(random, data);
        const Answer answer = ask(g.get(), data, x, random.chance(50));
        const auto error = distance_error(data, x, answer);
        worst.add(error / noise(data, x));
        ASSERT_LE(error, noise(data, x)) << where(seed, data) << hex(x);
        ASSERT_LE(std::fabs(apart(x, answer.feet.data()) - answer.distance), noise(data, x));
    });
}

TEST(ClosestSurface, a_range_is_searched_alone) {
    int asked = 0, certified = 0;
    for_each_case(2120000, 150, [&](Random &random, uint64_t seed) {
        const SplineData data = random_shape(random, true);
        const Handle g = create(data);
        std::vector<double> range;
        for (int k = 0; k < data.axes(); ++k) {
            const double a = random_param(random, data.knots[static_cast<size_t>(k)],
                                          data.degrees[static_cast<size_t>(k)]);
            const double b = random.between(data.lower(k), data.upper(k));
            range.insert(range.end(), {std::min(a, b), std::max(a, b)});
            const auto &knots = data.knots[static_cast<size_t>(k)];
            const bool jump = range.back() < data.upper(k) &&
                              std::count(knots.begin(), knots.end(), range.back()) >
                                  data.degrees[static_cast<size_t>(k)]; // samples would lie behind it
            if (!(range[range.size() - 2] < range.back()) || jump) {
                return;
            }
        }
        for (int i = 0; i < 8; ++i) {
            const std::vector<double> x = query_near(random, data);
            const bool farthest = i % 4 == 3;
            const Answer answer = ask(g.get(), data, x, farthest, range.data());
            for (size_t k = 0; k < answer.params.size(); ++k) {
                ASSERT_GE(answer.params[k], range[2 * k]) << where(seed, data);
                ASSERT_LE(answer.params[k], range[2 * k + 1]) << where(seed, data);
            }
            const double best = sampled(g.get(), data, x, farthest, range, data.axes() == 2 ? 20 : 6);
            ++asked;
            if (answer.has(NURBS_CLOSEST_CERTIFIED)) {
                ++certified;
                ASSERT_LE(farthest ? best - answer.distance : answer.distance - best, noise(data, x))
                    << where(seed, data) << hex(x) << hex(range);
            }
        }
    });
    EXPECT_GE(certified, asked * 99 / 100);
}

// In powers of two nothing is rounded.
TEST(ClosestSurface, the_scale_changes_no_bit) {
    for_each_case(2130000, 100, [&](Random &random, uint64_t seed) {
        const SplineData data = random_shape(random, true);
        const int power = random.whole(-60, 60);
        const SplineData other = scaled(data, std::ldexp(1, power));
        const std::vector<double> x = query_near(random, data);
        std::vector<double> y = x;
        for (double &c : y) {
            c = std::ldexp(c, power);
        }
        const Answer a = ask(create(data).get(), data, x), b = ask(create(other).get(), other, y);
        ASSERT_TRUE(same_bits(a.params, b.params)) << where(seed, data);
        ASSERT_EQ(a.status, b.status) << where(seed, data);
        ASSERT_EQ(std::ldexp(a.distance, power), b.distance) << where(seed, data);
    });
}

double random_angle(Random &random) {
    return random.between(-3.1, 3.1);
}

SplineData sphere_of(double r) {
    const double half = std::acos(-1.0) / 2;
    return revolved(ellipse_arc(0, 0, r, r, -half, 2 * half), 0, 4 * half);
}

TEST(ClosestSurface, of_spheres_are_at_the_difference_of_radii) {
    for_each_case(2140000, 300, [&](Random &random, uint64_t seed) {
        const double r = random.magnitude(1e-6, 1e6);
        const SplineData data = sphere_of(r);
        const Handle g = create(data);
        const double d = r * (random.chance(20) ? 1e-9 : random.magnitude(1e-3, 100));
        const double u = random_angle(random), v = random_angle(random) / 2;
        std::vector<double> x{d * std::cos(u) * std::cos(v), d * std::sin(u) * std::cos(v), d * std::sin(v)};
        if (random.chance(20)) { // on the axis, beyond or before a pole
            x = {0, 0, random.chance(50) ? d : -d};
        }
        const Answer near = ask(g.get(), data, x), far = ask(g.get(), data, x, true);
        const double size = norm(x);
        ASSERT_TRUE(near.has(NURBS_CLOSEST_CERTIFIED)) << seed << hex(x) << hex(r);
        ASSERT_TRUE(far.has(NURBS_CLOSEST_CERTIFIED)) << seed << hex(x) << hex(r);
        ASSERT_NEAR(near.distance, std::fabs(size - r), noise(data, x)) << seed << hex(x) << hex(r);
        ASSERT_NEAR(far.distance, size + r, noise(data, x)) << seed << hex(x) << hex(r);
    });
}

TEST(ClosestSurface, the_middles_of_round_shapes_have_many) {
    for (const double r : {1e-6, 1.0, 1e6}) {
        const SplineData ball = sphere_of(r);
        const Handle g = create(ball);
        for (const bool farthest : {false, true}) {
            const Answer answer = ask(g.get(), ball, {0, 0, 0}, farthest);
            EXPECT_EQ(answer.status & ~NURBS_CLOSEST_BOUNDARY,
                      NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_NOT_UNIQUE);
            EXPECT_NEAR(answer.distance, r, noise(ball, {0, 0, 0}));
        }
        const SplineData tube = revolved(segment(r, -r, r, r), 0, 4 * std::acos(0.0));
        const Answer axis = ask(create(tube).get(), tube, {0, 0, r / 3});
        EXPECT_EQ(axis.status & ~NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_NOT_UNIQUE);
        EXPECT_NEAR(axis.distance, r, noise(tube, {0, 0, r / 3}));
    }
}

TEST(ClosestSurface, of_tori_and_cylinders_follow_their_closed_forms) {
    for_each_case(2150000, 300, [&](Random &random, uint64_t seed) {
        const double full = 4 * std::acos(0.0), a = random.between(1.5, 3), b = random.between(0.2, 1.2);
        const bool torus = random.chance(50);
        const SplineData data = torus ? revolved(ellipse_arc(a, 0, b, b, 0.3, full), 0.7, full)
                                      : revolved(segment(a, -b, a, b), 0.7, full);
        const double angle = random_angle(random), s = a * random.magnitude(0.1, 5),
                     z = random.between(-3, 3);
        const std::vector<double> x{s * std::cos(angle), s * std::sin(angle), z};
        const Answer answer = ask(create(data).get(), data, x);
        const double expected =
            torus ? std::fabs(std::hypot(s - a, z) - b) : std::hypot(s - a, std::max(0.0, std::fabs(z) - b));
        ASSERT_TRUE(answer.has(NURBS_CLOSEST_CERTIFIED)) << seed;
        ASSERT_NEAR(answer.distance, expected, noise(data, x)) << seed << hex(x);
    });
}

// Points off the surface by less than its radii of curvature: of a bilinear patch with its one normal there.
TEST(ClosestSurface, of_points_on_normals_are_their_feet) {
    for_each_case(2160000, 150, [&](Random &random, uint64_t seed) {
        SplineData data{{3, 3}, {9, 8}, {}, 3, {}, {}, 0};
        data.knots = {random_knots(random, {3, KnotForm::clamped, Spacing::integers, Placement::origin, 6}),
                      random_knots(random, {3, KnotForm::clamped, Spacing::integers, Placement::origin, 5})};
        for (size_t k = 0; k < 2; ++k) {
            data.counts[k] = static_cast<int64_t>(data.knots[k].size()) - 4;
        }
        for (int64_t i = 0; i < data.counts[0]; ++i) {
            for (int64_t j = 0; j < data.counts[1]; ++j) {
                data.points.insert(data.points.end(), {static_cast<double>(i), static_cast<double>(j),
                                                       random.between(-0.1, 0.1)});
            }
        }
        const Handle g = create(data);
        const std::vector<double> at{random.between(data.lower(0), data.upper(0)),
                                     random.between(data.lower(1), data.upper(1))};
        const std::vector<double> jet = eval_derivs(g.get(), 1, at);
        std::vector<double> n{jet[4] * jet[8] - jet[5] * jet[7], jet[5] * jet[6] - jet[3] * jet[8],
                              jet[3] * jet[7] - jet[4] * jet[6]};
        const double scale = random.magnitude(1e-12, 0.05) / norm(n);
        std::vector<double> x(3);
        for (size_t c = 0; c < 3; ++c) {
            x[c] = jet[c] + scale * n[c];
        }
        const Answer answer = ask(g.get(), data, x);
        ASSERT_TRUE(answer.has(NURBS_CLOSEST_CERTIFIED)) << where(seed, data);
        ASSERT_LE(answer.distance, apart(x, jet.data()) + noise(data, x)) << where(seed, data) << hex(x);
        ASSERT_LE(apart(answer.feet, jet.data()), 1e-5) << where(seed, data) << hex(at);
    });
}

// A point inside a volume is found again.
TEST(ClosestSurface, volumes_are_inverted) {
    for_each_case(2170000, 200, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 3, 3);
        for (AxisRecipe &axis : recipe.axes) {
            axis = {std::max(1, axis.degree), KnotForm::clamped, Spacing::full, Placement::origin, 2};
        }
        recipe.dim = 3;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        std::vector<double> at;
        for (int k = 0; k < 3; ++k) {
            at.push_back(random.between(data.lower(k), data.upper(k)));
        }
        const std::vector<double> x = eval(g.get(), at);
        const Answer answer = ask(g.get(), data, x);
        ASSERT_TRUE(answer.has(NURBS_CLOSEST_CERTIFIED)) << where(seed, data);
        ASSERT_LE(answer.distance, noise(data, x)) << where(seed, data) << hex(at);
    });
}

// A bar of degrees 5, 1 and 1 that winds through a box.
SplineData winding_bar(Random &random, int dim) {
    const std::vector<double> along{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, across{0, 0, 1, 1};
    SplineData data{{5, 1, 1}, {6, 2, 2}, {along, across, across}, dim, {}, {}, 0};
    const bool weighted = random.chance(50);
    for (int i = 0; i < 6; ++i) {
        const std::vector<double> middle = query_point(random, dim, 2);
        for (int corner = 0; corner < 4; ++corner) {
            for (int c = 0; c < dim; ++c) {
                data.points.push_back(middle[static_cast<size_t>(c)] + random.between(-0.1, 0.1));
            }
            if (weighted) {
                data.weights.push_back(random.between(0.5, 2));
            }
        }
    }
    return data;
}

// Of degrees 11, 11 and 10 it is settled by half spaces, for its coefficients are too many to square.
TEST(ClosestSurface, volumes_of_high_degrees_have_the_points_of_low_ones) {
    int certified = 0;
    for_each_case(2190000, 30, [&](Random &random, uint64_t seed) {
        const SplineData data = winding_bar(random, random.whole(3, 4));
        const Handle low = create(data);
        const Handle high = elevate(elevate(elevate(low.get(), 0, 6).get(), 1, 10).get(), 2, 9);
        const SplineData raised = read_back(high.get());
        for (const bool farthest : {false, true}) {
            const std::vector<double> x = query_point(random, data.dim, 1);
            const Answer want = ask(low.get(), data, x, farthest),
                         got = ask(high.get(), data, x, farthest, nullptr, 0, 50000);
            if (want.has(NURBS_CLOSEST_CERTIFIED) && got.has(NURBS_CLOSEST_CERTIFIED)) {
                ++certified;
                ASSERT_NEAR(got.distance, want.distance, noise(raised, x)) << where(seed, data) << hex(x);
            }
        }
    });
    std::printf("%d of 60 certified\n", certified);
    EXPECT_GT(certified, support::of_whole_run(30));
}

// Two hills, and a point between them.
TEST(ClosestSurface, all_minima_within_the_tolerance_are_found) {
    const SplineData data{{2, 1},
                          {3, 2},
                          {{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}},
                          3,
                          {-1, -1, 1, -1, 1, 1, 0, -1, -3, 0, 1, -3, 1, -1, 1, 1, 1, 1},
                          {},
                          0};
    const Handle g = create(data);
    const std::vector<double> x{0, 0, 1};
    int64_t count = 0;
    int32_t status = 0;
    double params[8], distances[4];
    require_ok(nurbs_closest_all(g.get(), x.data(), nullptr, 1e-9, 0, 4, params, distances, &count, &status));
    ASSERT_EQ(count, 2);
    EXPECT_EQ(status & ~NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_NOT_UNIQUE);
    EXPECT_NEAR(params[0] + params[2], 1, 1e-12);
    EXPECT_LT(params[0], params[2]);
    EXPECT_NEAR(distances[0], distances[1], 1e-14);
    const std::vector<double> aside{0.01, 0, 1};
    require_ok(
        nurbs_closest_all(g.get(), aside.data(), nullptr, 0, 0, 4, params, distances, &count, &status));
    ASSERT_EQ(count, 1);
    EXPECT_EQ(status & ~NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_CERTIFIED);
    const SplineData ball = sphere_of(1);
    const double middle[] = {0, 0, 0};
    require_ok(
        nurbs_closest_all(create(ball).get(), middle, nullptr, 0, 0, 0, nullptr, nullptr, &count, &status));
    EXPECT_EQ(status & ~NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_NOT_UNIQUE);
}

} // namespace

} // namespace closest_surface_test
