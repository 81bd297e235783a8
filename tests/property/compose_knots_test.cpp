// Composition where f meets the knots of g: periods, knot lines, clusters of knots, steep pieces.
#include "property/compositions.h"

namespace compose_knots_test {

using namespace support;
using namespace support::compositions;
using reference::Rational;

namespace {

// A polynomial curve whose knots and period are whole.
SplineData whole_period(Random &random, int max_degree) {
    Recipe recipe = random_recipe(random, 1, max_degree);
    recipe.axes[0].form = KnotForm::periodic;
    recipe.axes[0].spacing = Spacing::integers;
    recipe.axes[0].placement = Placement::origin;
    recipe.weights = Weights::none;
    return random_spline(random, recipe);
}

TEST(Compose, runs_around_periodic_axes) {
    for_each_case(970000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = whole_period(random, 5);
        const double length = data.upper(0) - data.lower(0);
        SplineData f;
        f.degrees = {2};
        f.dim = 1;
        f.counts = {3};
        f.knots = {{0, 0, 0, 1, 1, 1}};
        const double from = data.lower(0) - random.whole(0, 12) * length / 4,
                     by = (random.chance(50) ? 1 : -1) * random.whole(1, 12) * length / 4;
        f.points = {from, from + by / 4, from + by};
        const auto g = create(data), curve = create(f);
        const auto h = compose(g.get(), curve.get());
        for (int n = 0; n < 5; ++n) {
            const double t = random.whole(1, 1023) / 1024.0;
            const double u = eval(curve.get(), {t})[0];
            const double turn = (u - data.lower(0)) / length;
            const auto &knots = data.knots[0];
            const double place = data.lower(0) + (turn - std::floor(turn)) * length;
            const bool at_knot = std::any_of(knots.begin(), knots.end(), [&](double knot) {
                return std::fabs(knot - place) < 1e-9 * length;
            });
            const auto got = eval(h.get(), {t});
            const auto want = eval(g.get(), {u}, NURBS_WRAP);
            for (size_t c = 0; c < got.size() && !at_knot; ++c) {
                ASSERT_NEAR(got[c], want[c],
                            1e-13 * (largest_point(data) + largest_slope(data, 0) * (std::fabs(u) + length)))
                    << where(seed, data) << hex(f.points) << " at " << t;
            }
        }
    });
}

// At the middle of a cell, from either side.
TEST(Compose, curves_touch_knot_lines_from_either_side) {
    WorstErrors worst("curves that touch knot lines by degree, unit the bound");
    for_each_case(990000, 200, [&](Random &random, uint64_t seed) {
        const SplineData data = whole_knots(random, 2, 3);
        const int across = random.whole(0, 1), along = 1 - across;
        const double length = data.upper(across) - data.lower(across);
        const double knot = data.lower(across) + random.whole(0, static_cast<int>(length));
        const double room = std::min(knot - data.lower(across), data.upper(across) - knot);
        const double depth = random.chance(50) ? room : -room;
        SplineData f;
        f.degrees = {2};
        f.dim = 2;
        f.counts = {3};
        f.knots = {{0, 0, 0, 1, 1, 1}};
        f.points.resize(6);
        for (size_t i = 0; i < 3; ++i) {
            f.points[2 * i + static_cast<size_t>(across)] = i == 1 ? knot - depth : knot + depth;
            f.points[2 * i + static_cast<size_t>(along)] =
                data.lower(along) + (data.upper(along) - data.lower(along)) * random.whole(0, 8) / 8;
        }
        const auto made = compose(create(data).get(), create(f).get());
        expect_composed({homogeneous(create(data).get()), f, homogeneous(made.get())}, random,
                        largest_factor(data, f), worst, where(seed, data) + where(seed, f));
    });
}

// The largest control point of the derivative, of differences over `shortest` at least.
double slope_over(const SplineData &data, double shortest) {
    const int p = data.degrees[0];
    double largest = 0;
    for (int64_t i = 0; i + 1 < data.counts[0]; ++i) {
        const auto at = static_cast<size_t>(i);
        const double length = data.knots[0][at + static_cast<size_t>(p) + 1] - data.knots[0][at + 1];
        for (int c = 0; c < data.dim && length >= shortest; ++c) {
            largest =
                std::max(largest, p * std::fabs(data.coordinate(i + 1, c) - data.coordinate(i, c)) / length);
        }
    }
    return largest;
}

// A polynomial curve over [0, 3] with `copies` knots within a few ulps of 1 and of 2, some of them equal.
SplineData clustered(Random &random, int p) {
    SplineData data;
    data.degrees = {p};
    data.dim = 1;
    std::vector<double> &knots = data.knots.emplace_back(static_cast<size_t>(p) + 1, 0);
    for (double knot : {1.0, 2.0}) {
        for (int copies = random.whole(0, p + 2), times = 0; copies > 0; --copies) {
            const bool next = times > p || random.chance(60);
            knot = next ? std::nextafter(knot, 3) : knot;
            times = next ? 1 : times + 1;
            knots.push_back(knot);
        }
    }
    knots.insert(knots.end(), static_cast<size_t>(p) + 1, 3);
    data.counts = {static_cast<int64_t>(knots.size()) - p - 1};
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return data;
}

// What a value of f in a long span, exact at its ends, is known to, and what that comes to in g; twice, as f
// may stand for a knot from either side.
double allowed_over(const SplineData &g, const SplineData &f, double shortest) {
    const double t = std::max(std::fabs(f.lower(0)), std::fabs(f.upper(0)));
    const double known =
        static_cast<double>(eps) * (4 * (f.degrees[0] + 1) * largest_point(f) + t * slope_over(f, shortest));
    return 2 * (3 * static_cast<double>(eps) * largest_point(g) + known * slope_over(g, shortest));
}

void expect_composed_at(const SplineData &g, const SplineData &f, const SplineData &h, double t, double bound,
                        WorstErrors &worst, const std::string &place) {
    const Point want = value_at(g, value_at(f, {reference::exact(t)}));
    const Point got = value_at(h, {reference::exact(t)});
    const double error = size_of(got[0] - want[0]);
    if (error != 0) {
        worst.add(h.degrees[0], error / bound, error / bound);
    }
    ASSERT_LE(error, bound) << place << " at " << hex(t);
}

TEST(Compose, knots_may_be_nearer_to_each_other_than_values_are_known) {
    WorstErrors worst("curves over clusters of knots by degree, unit the bound");
    for_each_case(991000, 500, [&](Random &random, uint64_t seed) {
        const SplineData g = clustered(random, random.whole(1, 4));
        const SplineData f = diagonal(1, random.whole(1, 3), 0, 3);
        const SplineData h = read_back(compose(create(g).get(), create(f).get()).get());
        for (int span = 0; span < 3; ++span) {
            const double t = span + random.whole(1, 1023) / 1024.0;
            expect_composed_at(g, f, h, t, allowed_over(g, f, 0.5), worst, where(seed, g) + where(seed, f));
        }
    });
}

// f rises by much within an ulp, so that no crossing could be told apart there; the spans beside are not
// touched.
TEST(Compose, steep_pieces_do_not_reach_their_neighbours) {
    WorstErrors worst("curves beside steep pieces by degree, unit the bound");
    for_each_case(992000, 500, [&](Random &random, uint64_t seed) {
        const SplineData g = up_to_sixteen(random, 1, 3);
        SplineData one = g; // its first coordinate
        one.dim = 1;
        one.points.clear();
        for (int64_t i = 0; i < g.counts[0]; ++i) {
            one.points.push_back(g.coordinate(i, 0));
        }
        const int q = random.whole(1, 3);
        SplineData f;
        f.degrees = {q};
        f.dim = 1;
        f.knots = {std::vector<double>(static_cast<size_t>(q) + 1, 1000)};
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q), 1001);
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q), std::nextafter(1001.0, 1002));
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q) + 1, 1002);
        f.counts = {3 * q + 1};
        const double step = random.between(7, 8), rise = random.chance(50) ? 0.4 : random.between(0, 1);
        for (int i = 0; i <= 3 * q; ++i) {
            f.points.push_back(i <= q       ? step * i / q
                               : i <= 2 * q ? step + rise * (i - q) / q
                                            : step + rise + (16 - step - rise) * (i - 2 * q) / q);
        }
        const SplineData h = read_back(compose(create(one).get(), create(f).get()).get());
        for (int n = 0; n < 6; ++n) {
            const double t = 1000 + n % 2 + random.whole(1, 1023) / 1024.0;
            const Point u = value_at(f, {reference::exact(t)});
            if (!near_jump(one, f, u)) {
                expect_composed_at(one, f, h, t, allowed_over(one, f, 0.5), worst,
                                   where(seed, one) + where(seed, f));
            }
        }
    });
}

// Whole periods, of whole length, so that places in the first period are known exactly.
TEST(Compose, far_away_costs_and_loses_no_more_than_the_place) {
    for_each_case(993000, 100, [](Random &random, uint64_t seed) {
        const SplineData data = whole_period(random, 4);
        const double length = data.upper(0) - data.lower(0);
        const double away = std::ldexp(random.chance(50) ? -length : length, random.whole(10, 30));
        SplineData near;
        near.degrees = {1};
        near.dim = 1;
        near.counts = {2};
        near.knots = {{0, 0, 1, 1}};
        near.points = {data.lower(0) + length / 4, data.lower(0) + length};
        SplineData far = near;
        far.points = {near.points[0] + away, near.points[1] + away};
        const auto g = create(data);
        const auto got = read_back(compose(g.get(), create(far).get()).get());
        const auto want = read_back(compose(g.get(), create(near).get()).get());
        ASSERT_EQ(got.counts[0], want.counts[0]) << where(seed, data);
        for (size_t i = 0; i < want.points.size(); ++i) {
            ASSERT_NEAR(got.points[i], want.points[i],
                        static_cast<double>(eps) *
                            (16 * std::fabs(away) * largest_slope(data, 0) + 4 * largest_point(data)))
                << where(seed, data) << hex(far.points);
        }
    });
}

// Steps: a composition of degree 0 has the values of g at those of f.
TEST(Compose, of_degree_0_steps_from_value_to_value) {
    SplineData g;
    g.degrees = {1, 1};
    g.dim = 1;
    g.counts = {2, 2};
    g.knots = {{0, 0, 1, 1}, {0, 0, 1, 1}};
    g.points = {0, 1, 2, 4};
    SplineData f;
    f.degrees = {0};
    f.dim = 2;
    f.counts = {2};
    f.knots = {{0, 0.25, 1}};
    f.points = {0.25, 0.5, 0.75, 0};
    const auto h = compose(create(g).get(), create(f).get());
    EXPECT_EQ(eval(h.get(), {0.125}), eval(create(g).get(), {0.25, 0.5}));
    EXPECT_EQ(eval(h.get(), {0.5}), eval(create(g).get(), {0.75, 0}));
    g.degrees = {0, 0};
    g.knots = {{0, 0.5, 1}, {0, 0.5, 1}};
    f.degrees = {1};
    f.knots = {{0, 0, 1, 1}};
    f.points = {0.25, 0.25, 0.75, 0.75};
    const auto steps = compose(create(g).get(), create(f).get());
    EXPECT_EQ(eval(steps.get(), {0.25}), std::vector{0.0});
    EXPECT_EQ(eval(steps.get(), {0.75}), std::vector{4.0});
}

} // namespace

} // namespace compose_knots_test
