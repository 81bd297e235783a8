// Composition: g(f(t)) against exact values, knots against the continuity, laws.
#include "property/compositions.h"

namespace compose_test {

using namespace support;
using namespace support::compositions;
using reference::Rational;

namespace {

TEST(Compose, is_the_composition_at_every_point) {
    WorstErrors worst("compositions by degree, unit the bound");
    for_each_case(910000, 300, [&](Random &random, uint64_t seed) {
        const MonotoneCase given = monotone_case(random);
        const auto &[data, f] = given;
        auto g = create(data);
        if (data.rational() && random.chance(30)) {
            g = homogeneous_form(g.get());
        }
        const auto curve = create(f);
        const auto made = compose(g.get(), curve.get());
        const SplineData h = homogeneous(made.get());
        ASSERT_NO_FATAL_FAILURE(expect_frame(given, h));
        expect_composed({homogeneous(g.get()), f, h}, random, 1, worst, where(seed, data) + where(seed, f));
    });
}

SplineData wandering_curve(Random &random, const SplineData &g, int q) {
    SplineData f;
    f.degrees = {q};
    f.dim = g.axes();
    const int pieces = random.whole(1, 3);
    const bool closed = random.chance(25);
    std::vector<double> &knots = f.knots.emplace_back();
    for (int i = closed ? -q : 0; i <= (closed ? pieces + q : pieces); ++i) {
        const bool end = i == 0 || i == pieces;
        knots.insert(knots.end(),
                     closed ? 1
                     : end  ? static_cast<size_t>(q) + 1
                            : random.bits() % static_cast<size_t>(q) + 1,
                     i);
    }
    f.counts = {static_cast<int64_t>(knots.size()) - q - 1};
    f.flags = closed ? NURBS_PERIODIC : 0;
    for (int64_t i = 0; i < f.counts[0]; ++i) {
        for (int k = 0; k < f.dim; ++k) {
            const double length = g.upper(k) - g.lower(k);
            const double free = g.lower(k) + std::floor(4 * length * random.unit() + 0.5) / 4;
            f.points.push_back(closed && i >= pieces ? f.coordinate(i - pieces, k) : free);
        }
    }
    return f;
}

TEST(Compose, curves_may_touch_knot_lines_and_turn_back) {
    WorstErrors worst("curves on surfaces and in volumes by degree, unit the bound");
    for_each_case(920000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(80) ? 2 : 3;
        const SplineData data = whole_knots(random, axes, 2);
        const SplineData f = wandering_curve(random, data, random.whole(1, 3));
        const auto g = create(data), curve = create(f);
        const auto made = compose(g.get(), curve.get());
        expect_composed({homogeneous(g.get()), f, homogeneous(made.get())}, random, largest_factor(data, f),
                        worst, where(seed, data) + where(seed, f));
    });
}

// Many control points between the same three knots, whose arguments are given out in hundreds of ways; and lines, across which many
// knots of one axis lie between two of the other.
TEST(Compose, of_high_degrees_over_many_spans) {
    constexpr std::array<std::array<int, 3>, 8> degrees = {
        {{13, 2, 2}, {2, 13, 2}, {15, 0, 2}, {8, 7, 2}, {25, 4, 1}, {29, 1, 1}, {5, 5, 3}, {14, 16, 1}}};
    WorstErrors worst("high degrees of g and f, unit the bound");
    for_each_case(960000, 8, [&](Random &random, uint64_t seed) {
        const auto [p, r, q] = degrees[seed % degrees.size()];
        const SplineData data = whole_knots(random, {p, r}, 8);
        SplineData f;
        f.degrees = {q};
        f.dim = 2;
        f.knots = {std::vector<double>(static_cast<size_t>(q) + 1, 0)};
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q) + 1, 1);
        f.counts = {q + 1};
        for (int i = 0; i <= q; ++i) {
            for (int k = 0; k < 2; ++k) {
                const double place = i == 0 || i == q ? i / q : (i + random.unit() / 2) / q;
                f.points.push_back(data.lower(k) +
                                   std::floor(4 * place * (data.upper(k) - data.lower(k))) / 4);
            }
        }
        const auto g = create(data), curve = create(f);
        const auto made = compose(g.get(), curve.get());
        expect_composed({homogeneous(g.get()), f, homogeneous(made.get())}, random, 1, worst,
                        where(seed, data) + where(seed, f));
    });
}

TEST(Compose, where_f_is_exact_control_points_are_within_2_eps) {
    WorstErrors worst("points for exact f by degree, unit eps * hull");
    for_each_case(930000, 500, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data = up_to_sixteen(random, axes, axes == 1 ? 7 : 3);
        const SplineData f =
            diagonal(axes, random.whole(0, 1) + 1, 0, 16); // all its polar values are multiples of 1/4
        const SplineData h = read_back(compose(create(data).get(), create(f).get()).get());
        for (int n = 0; n < 4; ++n) {
            const double t = random.whole(0, 15) + random.unit() / 2 + 0.25; // between knots
            const Point want = value_at(data, Point(static_cast<size_t>(axes), reference::exact(t)));
            const Point got = value_at(h, {reference::exact(t)});
            for (size_t c = 0; c < want.size(); ++c) {
                const double unit = static_cast<double>(eps) * largest_point(data);
                const double error = size_of(got[c] - want[c]);
                if (error != 0) {
                    worst.add(h.degrees[0], error / unit / (2 * axes), error / unit);
                    ASSERT_LE(error, 2 * axes * unit) << where(seed, data);
                }
            }
        }
    });
}

// Knots inside occur as often as the continuity asks for, and nowhere else.
TEST(Compose, keeps_the_continuity) {
    for_each_case(940000, 400, [](Random &random, uint64_t seed) {
        const SplineData data = whole_knots(random, 1, 5);
        const int p = data.degrees[0], q = random.whole(1, std::max(1, 12 / std::max(p, 1)));
        const SplineData f = diagonal(1, q, data.lower(0), data.upper(0));
        const auto got = read_back(compose(create(data).get(), create(f).get()).get());
        std::vector<double> wanted(static_cast<size_t>(p * q) + 1, data.lower(0));
        const auto &t = data.knots[0];
        for (const double knot : t) {
            if (data.lower(0) < knot && knot < data.upper(0) &&
                std::count(wanted.begin(), wanted.end(), knot) == 0) {
                const auto copies = p * q - p + static_cast<int>(std::count(t.begin(), t.end(), knot));
                wanted.insert(wanted.end(), static_cast<size_t>(copies), knot);
            }
        }
        wanted.insert(wanted.end(), static_cast<size_t>(p * q) + 1, data.upper(0));
        ASSERT_EQ(got.knots[0].size(), wanted.size()) << where(seed, data) << " degree " << q;
        for (size_t i = 0; i < wanted.size(); ++i) { // to the last place: crossings are found from values
            ASSERT_NEAR(got.knots[0][i], wanted[i], 8 * static_cast<double>(eps) * std::fabs(wanted[i]));
        }
    });
}

TEST(Compose, with_the_identity_gives_the_same_bits) {
    for_each_case(950000, 300, [](Random &random, uint64_t seed) {
        const SplineData data = up_to_sixteen(random, 1, 9), f = diagonal(1, 1, 0, 16);
        const auto got = read_back(compose(create(data).get(), create(f).get()).get());
        ASSERT_TRUE(same_bits(got.knots[0], data.knots[0])) << where(seed, data);
        ASSERT_TRUE(same_bits(got.points, data.points)) << where(seed, data);
    });
}

// A line along an axis of the parameter plane traces the iso-curve.
TEST(Compose, with_a_line_of_the_plane_gives_the_iso_curve) {
    for_each_case(960000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = whole_knots(random, 2, 3);
        const int along = random.whole(0, 1), across = 1 - along;
        const double at =
            data.lower(across) + (data.upper(across) - data.lower(across)) * random.whole(0, 8) / 8;
        SplineData f;
        f.degrees = {1};
        f.dim = 2;
        f.counts = {2};
        f.knots = {{0, 0, 1, 1}};
        f.points = {at, at, at, at};
        f.points[static_cast<size_t>(along)] = data.lower(along);
        f.points[static_cast<size_t>(2 + along)] = data.upper(along);
        const auto g = create(data);
        const auto traced = compose(g.get(), create(f).get()), wanted = iso(g.get(), across, at);
        const double hull = largest_point(data);
        for (int n = 0; n < 5; ++n) {
            const double t = random.whole(0, 64) / 64.0;
            const auto got = eval(traced.get(), {t});
            const auto want =
                eval(wanted.get(), {data.lower(along) + (data.upper(along) - data.lower(along)) * t});
            for (size_t c = 0; c < got.size(); ++c) { // weights of a ratio of at most 100
                ASSERT_NEAR(got[c], want[c], 2e-12 * hull) << where(seed, data) << " at " << at << ", " << t;
            }
        }
    });
}

// Powers of two, so that every bit stays: models in micrometres, parameters in milliseconds.
TEST(Compose, is_scale_free) {
    for_each_case(980000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = outer_spline(random, 1, 4);
        SplineData f = parameter_curve(random, 2, 1);
        set_monotone_points(random, data, f);
        const auto got = read_back(compose(create(data).get(), create(f).get()).get());
        const Handle small = create(scaled(data, 0x1p-20, 0x1p-30)),
                     inner = create(scaled(f, 0x1p-30, 0x1p20));
        const auto back = scaled(read_back(compose(small.get(), inner.get()).get()), 0x1p20, 0x1p-20);
        ASSERT_TRUE(same_bits(got.points, back.points)) << where(seed, data) << where(seed, f);
        ASSERT_TRUE(same_bits(got.knots[0], back.knots[0])) << where(seed, data) << where(seed, f);
    });
}

} // namespace

} // namespace compose_test
