// Splines continued beyond their ends, unclamped and made periodic, against exact polynomials.
#include "property/same_shape.h"

namespace continuation_test {

using namespace support;

namespace {

using reference::Fraction;
using reference::Rational;

Rational value(const Fraction &x) {
    return Rational(x.numerator, x.denominator);
}

// Largest homogeneous coordinate.
double largest(const SplineData &data) {
    double size = 0;
    for (const double x : data.points) {
        size = std::max(size, std::fabs(x));
    }
    return size;
}

double last_span(const SplineData &data) {
    const auto &t = data.knots[0];
    const auto upper = std::lower_bound(t.begin(), t.end(), data.upper(0));
    return data.upper(0) - *(upper - 1);
}

long double error_of(const std::vector<Fraction> &got, const std::vector<Rational> &want) {
    long double worst = 0;
    for (size_t c = 0; c < want.size(); ++c) {
        const Rational difference = abs(value(got[c]) - want[c]);
        worst = std::max(worst, reference::quotient(numerator(difference), denominator(difference)));
    }
    return worst;
}

// The Taylor polynomial of the piece below t at t + step.
std::vector<Rational> taylor(const SplineData &data, std::vector<double> param, double step, int order) {
    const double t = param[0];
    const auto derivs = reference::exact_derivatives(data, order, param.data(), {true});
    std::vector<Rational> sum(derivs[0].size(), Rational(0));
    Rational factor = 1;
    for (int k = 0; k <= order; ++k) {
        std::vector<int> index(param.size(), 0);
        index[0] = k;
        const auto slot = static_cast<size_t>(slot_of(index));
        for (size_t c = 0; c < sum.size(); ++c) {
            sum[c] += factor * value(derivs[slot][c]);
        }
        factor *= (reference::exact(t + step) - reference::exact(t)) / (k + 1);
    }
    return sum;
}

Recipe calm_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe = open_recipe(random, axes, max_degree);
    recipe.weights = recipe.weights == Weights::some_zero ? Weights::moderate : recipe.weights;
    recipe.axes[0].placement = Placement::origin; // so that the end plus a step has room
    return recipe;
}

TEST(Extension, keeps_the_domain_and_goes_on_by_taylor) {
    int refused = 0, done = 0;
    for_each_case(320000, 600, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data = random_spline(random, calm_recipe(random, axes, axes == 1 ? 7 : 3));
        const Handle g = create(data);
        const int p = data.degrees[0], order = random.whole(0, p + 1);
        const double amount = last_span(data) * random.magnitude(0.01, 4);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_extend(g.get(), 0, NURBS_END, amount, order, &out);
        const Handle longer(out);
        const std::string place = where(seed, data) + hex(amount) + " order " + std::to_string(order);
        if (status == NURBS_ERROR_WEIGHT_NEGATIVE || status == NURBS_ERROR_WEIGHTS_VANISH) {
            ++refused;
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << place << last_error();
        ++done;
        const SplineData old = homogeneous(g.get()), fresh = homogeneous(out);
        const double end = data.upper(0) + amount;
        ASSERT_EQ(fresh.upper(0), end) << place;
        const int k = std::min(order, p);
        const auto times = std::count(fresh.knots[0].begin(), fresh.knots[0].end(), data.upper(0));
        const double growth = std::pow(1 + 2 * amount / last_span(data), k);
        if (std::fabs(growth - 256) > 1e-6) {
            ASSERT_EQ(times, growth <= 256 ? p - k : p) << place;
        }
        const long double bound = 16.0L * (p + 1) * reference::eps * largest(old) * growth +
                                  4 * p * reference::eps * largest(fresh);
        for (const double part : {0.0, 0.3, 0.999, 1.0}) {
            std::vector<double> param = random_params(random, data, 1);
            param[0] = data.upper(0);
            const double there = part == 1 ? end : data.upper(0) + part * amount;
            const auto want = taylor(old, param, there - data.upper(0), k);
            param[0] = there;
            ASSERT_LE(error_of(reference::exact_point(fresh, param.data()), want), bound)
                << place << hex(there);
        }
        for (int i = 0; i < 4; ++i) {
            const std::vector<double> param = random_params(random, data, 1);
            const bool left = param[0] == data.upper(0);
            const auto want = reference::exact_point(old, param.data(), {left});
            const auto got = reference::exact_point(fresh, param.data(), {left});
            std::vector<Rational> exact;
            for (const Fraction &x : want) {
                exact.push_back(value(x));
            }
            ASSERT_LE(error_of(got, exact), bound) << place << hex(param);
        }
    });
    std::printf("%d extended, %d refused for their weights\n", done, refused);
    ASSERT_GT(done, support::of_whole_run(300));
}

// However short the last span is: the library's own evaluation of the old domain, and the bits behind it.
TEST(Extension, beyond_a_short_span_leaves_the_old_domain) {
    for (const double span : {0.1, 1e-3, 1e-6, 1e-13}) {
        for (int order = 0; order <= 3; ++order) {
            const double b = 1 - span;
            const SplineData data{{3}, {6}, {{0, 0, 0, 0, 0.5, b, 1, 1, 1, 1}}, 1, {1, -2, 3, 1, -1, 2},
                                  {},  0};
            const Handle g = create(data);
            nurbs *out = nullptr;
            require_ok(nurbs_extend(g.get(), 0, NURBS_END, 1, order, &out));
            const Handle longer(out);
            const int shared = span == 0.1 && order == 1 ? 1 : 0; // 21^2 > 256
            const SplineData fresh = read_back(out);
            ASSERT_TRUE(std::equal(data.points.begin(), data.points.end() - shared, fresh.points.begin()));
            for (const double t : {0.0, 0.3, 0.75, b, b + span / 3, b + span / 2}) {
                double before = 0, after = 0;
                require_ok(nurbs_eval(g.get(), 1, &t, 0, 0, &before, 0, 0, 0));
                require_ok(nurbs_eval(out, 1, &t, 0, 0, &after, 0, 0, 0));
                ASSERT_NEAR(before, after, 3 * 256 * 32 * 0x1p-53) << span << " " << order << " " << t;
            }
        }
    }
}

TEST(Extension, of_the_start_is_that_of_the_reversed_end) {
    for_each_case(321000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, calm_recipe(random, 1, 5));
        const Handle g = create(data);
        const double amount = random.magnitude(0.01, 1) * (data.upper(0) - data.lower(0));
        nurbs *out = nullptr, *turned = nullptr, *other = nullptr, *back = nullptr;
        if (nurbs_extend(g.get(), 0, NURBS_START, amount, 1, &out) != NURBS_OK) {
            return;
        }
        const Handle longer(out);
        require_ok(nurbs_reverse(g.get(), 0, 0, &turned));
        const Handle first(turned);
        require_ok(nurbs_extend(turned, 0, NURBS_END, amount, 1, &other));
        const Handle second(other);
        require_ok(nurbs_reverse(other, 0, 0, &back));
        const Handle third(back);
        ASSERT_EQ(read_back(out).lower(0), data.lower(0) - amount) << where(seed, data);
        ASSERT_TRUE(same_bits(read_back(out).points, read_back(back).points)) << where(seed, data);
    });
}

TEST(Unclamping, keeps_the_shape_and_clamping_brings_it_back) {
    int refused = 0;
    for_each_case(322000, 500, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = calm_recipe(random, axes, axes == 1 ? 6 : 3);
        recipe.axes[0].form = KnotForm::clamped;
        recipe.axes[0].spacing = random.chance(50) ? Spacing::integers : Spacing::few_bits;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const auto flags = static_cast<uint32_t>(random.whole(0, 3));
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_unclamp(g.get(), 0, flags, &out);
        const Handle open(out);
        const std::string place = where(seed, data) + std::to_string(flags);
        if (status == NURBS_ERROR_WEIGHT_NEGATIVE || status == NURBS_ERROR_WEIGHTS_VANISH) {
            ++refused;
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << place << last_error();
        const SplineData fresh = read_back(out);
        const int p = data.degrees[0];
        const double period = data.upper(0) - data.lower(0);
        const auto n = static_cast<size_t>(data.counts[0]);
        ASSERT_TRUE(fresh.lower(0) == data.lower(0) && fresh.upper(0) == data.upper(0)) << place;
        for (int i = 1; i <= p; ++i) {
            const auto at = static_cast<size_t>(i), low = static_cast<size_t>(p);
            if ((flags & NURBS_FORM_CLAMPED_END) != 0 && low + at <= n) {
                ASSERT_EQ(fresh.knots[0][n + at], data.knots[0][low + at] + period) << place;
            }
            if ((flags & NURBS_FORM_CLAMPED_START) != 0 && n >= at + low) {
                ASSERT_EQ(fresh.knots[0][low - at], data.knots[0][n - at] - period) << place;
            }
        }
        nurbs *again = nullptr;
        require_ok(nurbs_clamp_ends(out, 0, 3, &again));
        const Handle closed(again);
        const SplineData back = homogeneous(again), old = homogeneous(g.get());
        const double size = largest(homogeneous(out));
        ASSERT_TRUE(same_bits(back.knots[0], old.knots[0])) << place;
        for (size_t i = 0; i < old.points.size(); ++i) {
            ASSERT_NEAR(back.points[i], old.points[i], 16 * (p + 1) * 0x1p-52 * size) << place;
        }
    });
    std::printf("%d refused for their weights\n", refused);
}

long double distance(const SplineData &a, const SplineData &b, const std::vector<double> &param, bool left) {
    const auto p = reference::exact_point(a, param.data(), {left});
    const auto q = reference::exact_point(b, param.data(), {left});
    long double sum = 0;
    for (size_t c = 0; c < p.size(); ++c) {
        const Rational d = value(p[c]) - value(q[c]);
        const long double x = reference::quotient(numerator(d), denominator(d));
        sum += x * x;
    }
    return std::sqrt(sum);
}

TEST(PeriodicForm, of_a_clamped_loop_is_the_loop_again) {
    int found = 0;
    for_each_case(323000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 5 : 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.axes[0] = {recipe.axes[0].degree, KnotForm::periodic, Spacing::integers, Placement::origin, 8};
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        nurbs *out = nullptr, *made = nullptr;
        require_ok(nurbs_clamp_ends(g.get(), 0, 3, &out));
        const Handle plain(out);
        double deviation = -1;
        int32_t order = -7;
        const double size = 1 + largest(data);
        const nurbs_status status = nurbs_make_periodic(out, 0, 1e-8 * size, &deviation, &order, &made);
        const Handle loop(made);
        const std::string place = where(seed, data);
        const auto seam = std::count(data.knots[0].begin(), data.knots[0].end(), data.lower(0));
        const int p = data.degrees[0];
        if (status == NURBS_ERROR_GAP) {
            ASSERT_GT(seam, p) << place << last_error(); // a jump
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << place << last_error();
        ++found;
        const SplineData fresh = read_back(made);
        ASSERT_TRUE(fresh.periodic(0)) << place;
        ASSERT_LE(deviation, 1e-8 * size) << place;
        const auto possible =
            static_cast<int>(std::min<int64_t>(p - seam, (read_back(out).counts[0] - 1) / 2));
        ASSERT_GE(order, std::min(possible, p - 1)) << place;
        ASSERT_EQ(std::count(fresh.knots[0].begin(), fresh.knots[0].end(), data.lower(0)), p - order)
            << place;
        for (int i = 0; i < 4; ++i) {
            const auto param = random_params(random, data, 1);
            const bool left = param[0] == data.upper(0);
            ASSERT_LE(distance(data, fresh, param, left), deviation + 32 * (p + 1) * 0x1p-52L * size)
                << place << hex(param);
        }
    });
    ASSERT_GT(found, support::of_whole_run(200));
}

TEST(PeriodicForm, moves_an_open_curve_within_its_bound) {
    for_each_case(324000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 5);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        nurbs *made = nullptr;
        double deviation = -1;
        int32_t order = -7;
        const nurbs_status status = nurbs_make_periodic(g.get(), 0, HUGE_VAL, &deviation, &order, &made);
        const Handle loop(made);
        const std::string place = where(seed, data);
        if (status == NURBS_ERROR_PERIODIC_KNOTS) {
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << place << last_error();
        const SplineData fresh = read_back(made);
        for (int i = 0; i < 8; ++i) {
            const auto param = random_params(random, data, 1);
            for (const bool left : {false, true}) {
                ASSERT_LE(distance(data, fresh, param, left), deviation) << place << hex(param);
            }
        }
        int32_t periodic = -1;
        require_ok(nurbs_detect_periodic(made, 0, &periodic));
        ASSERT_EQ(periodic, 1) << place;
    });
}

} // namespace

} // namespace continuation_test
